#!/bin/sh
# SPDX-License-Identifier: MIT
# The installed sources as build systems take them: in one file, under a sysroot, from a prefix with
# a blank in it.
#
#   sources_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

. "$(dirname "$0")/installed.sh"

# Calls what has C's name in Fortran as well, and both interfaces.
cat >"$scratch/user.f90" <<'END'
program user
    use mgdt
    implicit none
    type(mgdt_triangulation) :: t
    integer :: scheme, h(4), ierr
    call mgdt_order_scheme_from_name('brio', scheme)
    if (scheme /= mgdt_order_brio .or. mgdt_order_scheme_name(scheme) /= 'brio') error stop 1
    if (mgdt_abi_version() /= 1 .or. mgdt_version() == '') error stop 2
    if (mgdt_stat_name(mgdt_stat_rounds) == '' .or. mgdt_status_string(mgdt_ok) == '') error stop 3
    call t%set_order_scheme('brio')
    call mgnew(h, ierr)
    if (ierr == 0) call mgfree(h, ierr)
    if (ierr /= 0) error stop 4
    print '(a)', 'used'
end program
END

# ---------------------------------------------------------------------------------- in one file

f77_alone="$folder/mgdt_f77_support.f90 $folder/mgdt_f77.f90 $folder/mgdt_voronoi_f77.f90 $folder/mgdt_mesh_f77.f90 $folder/mgdt_domain_f77.f90 $folder/mgdt_periodic_f77.f90"
in_one_file() { # flags, sources
    rm -rf "$scratch/one"
    mkdir -p "$scratch/one"
    # shellcheck disable=SC2086 # flags and sources are words
    cat $2 >"$scratch/one/one.f90" && (cd "$scratch/one" && $FC $1 -c one.f90)
}
in_one_file_with_a_program() { # flags
    in_one_file "$1" "$module_sources $f77_alone $scratch/user.f90" &&
        (cd "$scratch/one" && $FC $1 one.o $libs -o user && test "$(./user)" = used)
}
for flags in '-std=f2008 -pedantic -Wall -Wextra -Wconversion -Werror' '-O2 -fdefault-integer-8'; do
    check "the module in one file with $flags" in_one_file "$flags" "$module_sources"
    check "FORTRAN 77 in one file with $flags" in_one_file "$flags" "$f77_sources"
    check "all in one file with $flags" in_one_file_with_a_program "$flags"
done

# --------------------------------------------------------------------------------- by pkg-config

# The words that the shell makes of a variable.
words() { # variable
    eval "printf '%s\n' $(pkg-config --variable="$1" mgdt-fortran)"
}
all_are_there() { # folder that they must be in, a number of files for each variable
    pkg-config --variable=fortran_sources mgdt-fortran
    for list in fortran f77; do
        words ${list}_sources >"$scratch/sources"
        words ${list}_files >"$scratch/files"
        test "$(wc -l <"$scratch/sources")" -eq "$(wc -l <"$scratch/files")" || return 1
        while read -r file; do
            case $(realpath "$file") in "$1"/*) ;; *) echo "elsewhere: $file"; return 1 ;; esac
            test -f "$file" || { echo "missing: $file"; return 1; }
        done <"$scratch/sources"
        sed 's,.*/,,' "$scratch/sources" | diff - "$scratch/files" || return 1
    done
    while read -r name; do
        test -f "$(words fortran_source_dir)/$name" || return 1
    done <"$scratch/files"
}
compile_and_run() { # folder of libmgdt
    rm -rf "$scratch/used"
    mkdir -p "$scratch/used"
    (cd "$scratch/used" &&
        eval "$FC -c $(pkg-config --variable=fortran_sources mgdt-fortran)" &&
        eval "$FC -c $(pkg-config --variable=f77_sources mgdt-fortran)" &&
        eval "$FC $(pkg-config --cflags mgdt-fortran) ../user.f90 ./mgdt*.o \
            $(pkg-config --libs mgdt-fortran) -o user" &&
        test "$(LD_LIBRARY_PATH=$1 ./user)" = used)
}
with_pkg_config() { # folder of the .pc files, sysroot, command...
    (unset PKG_CONFIG_PATH
        export PKG_CONFIG_LIBDIR="$1"
        if [ -n "$2" ]; then export PKG_CONFIG_SYSROOT_DIR="$2"; fi
        shift 2
        "$@")
}

usual=$PKG_CONFIG_PATH
libraries=$LD_LIBRARY_PATH
prefix=$(realpath "$folder/../../..")
check 'the sources where they were installed' with_pkg_config "$usual" '' all_are_there "$prefix"
check 'the sources under a sysroot' with_pkg_config "$usual" "$scratch/root" all_are_there "$prefix"
check 'a program from a sysroot' with_pkg_config "$usual" "$scratch/root" compile_and_run "$libraries"

# As from a package that says its prefix, of which the sysroot holds an image.
mkdir -p "$scratch/absolute"
for file in "$usual"/mgdt*.pc; do
    sed "s,^prefix=.*,prefix=${prefix#"$scratch/root"}," "$file" >"$scratch/absolute/${file##*/}"
done
check 'the sources of an absolute prefix under a sysroot' \
    with_pkg_config "$scratch/absolute" "$scratch/root" all_are_there "$prefix"
check 'a program of an absolute prefix under a sysroot' \
    with_pkg_config "$scratch/absolute" "$scratch/root" compile_and_run "$libraries"

blank=$scratch/"with a blank"
mkdir -p "$blank"
cp -R "$prefix" "$blank/prefix"
spaced=$blank/prefix${usual#"$prefix"}
check 'the sources of a prefix with a blank' with_pkg_config "$spaced" '' all_are_there "$blank"
check 'a program of a prefix with a blank' with_pkg_config "$spaced" '' compile_and_run "$libraries"
check 'the same under a sysroot' with_pkg_config "$spaced" "$scratch" all_are_there "$blank"

# As docs/fortran.md says.
by_cmake() {
    rm -rf "$scratch/cmake"
    mkdir -p "$scratch/cmake"
    {
        echo 'cmake_minimum_required(VERSION 3.16)'
        echo 'project(user Fortran)'
        sed -n '/^find_package(PkgConfig/,/^```/p' "$source/docs/fortran.md" | grep -v '^```'
        echo 'pkg_get_variable(F77 mgdt-fortran f77_files)'
        echo 'separate_arguments(F77)'
        echo 'list(FILTER F77 INCLUDE REGEX f77)'
        echo 'list(TRANSFORM F77 PREPEND "${MGDT_FOLDER}/")'
        echo 'add_executable(user ../user.f90 ${F77})'
        echo 'target_link_libraries(user mgdt_fortran)'
    } >"$scratch/cmake/CMakeLists.txt"
    cmake -S "$scratch/cmake" -B "$scratch/cmake/build" -DCMAKE_Fortran_COMPILER="$FC" &&
        cmake --build "$scratch/cmake/build" && test "$(LD_LIBRARY_PATH=$libraries "$scratch/cmake/build/user")" = used
}
check 'CMake' with_pkg_config "$usual" '' by_cmake
check 'CMake, a prefix with a blank' with_pkg_config "$spaced" '' by_cmake

conclude
