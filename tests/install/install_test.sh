#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs into a scratch prefix and uses what is there as a stranger would: a C99 program through
# pkg-config against the shared library, the same against the static one, as a Meson subproject,
# documents and bindings, the Python package, and by pkg-config and CMake after the prefixes were
# moved.
#
#   install_test.sh SOURCE_DIRECTORY SCRATCH_DIRECTORY
set -eu

source=$(cd "$1" && pwd)
mkdir -p "$2"
scratch=$(cd "$2" && pwd)
here=$source/tests/install
: "${CC:=cc}"

. "$source/tests/checks.sh"

# Of the caller's, which would find other libraries and other packages.
unset PKG_CONFIG_PATH PYTHONPATH VIRTUAL_ENV

rm -rf "$scratch/prefix" "$scratch/elsewhere" "$scratch/shared" "$scratch/static" "$scratch/host"
mkdir -p "$scratch/prefix"

# Not optimised, and in few pieces: that is most of the time, and no matter here.
build_and_install() { # folder, prefix, meson options...
    folder=$scratch/$1
    prefix=$scratch/prefix/$2
    shift 2
    meson setup "$folder" "$source" --prefix "$prefix" --libdir lib --buildtype release -Doptimization=0 \
        -Dunity=on -Dunity_size=16 "$@" &&
        meson compile -C "$folder" && meson install -C "$folder" --no-rebuild
}

pkg() { # prefix, arguments...
    PKG_CONFIG_LIBDIR=$scratch/prefix/$1/lib/pkgconfig
    PKG_CONFIG_PATH=
    export PKG_CONFIG_LIBDIR PKG_CONFIG_PATH
    shift
    pkg-config "$@" mgdt
}

compile() { # output, prefix, extra pkg-config arguments
    # shellcheck disable=SC2046 # flags are words
    $CC -std=c99 -pedantic -Wall -Wextra -Werror $(pkg "$2" --cflags) -o "$scratch/$1" \
        "$here/example.c" $(pkg "$2" --libs ${3-})
}

only_the_runtime() { # file
    readelf -dW "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p' >"$scratch/needed"
    echo "needs: $(tr '\n' ' ' <"$scratch/needed")"
    test -s "$scratch/needed" &&
        ! grep -Ev '^(libstdc\+\+|libm|libgcc_s|libc|libmvec|ld-linux[-a-z0-9_]*)\.so' "$scratch/needed"
}

only_what_belongs() { # prefix: the header, the library, its .pc file and nothing of the tests
    (cd "$scratch/prefix/$1" && find . -type f -o -type l | sort) >"$scratch/files"
    cat "$scratch/files"
    grep -q '^./include/mgdt/mgdt.h$' "$scratch/files" &&
        grep -q '^./lib/pkgconfig/mgdt.pc$' "$scratch/files" &&
        ! grep -Ei 'gtest|cgal|test' "$scratch/files"
}

run_shared() { LD_LIBRARY_PATH=$scratch/prefix/shared/lib "$scratch/example-shared"; }

version_agrees() {
    header=$(sed -n 's/^#define MGDT_VERSION_[A-Z]* \([0-9]*\)$/\1/p' "$source/include/mgdt/mgdt.h" |
        paste -sd.)
    echo "header $header, pkg-config $(pkg shared --modversion)"
    test "$header" = "$(pkg shared --modversion)"
}

needs_the_library() { readelf -dW "$scratch/example-shared" | grep -q 'NEEDED.*libmgdt\.so\.1\]'; }
needs_no_library() { ! readelf -dW "$scratch/example-static" | grep -q 'NEEDED.*libmgdt'; }

check "a shared build installs" build_and_install shared shared -Dprogram=disabled
check "what is installed belongs there" only_what_belongs shared
check "libmgdt.so needs the C and C++ runtime alone" only_the_runtime \
    "$scratch/prefix/shared/lib/libmgdt.so.1"
check "a C99 program compiles through pkg-config" compile example-shared shared
check "the program finds libmgdt.so.1" needs_the_library
check "the program runs" run_shared
check "pkg-config and the header agree on the version" version_agrees

check "a static build installs" build_and_install static static -Dprogram=disabled \
    -Ddefault_library=static
check "a C99 program compiles through pkg-config --static" compile example-static static --static
check "the program holds the library" needs_no_library
check "the static program runs" "$scratch/example-static"

# As a subproject: the fallback of a dependency, with no installed copy in sight.
subproject() {
    mkdir -p "$scratch/host/subprojects"
    ln -s "$source" "$scratch/host/subprojects/mgdt"
    cp "$here/example.c" "$source"/bindings/fortran/examples/poisson.f \
        "$source"/bindings/fortran/examples/adaptive.f90 "$scratch/host/"
    cat >"$scratch/host/meson.build" <<'END'
project('host', 'c', 'fortran', default_options : ['c_std=c99', 'warning_level=3', 'werror=true'])
mgdt = dependency('mgdt', fallback : 'mgdt', default_options : ['program=disabled', 'optimization=0'])
test('example', executable('example', 'example.c', dependencies : mgdt))
lenient = ['werror=false', 'warning_level=0']
test('FORTRAN 77', executable('poisson', 'poisson.f', override_options : lenient,
                              dependencies : subproject('mgdt').get_variable('mgdt_f77_dep')))
test('Fortran', executable('adaptive', 'adaptive.f90', override_options : lenient,
                           dependencies : subproject('mgdt').get_variable('mgdt_fortran_dep')))
END
    PKG_CONFIG_LIBDIR=$scratch/nowhere
    export PKG_CONFIG_LIBDIR
    meson setup "$scratch/host/build" "$scratch/host" -Dunity=subprojects -Dunity_size=16 &&
        meson test -C "$scratch/host/build"
}
check "a Meson subproject builds and runs" subproject

. "$here/installed_files.sh"
. "$here/python_package.sh"
. "$here/moved_prefix.sh"

conclude
