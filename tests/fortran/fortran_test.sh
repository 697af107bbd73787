#!/bin/sh
# SPDX-License-Identifier: MIT
# Uses the installed Fortran bindings as a user does: by pkg-config, compiled with the caller's flags.
#
#   fortran_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

. "$(dirname "$0")/installed.sh"
. "$here/compiling.sh"

# ------------------------------------------------------------------------------ what is installed

installed_whole() { # all sources, and nothing that a compiler made
    ls "$folder"
    for file in $module_sources $f77_sources "$folder/mgdt_f77.inc" "$folder/examples/poisson.f" \
        "$folder/examples/adaptive.f90" "$folder/examples/stirred.f"; do
        test -f "$file" || return 1
    done
    test -z "$(find "$scratch/root" -name '*.mod' -o -name '*.smod' -o -name '*.o')"
}

headers="$source/include/mgdt/mgdt.h $source/include/mgdt/mgdt_voronoi.h $source/include/mgdt/mgdt_domain.h $source/include/mgdt/mgdt_mesh.h
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

for file in counting environment overflow spy; do
    check "helper $file.c" helper $file
done

covered="$debug --coverage"
module_tests debug "$covered"

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

# ------------------------------------------------------------------------------------- examples

check 'adaptive compiles' program debug "$strict $covered" adaptive "$folder/examples/adaptive.f90"
check 'adaptive runs' run debug adaptive

check 'the measurement of overhead' sh "$here/overhead.sh" 2000

conclude
