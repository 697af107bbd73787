#!/bin/sh
# SPDX-License-Identifier: MIT
# Uses the installed Fortran bindings as a user does: by pkg-config, compiled with the caller's flags.
#
#   fortran_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

. "$(dirname "$0")/installed.sh"

# ------------------------------------------------------------------------------ what is installed

installed_whole() { # all sources, and nothing that a compiler made
    ls "$folder"
    for file in $module_sources $f77_sources "$folder/mgdt_f77.inc" "$folder/examples/poisson.f" \
        "$folder/examples/adaptive.f90"; do
        test -f "$file" || return 1
    done
    test -z "$(find "$scratch/root" -name '*.mod' -o -name '*.smod' -o -name '*.o')"
}

headers="$source/include/mgdt/mgdt.h $source/include/mgdt/mgdt_voronoi.h $source/include/mgdt/mgdt_domain.h
    $source/include/mgdt/mgdt_periodic.h"

# Every function of the C interface is bound, and every bound name is one of them.
header_names() {
    sed -n 's/^MGDT_API.*[ *]\(mgdt_[a-z0-9_]*\)(.*/\1/p' $headers | sort -u
}
bound_names() {
    sed -n "s/.*bind(c, name='\(mgdt_[a-z0-9_]*\)').*/\1/p" "$folder/mgdt_c.f90" | sort -u
}
same_names() {
    header_names >"$scratch/header" && bound_names >"$scratch/bound"
    test "$(wc -l <"$scratch/header")" -eq "$(cat $headers | grep -c ^MGDT_API)" &&
        diff "$scratch/header" "$scratch/bound"
}

# Every value of its enumerations has a name in both interfaces, which says the same number. Lists
# of "name value", the names as in the header.
header_values() {
    sed -n 's/^ *\(MGDT_[A-Z0-9_]*\) = \([0-9]*\).*/\1 \2/p' $headers | sort
}
module_values() {
    sed -n 's/.*parameter :: \(mgdt_[a-z0-9_]*\) = \([0-9]*\).*/\1 \2/p' \
        "$folder/mgdt_constants.f90" | tr 'a-z' 'A-Z' | sort
}
f77_values() {
    sed -n 's/^ *PARAMETER (MG[A-Z0-9]* = \([0-9]*\)) ! \(MGDT_[A-Z0-9_]*\)$/\2 \1/p' \
        "$folder/mgdt_f77.inc" | sort
}
same_values() { # list
    header_values >"$scratch/header" && "$1" >"$scratch/bound"
    test "$(wc -l <"$scratch/header")" -gt 40 && diff "$scratch/header" "$scratch/bound"
}
# Whether a program that uses the module, or includes the file, can name them all.
module_program_of_values() {
    echo 'program values; use mgdt; implicit none'
    header_values | sed 's/\(.*\) \(.*\)/if (\1 \/= \2) stop 1/'
    echo 'end program'
}
f77_program_of_values() {
    echo 'program values; implicit none; include "mgdt_f77.inc"'
    sed -n 's/^ *PARAMETER (\(MG[A-Z0-9]*\) = \([0-9]*\)).*/if (\1 \/= \2) stop 1/p' \
        "$folder/mgdt_f77.inc"
    echo 'end program'
}
all_values_are_named() { # program, flags
    "$1" >"$scratch/values.f90"
    test "$(grep -c 'stop 1' "$scratch/values.f90")" -eq "$(header_values | wc -l)" &&
        sed -i 's/; /\n/g' "$scratch/values.f90" &&
        (cd "$scratch/debug" && $FC -fsyntax-only $cflags "$scratch/values.f90")
}

f77_alone="$folder/mgdt_f77.f90 $folder/mgdt_voronoi_f77.f90 $folder/mgdt_domain_f77.f90 $folder/mgdt_periodic_f77.f90"

# Subroutines for FORTRAN 77: names of six characters, each called by the test.
f77_names() { sed -n 's/^subroutine \([a-z0-9]*\)(.*/\1/p' $f77_alone; }
short_names() {
    f77_names | grep -c . && ! f77_names | grep -vE '^mg[a-z0-9]{1,4}$' &&
        for name in $(f77_names); do
            grep -qi "CALL $name(" "$here/test_f77.f" || { echo "not tested: $name"; return 1; }
        done
}

check 'all sources are installed, no module files' installed_whole
check 'the whole C interface is bound' same_names
check 'all constants are in the module' same_values module_values
check 'all constants have names for FORTRAN 77' same_values f77_values
check 'names for FORTRAN 77' short_names

# ------------------------------------------------------------------------- compiling and running

strict='-std=f2008 -pedantic -Wall -Wextra -Wconversion -Werror'
# The old language compares reals, and an INCLUDE brings names that are not all used.
legacy='-std=legacy -Wall -Wextra -Werror -Wno-compare-reals -Wno-unused-parameter'
debug='-O1 -g -fcheck=bounds,do,mem,pointer'
traps='-Ofast -ffpe-trap=invalid,zero,overflow'

