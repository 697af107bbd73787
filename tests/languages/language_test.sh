#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests one language's binding as its users have it: installed to a prefix, found through mgdt.pc.
#
#   language_test.sh LANGUAGE SOURCE BUILD SCRATCH REFERENCE_PROGRAM OTHER_ABI_LIBRARY
#
# LANGUAGE is lua, octave, ruby or rust. BUILD is a Meson build folder of the shared library.
set -eu

language=$1
source=$(cd "$2" && pwd)
build=$(cd "$3" && pwd)
rm -rf "$4"
mkdir -p "$4"
scratch=$(cd "$4" && pwd)
reference=$(realpath "$5")
other_abi=$(realpath "$6")
here=$source/tests/languages
LC_ALL=C.UTF-8
export LC_ALL
unset MGDT_LIBRARY MGDT_LIB_DIR MGDT_ISA DESTDIR

. "$source/tests/checks.sh"
# The command must fail, within its own words, and say each of them.
refuses() { # what, words that it must say (one a line), command...
    what=$1
    words=$2
    shift 2
    if "$@" >"$log" 2>&1; then
        lose "$what: no error"
        return
    fi
    while read -r word; do
        if ! grep -qF -- "$word" "$log"; then
            lose "$what: '$word' is not said"
            return
        fi
    done <<END
$words
END
    pass "$what"
}
# ------------------------------------------------------------------------------------- a prefix

install_build() {
    meson install -C "$build" --no-rebuild --destdir "$scratch/installed" || return 1
    pc=$(find "$scratch/installed" -name mgdt.pc)
    test -f "$pc"
}
check "the build installs" install_build
[ $failed -eq 0 ] || finish
PKG_CONFIG_PATH=${pc%/mgdt.pc}
libraries=${PKG_CONFIG_PATH%/pkgconfig}
LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export PKG_CONFIG_PATH LD_LIBRARY_PATH
bindings=$(pkg-config --variable=bindings_dir mgdt)
header=$(pkg-config --variable=includedir mgdt)/mgdt/mgdt.h
mkdir -p "$scratch/reference" "$scratch/work"
check "the C interface writes its answers" "$reference" "$scratch/reference"
[ $failed -eq 0 ] || finish
cd "$scratch/work"

# What every binding that loads the library by itself says of one that is not there, or not right.
loading() { # command that loads the binding...
    refuses "no library: the error names it" "libmgdt.so.1
not found" env LD_LIBRARY_PATH= "$@"
    refuses "a wrong MGDT_LIBRARY is named, though the loader would find a library" \
        "$scratch/no such file.so
MGDT_LIBRARY" env MGDT_LIBRARY="$scratch/no such file.so" "$@"
    refuses "another ABI version is refused" "$other_abi
ABI version 2" env MGDT_LIBRARY="$other_abi" "$@"
    refuses "a library that is not mgdt is refused" "libm.so.6
is not the mgdt library" env MGDT_LIBRARY=libm.so.6 "$@"
    check "MGDT_LIBRARY alone is enough" env LD_LIBRARY_PATH= \
        MGDT_LIBRARY="$libraries/libmgdt.so.1" "$@"
    check "an empty MGDT_LIBRARY is as none" env MGDT_LIBRARY= "$@"
}

# The example's output. It prints the volume of a cube with its centre, which is 1.
example() { # command...
    check "the example runs" "$@"
    cp "$log" "$scratch/example"
    check "the example's cube is filled" \
        grep -E '^12 tetrahedra, .*volume 1(\.0)?$' "$scratch/example"
}

case $language in
lua)
    LUA_PATH="$bindings/lua/?.lua;;"
    export LUA_PATH
    check "the tests" luajit "$here/lua_test.lua" "$scratch/reference"
    check "the tests, interpreted" luajit -joff "$here/lua_test.lua" "$scratch/reference"
    example luajit "$bindings/lua/example.lua"
    loading luajit -e 'require "mgdt"'
    ;;
