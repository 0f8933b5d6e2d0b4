# Mansion as a colcon workspace on ROS 2 Jazzy: docker build -f docker/ros.Dockerfile -t mansion-ros .
FROM ros:jazzy-ros-base

SHELL ["/bin/bash", "-o", "pipefail", "-c"]

RUN apt-get update \
    && apt-get install -y --no-install-recommends libegl1 libgl1 libgl1-mesa-dri python3-pip \
    && rm -rf /var/lib/apt/lists/*

WORKDIR /workspace
COPY . src/mansion

RUN apt-get update \
    && rosdep update --rosdistro jazzy \
    && rosdep install --from-paths src --ignore-src -y \
    && rm -rf /var/lib/apt/lists/* \
    && python3 -m pip install --no-cache-dir --break-system-packages -r src/mansion/requirements/ros.txt

RUN source /opt/ros/jazzy/setup.bash && colcon build

COPY docker/ros_entrypoint.sh /mansion_entrypoint.sh
# Ubuntu's own image has a user with the id 1000, which mounted folders are usually owned by.
RUN (userdel --remove ubuntu || true) && useradd --create-home --uid 1000 mansion && mkdir /buildings && chown mansion /buildings
USER mansion
WORKDIR /buildings
VOLUME /buildings
ENTRYPOINT ["/mansion_entrypoint.sh"]
CMD ["ros2", "launch", "mansion_bringup", "mansion.launch.py"]
