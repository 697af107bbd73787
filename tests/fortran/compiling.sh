# SPDX-License-Identifier: MIT
# Compiles and runs the bindings and their tests with the flags of a caller, in a folder for each set of flags. Read by
# the scripts of this folder, after installed.sh.

f77_alone="$folder/mgdt_f77.f90 $folder/mgdt_voronoi_f77.f90 $folder/mgdt_mesh_f77.f90 $folder/mgdt_domain_f77.f90 $folder/mgdt_periodic_f77.f90"

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
