#!/bin/sh
# SPDX-License-Identifier: MIT
# Uses the installed Fortran bindings of MPI as a user does: by pkg-config, with the caller's flags,
# on three ranks.
#
#   fortran_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY MPIFORT MPIEXEC
set -eu

. "$(dirname "$0")/../fortran/installed.sh"
mpifort=$4
mpiexec=$5

module_sources=$(pkg-config --variable=fortran_sources mgdt_mpi-fortran)
f77_sources=$(pkg-config --variable=f77_sources mgdt_mpi-fortran)
flags_of_c=$(pkg-config --cflags mgdt_mpi-fortran)
libs=$(pkg-config --libs mgdt_mpi-fortran)

# Every function of the C interface is bound, and every bound name is one of them.
same_names() {
    sed -n 's/^MGDT_API.*[ *]\(mgdt_[a-z0-9_]*\)(.*/\1/p' "$source/include/mgdt/mgdt_parts.h" \
        "$source/include/mgdt/mgdt_mpi.h" | grep -v '^mgdt_mpi_create$' | sort -u >"$scratch/header"
    sed -n "s/.*bind(c, name='\(mgdt_[a-z0-9_]*\)').*/\1/p" "$folder/mgdt_parts_c.f90" \
        "$folder/mgdt_mpi_c.f90" | sort -u >"$scratch/bound"
    test "$(wc -l <"$scratch/header")" -gt 10 && diff "$scratch/header" "$scratch/bound"
}
compile() { # name, flags, sources...
    name=$1
    flags=$2
    shift 2
    mkdir -p "$scratch/$name"
    # shellcheck disable=SC2086 # flags are words
    (cd "$scratch/$name" && eval "$mpifort $flags $flags_of_c" '"$@"' "-o run $libs")
}
on_ranks() { # name
    (cd "$scratch/$1" && "$mpiexec" -n 3 ./run)
}

check "all functions are bound" same_names
for kind in 4 8; do
    wide=
    [ $kind = 4 ] || wide=-fdefault-integer-8
    # The module mpi knows integers of 4 bytes alone.
    if [ $kind = 4 ]; then
        # shellcheck disable=SC2086 # sources are words
        check "the module compiles" compile module "-O1 -std=f2018 -Wall" $module_sources \
            "$here/checks.f90" "$here/../mpi/test_mpi.f90"
        check "the module on three ranks" on_ranks module
        # shellcheck disable=SC2086
        check "the example compiles" compile example -O2 $module_sources \
            "$folder/examples/poisson_mpi.f90"
        check "the example on three ranks" on_ranks example
    fi
    # shellcheck disable=SC2086
    check "FORTRAN 77 compiles with integers of $kind bytes" compile f77-$kind "-O1 $wide" \
        $f77_sources "$here/../mpi/test_mpi_f77.f"
    check "FORTRAN 77 on three ranks, integers of $kind bytes" on_ranks f77-$kind
done
conclude
