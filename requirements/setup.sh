# shellcheck shell=bash disable=SC2154
# Sourced by ../mansion: makes the virtual environment $venv from the locks of $mode and links $packages into it.

say() { printf 'mansion: %s\n' "$*" >&2; }

give_up() {
    say "$1"
    shift
    local line
    for line in "$@"; do
        printf '         %s\n' "$line" >&2
    done
    exit 1
}

# Print "3.12 /real/path/of/python" when $1 is a Python that Mansion runs on; else say on stdout what is wrong with it.
probe_python() {
    "$1" -I - 2>/dev/null <<'PYTHON'
import os, sys
version = "%d.%d" % sys.version_info[:2]
if not (3, 11) <= sys.version_info[:2] <= (3, 13):
    print("Python", version)
    sys.exit(1)
try:
    import ensurepip, venv
except ImportError:
    print("no venv module: python%s-venv" % version)
    sys.exit(1)
print(version, os.path.realpath(getattr(sys, "_base_executable", sys.executable)))
PYTHON
}

# Sets $python (its real path, so that an upgrade of the system cannot turn it into another version) and $version.
find_python() {
    local candidates=(python3 python3.13 python3.12 python3.11) candidate answer missing=()
    if [[ -n ${MANSION_PYTHON:-} ]]; then
        candidates=("$MANSION_PYTHON")
    elif [[ $mode == sourced ]]; then
        candidates=(/usr/bin/python3)
    fi
    for candidate in "${candidates[@]}"; do
        command -v "$candidate" >/dev/null || continue
        if answer=$(probe_python "$candidate"); then
            version=${answer%% *} python=${answer#* }
            return 0
        fi
        if [[ $answer == *venv* ]]; then
            missing+=("${answer##* }")
        fi
    done
    if ((${#missing[@]})); then
        give_up "Python is here, but its venv module is not. Install it and try again:" \
            "sudo apt install ${missing[0]}"
    fi
    if [[ $mode == sourced ]]; then
        give_up "ROS 2 ${ROS_DISTRO} is sourced, but /usr/bin/python3 is not Python 3.11 to 3.13." \
            "Mansion supports Jazzy and later; in a shell without ROS 2 it installs the wheels of rclpy."
    fi
    give_up "no Python 3.11, 3.12 or 3.13 found (looked for ${candidates[*]})." \
        "sudo apt install python3 python3-venv, or name one: MANSION_PYTHON=/path/to/python3.12 ./mansion ..."
}

# Check before anything is removed that $venv is ours to make.
check_place() {
    local parent
    parent=$(dirname -- "$venv")
    if [[ -n ${MANSION_VENV:-} ]]; then
        mkdir -p -- "$parent" 2>/dev/null || true
    fi
    if [[ ! -w $parent || (-d $venv && ! -w $venv) ]]; then
        give_up "cannot make the virtual environment $venv: the folder is not writable." \
            "Name another place: MANSION_VENV=\$HOME/.cache/mansion-venv ./mansion ..."
    fi
    if [[ -e $venv && ! -e $venv/.mansion-venv && -n $(ls -A -- "$venv") ]]; then
        give_up "$venv exists and was not made by this launcher; it is left alone." \
            "Remove it, or name another place with MANSION_VENV."
    fi
}

# Run pip, log everything, show one changing line on a terminal; explain a failure.
install_locks() {
    local log=$venv/setup.log total done_=0 line status
    total=$(cat -- "${locks[@]}" | grep -cE '^[A-Za-z0-9._-]+==' || true)
    say "[2/4] installing $total locked packages from ${locks[*]#"$root/"}"
    set +e
    # The locks are complete, so pip has nothing to resolve.
    "$venv/bin/python" -m pip install --require-hashes --only-binary=:all: --no-deps --no-compile --no-input \
        --disable-pip-version-check --retries 2 --progress-bar off "${locks[@]/#/--requirement=}" 2>&1 |
        tee -a -- "$log" |
        while IFS= read -r line; do
            [[ -t 2 ]] || continue
            case $line in
            "Collecting "* | "Requirement already satisfied"*)
                line=${line#Collecting } line=${line%% *}
                printf '\r\033[Kmansion:       %d/%d %s' $((++done_)) "$total" "$line" >&2
                ;;
            "Installing collected packages"*) printf '\r\033[Kmansion:       unpacking' >&2 ;;
            "Successfully installed"*) printf '\r\033[K' >&2 ;;
            esac
        done
    status=${PIPESTATUS[0]}
    set -e
    ((status == 0)) || explain_pip "$log"
}

explain_pip() {
    local log=$1
    [[ -t 2 ]] && printf '\r\033[K' >&2
    grep -E '^ *(ERROR|Expected|Got)' -- "$log" | tail -n 6 | sed 's/^/         /' >&2 || true
    if grep -qE 'DO NOT MATCH THE HASHES' -- "$log"; then
        give_up "a downloaded package differs from the lock file, so nothing of it was installed." \
            "The full log is $log"
    fi
    if grep -qE 'NewConnectionError|NameResolutionError|ConnectTimeout|ProxyError|Temporary failure in name|Network is unreachable' -- "$log"; then
        give_up "the package index cannot be reached: set-up needs the network once." \
            "Behind a proxy or a mirror, configure pip as usual (pip config, PIP_INDEX_URL). Full log: $log"
    fi
    if grep -qE 'No space left on device' -- "$log"; then
        give_up "the disk is full: the environment needs about 700 MB." "Full log: $log"
    fi
    give_up "installing the locked packages failed; run the command again to retry." "The full log is $log"
}

has_wheels() {
    [[ " ${locks[*]##*/} " == *" rclpy-$version.txt "* ]]
}

# Leave the wheels of rclpy out where the system's C library is older than the one that they are made for.
check_libc() {
    local libc
    libc=$(getconf GNU_LIBC_VERSION 2>/dev/null) || libc="glibc 0"
    if has_wheels && [[ $(printf '%s\n' 2.28 "${libc##* }" | sort -V | head -n 1) != 2.28 ]]; then
        say "      there are wheels of rclpy for glibc 2.28 and later; here is $libc: the node graph is left out"
        locks=("${locks[0]}")
    fi
}

link_packages() {
    local site=("$venv"/lib/python*/site-packages)
    say "[3/4] putting src/* on the path and compiling modules"
    printf '%s\n' "${packages[@]}" >"${site[0]}/mansion.pth"
    if has_wheels; then
        cp -- "$root/requirements/ros_wheels.py" "${site[0]}/_mansion_ros_wheels.py"
        cp -- "$root/requirements/ros_wheels_hook.py" "${site[0]}/_mansion_ros_wheels_hook.py"
        echo 'import _mansion_ros_wheels_hook' >>"${site[0]}/mansion.pth"
        "$venv/bin/python" -m _mansion_ros_wheels >>"$venv/setup.log" 2>&1 ||
            give_up "the libraries of the ROS wheels do not load on this machine:" "$(tail -n 1 -- "$venv/setup.log")" \
                "To go without the node graph: HOSTTYPE=other ./mansion ..."
    fi
    # Here rather than by pip: on all cores, without the packages' own tests, and whatever PYTHONDONTWRITEBYTECODE says.
    "$venv/bin/python" -m compileall -q -j 0 -x '/(tests?|testing/data|pip|setuptools)/' \
        "${site[0]}" "${packages[@]}" >>"$venv/setup.log" 2>&1 || true
}

warm() {
    [[ -e $root/src/mansion_bringup/mansion_bringup/warm.py ]] || return 0
    local line
    say "[4/4] compiling the kernels: most of the time; they are kept in the folders __pycache__ of src (to remove them:"
    say "      find src -name '*.nb[ic]' -delete)"
    "$venv/bin/python" -P -m mansion_bringup.warm 2>>"$venv/setup.log" </dev/null |
        while IFS= read -r line; do say "      $line"; done ||
        say "      that failed (see $venv/setup.log); the first build compiles them instead"
}

make_venv() {
    local options=()
    say "[1/4] making a virtual environment of $python (Python $version)"
    # Aside at once and then away: another set-up that looks meanwhile sees the whole of it with its mark, or nothing.
    rm -rf -- "$venv".removed.*
    mv -- "$venv" "$venv.removed.$$" 2>/dev/null || true
    rm -rf -- "$venv.removed.$$"
    mkdir -- "$venv"
    touch -- "$venv/.mansion-venv"
    if [[ $mode == sourced ]]; then
        options=(--system-site-packages)
    fi
    "$python" -m venv "${options[@]}" -- "$venv" >"$venv/setup.log" 2>&1 ||
        give_up "making the virtual environment failed:" "$(tail -n 3 -- "$venv/setup.log")"
}

check_rclpy() {
    [[ $mode == sourced ]] || return 0
    local fault
    fault=$("$python" -c 'import rclpy' 2>&1) ||
        give_up "ROS 2 ${ROS_DISTRO} is sourced, but $python cannot import its rclpy:" "${fault##*$'\n'}" \
            "Repair that installation, or use a shell without ROS 2: Mansion then installs the wheels of rclpy."
}

# Under a lock, so that two at once make one environment; the stamp, written last, makes it count.
set_up() {
    local start=$SECONDS python= version= lock locks
    check_place
    exec 9>"$venv.lock"
    if ! flock -n 9; then
        say "another ./mansion is setting up $venv; waiting for it"
        flock 9
    fi
    if is_ready; then
        exec 9>&-
        return 0
    fi
    find_python
    check_rclpy
    list_locks "$version"
    for lock in "${locks[@]}"; do
        [[ -r $lock ]] || give_up "there is no lock file $lock"
    done
    check_libc
    say "setting up $venv (first use or changed requirements; 90 s on two idle cores, minutes on busy ones)"
    make_venv
    install_locks
    link_packages
    warm
    expected_stamp "$version"
    printf '%s\n' "$stamp" >"$venv/.mansion-stamp.new"
    mv -- "$venv/.mansion-stamp.new" "$venv/.mansion-stamp"
    exec 9>&-
    say "ready after $((SECONDS - start)) s, $(du -sm -- "$venv" | cut -f 1) MB"
}
