#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the tests under one of the tools that see what a test alone does not.
set -u

usage() {
    cat <<'END'
usage: sh tests/sanitize.sh [--full] [--built FOLDER] [--jobs N] TOOL [TEST...]

Builds in build-tests/ and runs the tests, or those that are named, on smaller sets. Ends with
status 0 if the tool has found nothing.

  address    AddressSanitizer and LeakSanitizer: memory that is not ours, memory that is lost
  undefined  UndefinedBehaviorSanitizer, with division by zero and conversions out of range
  thread     ThreadSanitizer: data races, locks in the wrong order
  memcheck   Valgrind's memcheck: as address, and values that were never set
  helgrind   Valgrind's Helgrind: as thread, found in another way

  --full          sets of full size; under memcheck small ones, instead of the smallest
  --built FOLDER  runs the tests of build-tests/FOLDER as it is
  --jobs N        parallel jobs (default: the number of processors)

CC and CXX choose the compiler: CC=clang CXX=clang++ sh tests/sanitize.sh undefined
END
}

known_options='full built= jobs='
full=no built=
. "$(dirname "$0")/options.sh"
MGDT_TEST_SMALL=1
export MGDT_TEST_SMALL
[ $full = no ] || unset MGDT_TEST_SMALL
[ $# -gt 0 ] || { usage >&2; exit 2; }
tool=$1
shift

: "${CC:=gcc}" "${CXX:=g++}"
export CC CXX
# CGAL, and tests that run the program from a script, are left out by the setups.
options='-Dbuildtype=debugoptimized -Dtests=enabled -Dcgal=disabled -Dprogram=enabled'
folder=$tool-${CXX##*[ /]}
setup=sanitizers
run=
case $tool in
address | undefined | thread)
    # The library is linked before the program that brings what it lacks.
    options="$options -Db_lundef=false -Db_sanitize=$tool" ;;
memcheck)
    setup=memcheck
    [ $full = no ] || setup=memcheck_larger ;;
helgrind)
    setup=helgrind
    options="$options -Dhelgrind=true" ;;
*) usage >&2; exit 2 ;;
esac
if [ "$tool" = undefined ]; then
    more='-fsanitize=float-divide-by-zero,float-cast-overflow -fno-sanitize-recover=all'
    CFLAGS=$more CXXFLAGS=$more LDFLAGS=$more
    export CFLAGS CXXFLAGS LDFLAGS
fi
# Its shadow memory needs addresses where newer kernels may put something else.
if [ "$tool" = thread ] && setarch -R true 2>/dev/null; then run='setarch -R'; fi

cd "$(dirname "$0")/.." || exit 1
mkdir -p build-tests
folder=build-tests/${built:-$folder}
build() {
    # shellcheck disable=SC2086 # options are words
    { [ -f "$folder/build.ninja" ] || meson setup "$folder" $options; } >"$folder.log" 2>&1 &&
        meson compile -C "$folder" -j "$jobs" >>"$folder.log" 2>&1
}
if [ -z "$built" ] && ! build; then
    tail -n 40 "$folder.log"
    exit 1
fi
# shellcheck disable=SC2086
exec $run meson test -C "$folder" --no-rebuild --setup $setup --num-processes "$jobs" \
    --print-errorlogs "$@"
