#!/bin/sh
# SPDX-License-Identifier: MIT
# What of src/ the tests run: lines and branches, by folder.
set -u

usage() {
    cat <<'END'
usage: sh tests/coverage.sh [--jobs N] [--report]

Builds with clang's source-based coverage in build-coverage/, runs the unit, property, api, cxx
and cli tests with each instruction set, and prints the shares of lines and branches of src/
that were run. A branch is an outcome of a condition in the source, however often it is compiled.
Leaves build-coverage/html/index.html and build-coverage/summary.txt. Ends with status 0 if all
tests pass and every line and branch of src/kernel and src/predicates is taken, or explained in
tests/not_covered.py.

  --report  only prints again what the last run found

Needs clang, llvm and libclang-rt-dev. On a processor without AVX-512 the code for it is not run.
END
}

known_options='report jobs='
report=no
. "$(dirname "$0")/options.sh"
[ $# -eq 0 ] || { usage >&2; exit 2; }

cd "$(dirname "$0")/.." || exit 1
folder=build-coverage
: "${CC:=clang}" "${CXX:=clang++}"
export CC CXX
# Those of the compiler's version.
tool() { $CXX -print-prog-name="$1"; }
profdata=$(tool llvm-profdata)
cov=$(tool llvm-cov)
if ! command -v "$profdata" >/dev/null || ! command -v "$cov" >/dev/null; then
    echo "failed: llvm-profdata or llvm-cov is not there"
    exit 1
fi

suites='unit property api cxx cli'
# What the tests of those suites run, of all that the build knows how to make.
targets() {
    meson introspect --tests --targets $folder | python3 -c '
import json, os, sys
folder, suites = os.path.abspath(sys.argv[1]), set(sys.argv[2:])
known = json.load(sys.stdin)
made = {target["id"]: target["filename"] for target in known["targets"]}
for test in known["tests"]:
    if suites & {suite.split(":")[-1] for suite in test["suite"]}:
        for name in sum((made[target] for target in test["depends"]), []):
            print(os.path.relpath(name, folder))
' $folder $suites | sort -u
}

status=0
if [ $report = no ]; then
    # Threads count too. Assertions have a branch that must not be taken, and are left out.
    # Counters are in the file itself (%c), so those of a process that is ended count too.
    CFLAGS='-fprofile-instr-generate -fcoverage-mapping -fprofile-update=atomic'
    CFLAGS="$CFLAGS -mllvm -runtime-counter-relocation"
    CXXFLAGS=$CFLAGS
    LDFLAGS=-fprofile-instr-generate
    LLVM_PROFILE_FILE=$(pwd)/$folder/profiles/%m%c.profraw
    export CFLAGS CXXFLAGS LDFLAGS LLVM_PROFILE_FILE
    # shellcheck disable=SC2046 # targets are words
    if ! { [ -f $folder/build.ninja ] ||
        meson setup $folder -Dbuildtype=plain -Doptimization=1 -Db_ndebug=true -Dtests=enabled \
            -Dcgal=disabled -Dpeers=disabled -Dprogram=enabled; } >$folder.log 2>&1 ||
        ! ninja -C $folder -j "$jobs" $(targets) >>$folder.log 2>&1; then
        tail -n 40 $folder.log
        exit 1
    fi
    mv $folder.log $folder/build.log
    rm -rf $folder/profiles
    mkdir -p $folder/profiles

    unset CFLAGS CXXFLAGS LDFLAGS
    MGDT_TEST_SMALL=1
    export MGDT_TEST_SMALL
    for isa in baseline avx2 avx512; do
        # A name that the processor does not know stands for the best that it has.
        # shellcheck disable=SC2046 # suites are words
        MGDT_ISA=$isa meson test -C $folder --no-rebuild --num-processes "$jobs" --print-errorlogs \
            --timeout-multiplier 8 --no-suite script $(printf -- '--suite %s ' $suites) || status=1
    done
    # They limit how long a process may take, which one that counts does not keep to: how they end says
    # nothing here.
    meson test -C $folder --no-rebuild --num-processes "$jobs" --timeout-multiplier 8 \
        program 'bench program' >$folder/program.log 2>&1
    # A profile that was cut short is left out.
    "$profdata" merge -sparse -failure-mode=all -o $folder/all.profdata $folder/profiles/*.profraw || exit 1
fi

set -- $folder/src/libmgdt.so
for program in $(find $folder/tests $folder/src/bench $folder/src/cli -type f -perm -u+x ! -name '*.so*' ! -name '*.sh' | sort); do
    set -- "$@" -object "$program"
done
"$cov" export -format=text -skip-expansions -instr-profile=$folder/all.profdata "$@" \
    >$folder/coverage.json 2>$folder/export.log &&
    "$cov" show -format=html -show-branches=count -show-instantiations=false -output-dir=$folder/html \
        -ignore-filename-regex='/tests/|/include/' -instr-profile=$folder/all.profdata "$@" \
        >/dev/null 2>>$folder/export.log ||
    { cat $folder/export.log; exit 1; }
python3 tests/coverage.py . $folder/coverage.json >$folder/summary.txt || status=1
cat $folder/summary.txt
exit $status
