#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the build under a scratch prefix and uses the Fortran bindings from there as a user does:
# by pkg-config, compiled with the caller's flags.
#
#   fortran_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

source=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)
rm -rf "$3"
mkdir -p "$3"
scratch=$(cd "$3" && pwd)
here=$source/tests/fortran
: "${CC:=cc}" "${FC:=gfortran}"

passed=0
failed=0
log=$scratch/log
check() { # what, command...
    what=$1
    shift
    if "$@" >"$log" 2>&1; then
        passed=$((passed + 1))
        echo "passed: $what"
    else
        failed=$((failed + 1))
        echo "failed: $what"
        head -n 60 "$log" | sed 's/^/    /'
    fi
}

# ------------------------------------------------------------------------------ installation

DESTDIR=$scratch/root meson install -C "$build" --no-rebuild --quiet >"$log" 2>&1 || {
    cat "$log"
    exit 1
}
pc=$(find "$scratch/root" -name mgdt-fortran.pc)
PKG_CONFIG_PATH=$(dirname "$pc")
LD_LIBRARY_PATH=$(dirname "$PKG_CONFIG_PATH")
export PKG_CONFIG_PATH LD_LIBRARY_PATH

folder=$(pkg-config --variable=fortran_source_dir mgdt-fortran)
module_sources=$(pkg-config --variable=fortran_sources mgdt-fortran)
f77_sources=$(pkg-config --variable=f77_sources mgdt-fortran)
cflags=$(pkg-config --cflags mgdt-fortran)
libs=$(pkg-config --libs mgdt-fortran)

installed_whole() { # all sources, and nothing that a compiler made
    ls "$folder"
    for file in $module_sources $f77_sources "$folder/mgdt_f77.inc" "$folder/examples/poisson.f" \
        "$folder/examples/adaptive.f90"; do
        test -f "$file" || return 1
    done
    test -z "$(find "$scratch/root" -name '*.mod' -o -name '*.smod' -o -name '*.o')"
}

# Every function of the C interface is bound, and every bound name is one of them.
header_names() {
    sed -n 's/^MGDT_API.*[ *]\(mgdt_[a-z0-9_]*\)(.*/\1/p' "$source/include/mgdt/mgdt.h" | sort -u
}
bound_names() {
    sed -n "s/.*bind(c, name='\(mgdt_[a-z0-9_]*\)').*/\1/p" "$folder/mgdt_c.f90" | sort -u
}
same_names() {
    header_names >"$scratch/header" && bound_names >"$scratch/bound"
    test "$(wc -l <"$scratch/header")" -eq "$(grep -c ^MGDT_API "$source/include/mgdt/mgdt.h")" &&
        diff "$scratch/header" "$scratch/bound"
}

# And so is every value of its enumerations.
header_values() {
    sed -n 's/^ *MGDT_\([A-Z0-9_]*\) = \([0-9]*\).*/\1 \2/p' "$source/include/mgdt/mgdt.h" |
        tr 'A-Z' 'a-z' | sort
}
module_values() {
    sed -n 's/.*parameter :: mgdt_\([a-z0-9_]*\) = \([0-9]*\).*/\1 \2/p' \
        "$folder/mgdt_constants.f90" | sort
}
same_values() {
    header_values >"$scratch/header" && module_values >"$scratch/bound"
    test "$(wc -l <"$scratch/header")" -gt 40 && diff "$scratch/header" "$scratch/bound"
}

# Subroutines for FORTRAN 77: names of six characters, each called by the test.
f77_names() { sed -n 's/^subroutine \([a-z0-9]*\)(.*/\1/p' "$folder/mgdt_f77.f90"; }
short_names() {
    f77_names | grep -c . && ! f77_names | grep -vE '^mg[a-z0-9]{1,4}$' &&
        for name in $(f77_names); do
            grep -qi "CALL $name(" "$here/test_f77.f" || { echo "not tested: $name"; return 1; }
        done
}

check 'all sources are installed, no module files' installed_whole
check 'the whole C interface is bound' same_names
check 'all constants are there' same_values
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
    # shellcheck disable=SC2086 -- flags and sources are words
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
        "$module_sources $folder/mgdt_f77_support.f90 $folder/mgdt_f77.f90"
    for test in test_arrays test_points test_queries test_errors test_life:counting \
        test_no_copies:spy test_overflow_module:overflow; do
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
        /^Lines executed:0.00%/ && name ~ /mgdt/ && name !~ /f77|___|_mg[a-z]*_/ { print name; bad = 1 }
        { if (!/^Function/) name = "" }
        END { print n " procedures"; exit bad || n < want }' "$scratch/gcov"
}
check 'every procedure of the module has run' all_have_run

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

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
