# SPDX-License-Identifier: MIT
# What is installed besides the library, and how parts are left out or go elsewhere. Read by
# install_test.sh, whose functions and variables it uses.

# Installs the shared build with other options to another place. Nothing is compiled.
stage() { # meson options...
    rm -rf "$scratch/stage"
    meson setup --reconfigure "$scratch/shared" "$source" --prefix /nowhere/mgdt "$@" &&
        meson install -C "$scratch/shared" --no-rebuild --destdir "$scratch/stage"
}
staged() { find "$scratch/stage" -type f | sed "s|^$scratch/stage/nowhere/mgdt/||" | sort; }
variable() { # file of pkg-config, variable
    PKG_CONFIG_LIBDIR=$scratch/stage/nowhere/mgdt/lib/pkgconfig pkg-config --variable="$2" "$1"
}
none_of() { # pattern
    staged
    ! staged | grep -E "$1"
}

documents_are_there() {
    python3 "$here/documents_test.py" "$source" "$scratch/prefix/shared" fortran lua octave ruby rust
}
no_documents() {
    stage -Ddocs=false && test -f "$scratch/stage/nowhere/mgdt/share/doc/mgdt/LICENSE" &&
        none_of '\.md$|doc/mgdt/(paper|data)'
}
no_bindings() {
    stage -Ddocs=true -Dbindings=none && none_of 'fortran\.pc|^share/mgdt/' &&
        test -z "$(variable mgdt bindings_dir)" &&
        python3 "$here/documents_test.py" "$source" "$scratch/stage/nowhere/mgdt"
}
some_bindings() {
    stage -Dbindings=lua,ruby && none_of '^share/mgdt/(fortran|octave|rust)|fortran\.pc' &&
        staged | grep -q '^share/mgdt/lua/mgdt\.lua$' && staged | grep -q '^share/mgdt/ruby/lib/mgdt\.rb$' &&
        python3 "$here/documents_test.py" "$source" "$scratch/stage/nowhere/mgdt" lua ruby
}
bindings_elsewhere() { # folder below the prefix
    stage -Dbindings=fortran,octave -Dbindings_dir="$1" && none_of '^share/mgdt/' &&
        test -f "$(variable mgdt bindings_dir)/octave/mgdt_mex.c" &&
        test -f "$(variable mgdt-fortran fortran_source_dir)/mgdt.f90" &&
        python3 "$here/documents_test.py" "$source" "$scratch/stage/nowhere/mgdt" fortran octave
}
bindings_outside() { # absolute folder
    stage -Dbindings=rust -Dbindings_dir="$1" && none_of '^share/mgdt/' &&
        test "$(variable mgdt bindings_dir)" = "$1" && test -f "$scratch/stage$1/rust/Cargo.toml"
}
none_is_alone() {
    stage -Dbindings=none,lua >"$scratch/refused" 2>&1 && return 1
    cat "$scratch/refused"
    grep -q 'none, or a list of languages' "$scratch/refused"
}
no_tests_unasked() {
    rm -rf "$scratch/plain"
    meson setup "$scratch/plain" "$source" -Dprogram=disabled &&
        test "$(meson introspect --tests "$scratch/plain")" = '[]' &&
        ! meson introspect --targets "$scratch/plain" | grep -F "$source/tests"
}

check "licence and documents are installed, and their links lead somewhere" documents_are_there
check "documents can be left out, the licence not" no_documents
check "bindings can be left out" no_bindings
check "some of the bindings" some_bindings
check "bindings elsewhere below the prefix" bindings_elsewhere lib/mgdt/languages
check "bindings outside of the prefix" bindings_outside /elsewhere/bindings
check "no bindings and some are a contradiction" none_is_alone
check "tests are built only where they are asked for" no_tests_unasked