octave)
    # shellcheck disable=SC2046 # flags are words
    check "the gateway compiles without a warning" env \
        CFLAGS="-O1 -Wall -Wextra -Wconversion -Werror" \
        mkoctfile --mex $(pkg-config --cflags mgdt) "$bindings/octave/mgdt_mex.c" -o mgdt_mex.mex
    octave() { octave-cli --no-history --no-init-file --path "$bindings/octave" "$@"; }
    check "the tests" octave --path "$here" --eval "octave_test ('$scratch/reference')"
    example octave "$bindings/octave/example.m"
    loading octave-cli --no-history --no-init-file --path "$bindings/octave" --eval \
        'mgdt_triangulation.version ();'
    ;;
ruby)
    RUBYLIB="$bindings/ruby/lib"
    MGDT_GEMSPEC="$bindings/ruby/mgdt.gemspec"
    MGDT_HEADER=$header
    export RUBYLIB MGDT_GEMSPEC MGDT_HEADER
    check "the tests" ruby -w "$here/ruby_test.rb" "$scratch/reference"
    example ruby -w "$bindings/ruby/example.rb"
    loading ruby -e 'require "mgdt"'
    gem_has_all_files() {
        cp -r "$bindings/ruby" "$scratch/gem" && cd "$scratch/gem" &&
            HOME=$scratch gem build mgdt.gemspec &&
            tar -xOf mgdt-*.gem data.tar.gz | tar -tz >files &&
            (cd "$bindings/ruby" && find lib -type f) | grep -vxFf files >missing
        cat missing
        test -s files && test ! -s missing
    }
    check "the gem holds the library's files" gem_has_all_files
    ;;
rust)
    # The installed crates, with the tests of the source tree beside them.
    cp -r "$bindings/rust" "$scratch/crates"
    cp -r "$source/bindings/rust/mgdt/tests" "$scratch/crates/mgdt/tests"
    cd "$scratch/crates"
    MGDT_REFERENCE=$scratch/reference
    CARGO_HOME=$scratch/cargo
    CARGO_NET_OFFLINE=true
    RUSTFLAGS='-D warnings'
    export MGDT_REFERENCE CARGO_HOME CARGO_NET_OFFLINE RUSTFLAGS
    unset CARGO_TARGET_DIR
    cargo --version
    rustc --version
    check "the tests" cargo test --offline
    grep '^test ' "$log" >"$scratch/ran" || true
    sed -n 's/^test /    &/p' "$scratch/ran"
    check "all of the tests ran" test "$(grep -c ' ok$' "$scratch/ran")" -ge 15
    example cargo run --quiet --offline --example cube
    check "MGDT_LIB_DIR takes the place of pkg-config" env PKG_CONFIG_PATH= \
        MGDT_LIB_DIR="$libraries" cargo run --quiet --offline --example cube
    refuses "no library: the build says what was tried" "libmgdt was not found
MGDT_LIB_DIR is not set
pkg-config" env PKG_CONFIG_PATH= PKG_CONFIG_LIBDIR="$scratch" cargo build --offline
    refuses "a wrong MGDT_LIB_DIR is named" "MGDT_LIB_DIR is $scratch/work
libmgdt.so" env MGDT_LIB_DIR="$scratch/work" cargo build --offline
    # A library of another ABI, with all the names that the loader looks for.
    mkdir -p "$scratch/other"
    sed -n 's/^MGDT_API .*\(mgdt_[a-z0-9_]*\)(.*/int \1(void) { return 2; }/p' "$header" \
        >"$scratch/other/mgdt.c"
    check "a library of another ABI is made" ${CC:-cc} -shared -fPIC -o \
        "$scratch/other/libmgdt.so.1" "$scratch/other/mgdt.c" \
        "-Wl,--version-script=$source/src/mgdt.map"
    refuses "another ABI version is refused" "ABI version 2" env \
        LD_LIBRARY_PATH="$scratch/other" "$scratch/crates/target/debug/examples/cube"
    ;;
*)
    echo "no such language: $language" >&2
    exit 2
    ;;
esac
conclude