# Flags that belong to the language and the calls go to the sources and their users alike.
bindings() { # set, flags, sources
    mkdir -p "$scratch/$1"
    # shellcheck disable=SC2086 # flags and sources are words
    (cd "$scratch/$1" && $FC $strict $2 -c $3)
}
program() { # set, flags, program, sources...
    set_name=$1
    flags=$2
    name=$3
    shift 3
    # shellcheck disable=SC2086
    (cd "$scratch/$set_name" && $FC $flags $cflags "$@" ./mgdt*.o $libs -o "$name")
}
run() { # set, program, arguments...
    (cd "$scratch/$1" && name=$2 && shift 2 && timeout 300 "./$name" "$@")
}
helper() { # C file
    # shellcheck disable=SC2086
    $CC -std=c99 -D_POSIX_C_SOURCE=200809L -O1 -Wall -Wextra -Werror $cflags -c "$here/$1.c" -o "$scratch/$1.o"
}
module_program() { # set, flags, test, helper object or nothing
    program "$1" "$strict $2" "$3" "$here/checks.f90" "$here/$3.f90" ${4:+"$scratch/$4.o"}
}

for file in counting environment overflow spy; do
    check "helper $file.c" helper $file
done

module_tests() { # set, flags
    check "the bindings with $2" bindings "$1" "$2" \
        "$parts_sources $folder/mgdt_f77_support.f90 $f77_alone"
    for test in test_arrays test_parts test_voronoi test_domain test_periodic test_layouts test_points test_queries test_errors \
        test_life:counting test_no_copies:spy test_overflow_module:overflow; do
        name=${test%:*}
        object=${test#"$name"}
        check "$name compiles with $2" module_program "$1" "$2" "$name" "${object#:}"
        check "$name runs with $2" run "$1" "$name"
    done
}
covered="$debug --coverage"
module_tests debug "$covered"
module_tests long '-O2 -fdefault-integer-8'
module_tests fast "$traps"

# Each procedure of the module has run at least once in the first set; names with three underscores
# are the compiler's own.
all_have_run() {
    (cd "$scratch/debug" && gcov --function-summaries mgdt.gcda mgdt_*.gcda) >"$scratch/gcov" || return 1
    awk -v want=60 '
        /^Function/ { name = $2; n += name ~ /mgdt/ }
        /^Lines executed:0.00%/ && name ~ /mgdt/ && name !~ /f77|___|_mg[a-z]*_|^.mg[a-z]*_.$/ { print name; bad = 1 }
        { if (!/^Function/) name = "" }
        END { print n " procedures"; exit bad || n < want }' "$scratch/gcov"
}
check 'every procedure of the module has run' all_have_run

check 'a program can name all constants of the module' all_values_are_named module_program_of_values
check 'and all for FORTRAN 77' all_values_are_named f77_program_of_values

check 'threads compile' program debug "$strict $covered -fopenmp" test_threads \
    "$here/checks.f90" "$here/test_threads.f90"
check 'threads run' run debug test_threads

# ---------------------------------------------------------------------------------- memory

memcheck() {
    (cd "$scratch/debug" && valgrind --quiet --error-exitcode=9 --leak-check=full \
        --errors-for-leak-kinds=definite,indirect,possible "./$1")
}
check 'no leak, nothing freed twice' memcheck test_life
check 'no leak after errors' memcheck test_errors
check 'no leak of parts' memcheck test_parts
check 'no leak of diagrams' memcheck test_voronoi
check 'no leak of domains' memcheck test_domain
check 'no leak of boxes' memcheck test_periodic

# -------------------------------------------------------------------- floating-point environment

check 'test_environment compiles plainly' module_program debug "$covered" test_environment environment
check 'test_environment compiles with traps' module_program fast "$traps" test_environment environment
check 'the plain environment' run debug test_environment plain "$scratch/plain.results"
check 'traps and flush-to-zero come back' run fast test_environment armed "$scratch/armed.results"
check 'the same results, byte for byte' cmp "$scratch/plain.results" "$scratch/armed.results"

# ------------------------------------------------------------------------- errors without stat

stops_with() { # argument, message
    if run debug test_stop "$1"; then return 1; fi
    grep -q "$2" "$log" && ! grep -q 'still running' "$log"
}
check 'test_stop compiles' module_program debug "$covered" test_stop
check 'stops: no stat' stops_with 'no stat' 'mgdt: insert: coordinate y of point 27 is NaN'
check 'stops: errmsg alone' stops_with 'errmsg alone' 'mgdt: set_index_base: .* is 2'
check 'stops: shape' stops_with shape 'xyz has extent 2 in dimension 1; it must be 3'
for what in '' ' of an array' ' of a record'; do
    check "stops: assignment$what" stops_with "assignment$what" 'cannot be copied by assignment'
done

# ----------------------------------------------------------------------------------- FORTRAN 77

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

# ------------------------------------------------------------------------------------- examples

check 'adaptive compiles' program debug "$strict $covered" adaptive "$folder/examples/adaptive.f90"
check 'adaptive runs' run debug adaptive

check 'the measurement of overhead' sh "$here/overhead.sh" 2000

conclude
