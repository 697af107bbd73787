#!/bin/sh
# SPDX-License-Identifier: MIT
# The module of the installed bindings, compiled with other flags than fortran_test.sh has: longer integers, and fast
# arithmetic with traps, which have to be there after each call.
#
#   flags_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

. "$(dirname "$0")/installed.sh"
. "$here/compiling.sh"

for file in counting environment overflow spy; do
    check "helper $file.c" helper $file
done

module_tests long '-O2 -fdefault-integer-8'
module_tests fast "$traps"

check 'the bindings without traps' bindings debug "$debug" "$parts_sources $folder/mgdt_f77_support.f90 $f77_alone"
check 'test_environment compiles plainly' module_program debug "$debug" test_environment environment
check 'test_environment compiles with traps' module_program fast "$traps" test_environment environment
check 'the plain environment' run debug test_environment plain "$scratch/plain.results"
check 'traps and flush-to-zero come back' run fast test_environment armed "$scratch/armed.results"
check 'the same results, byte for byte' cmp "$scratch/plain.results" "$scratch/armed.results"

conclude
