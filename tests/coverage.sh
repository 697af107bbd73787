#!/bin/sh
# SPDX-License-Identifier: MIT
# What of src/ the tests run: lines and branches, by folder.
set -u

usage() {
    cat <<'END'
usage: sh tests/coverage.sh [--jobs N]

Builds with gcov in build-coverage/, runs the unit, property, api, cxx and cli tests with each
instruction set, and prints the shares of lines and branches of src/ that were run. Branches that
only exceptions take are not counted. Leaves build-coverage/html/index.html and
build-coverage/summary.txt. Ends with status 0 if all tests pass and no folder has fallen below the
floor that tests/coverage.py sets.
END
}

jobs=$(nproc 2>/dev/null || echo 2)
while [ $# -gt 0 ]; do
    case $1 in
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
folder=build-coverage
if ! command -v gcovr >/dev/null; then
    echo "failed: gcovr is not there"
    exit 1
fi
: "${CC:=gcc}" "${CXX:=g++}"
export CC CXX
# Without optimisation a branch of the source is a branch of the program. Threads count too.
if ! { [ -f $folder/build.ninja ] ||
    meson setup $folder -Dbuildtype=debug -Db_coverage=true -Dtests=enabled -Dcgal=disabled \
        -Dprogram=enabled -Dcpp_args=-fprofile-update=prefer-atomic; } >$folder.log 2>&1 ||
    ! meson compile -C $folder -j "$jobs" >>$folder.log 2>&1; then
    tail -n 40 $folder.log
    exit 1
fi
mv $folder.log $folder/build.log
find $folder -name '*.gcda' -exec rm -f {} +

status=0
MGDT_TEST_SMALL=1
export MGDT_TEST_SMALL
for isa in baseline avx2 avx512; do
    # A name that the processor does not know stands for the best that it has.
    MGDT_ISA=$isa meson test -C $folder --no-rebuild --num-processes "$jobs" --print-errorlogs \
        --timeout-multiplier 8 --suite unit --suite property --suite api --suite cxx --suite cli ||
        status=1
done

mkdir -p $folder/html
gcovr --root . --filter src/ --object-directory $folder --exclude-throw-branches \
    --exclude-unreachable-branches -j "$jobs" \
    --json $folder/coverage.json --html-details $folder/html/index.html \
    --txt $folder/files.txt $folder || exit 1
python3 tests/coverage.py $folder/coverage.json >$folder/summary.txt || status=1
cat $folder/summary.txt
exit $status
