#!/bin/sh
# SPDX-License-Identifier: MIT
# The FORTRAN 77 subroutines of the installed bindings, compiled with many sets of the caller's flags.
#
#   f77_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

. "$(dirname "$0")/installed.sh"
. "$here/compiling.sh"

check 'helper overflow.c' helper overflow

number=0
for flags in "$debug" -fdefault-integer-8 -fno-underscoring -fsecond-underscore \
    '-O2 -fdefault-integer-8 -fno-underscoring' '-O2 -fdefault-integer-8 -fsecond-underscore' \
    '-fdefault-real-8 -fdefault-double-8' "$traps" "$traps -fdefault-integer-8"; do
    number=$((number + 1))
    set=f77-$number
    check "FORTRAN 77 bindings with $flags" bindings $set "$flags" "$f77_sources"
    check "test_f77 compiles" program $set "$legacy $flags" test_f77 "$here/test_f77.f"
    check "test_f77 runs" run $set test_f77
    check "test_overflow compiles" program $set "$legacy $flags" test_overflow \
        "$here/test_overflow.f" "$scratch/overflow.o"
    check "test_overflow runs" run $set test_overflow
    check "poisson compiles" program $set "$legacy $flags" poisson "$folder/examples/poisson.f"
    check "poisson runs" run $set poisson
    check "stirred compiles" program $set "$legacy $flags" stirred "$folder/examples/stirred.f"
    check "stirred runs" run $set stirred
done

cat >"$scratch/free.f90" <<'END'
program free
    implicit none
    include 'mgdt_f77.inc'
    integer :: h(4), ierr
    call mgnew(h, ierr)
    if (ierr == mgok) call mgfree(h, ierr)
    if (ierr /= mgok) stop 1
end program
END
check 'mgdt_f77.inc in free form' program f77-1 '' free "$scratch/free.f90"
check 'and it runs' run f77-1 free

conclude
