# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# What a newcomer runs: `sh tests/run.sh`. The library and the program, built by g++ alone, and their
# own tests on smaller sets. Read by run.sh, whose functions and variables it uses.

need g++ meson ninja-build pkg-config binutils python3 python3-numpy libgtest-dev libboost-dev libgmp-dev \
    libcli11-dev libfmt-dev zlib1g-dev

folder=$builds/short
suites='unit api property faults cli'

# What needs more is left out, whether it is installed or not: the same tests run everywhere.
say "building in ${folder#"$root"/}"
mkdir -p "$builds"
rm -rf "$folder"
if CC=gcc CXX=g++ meson setup "$folder" "$root" -Dtests=auto -Dprogram=enabled -Dbench=enabled -Dcgal=disabled \
    -Dpeers=disabled -Dmpi=disabled -Dbindings=none -Doptimization=1 -Ddebug=false \
    -Db_ndebug=true >"$builds/setup.log" 2>&1 &&
    compile "$folder" "$suites"; then
    pass "the build with g++"
else
    tail -n 40 "$builds/setup.log" "$builds/compile.log"
    lose "the build with g++"
    finish
fi

MGDT_TEST_SMALL=1
export MGDT_TEST_SMALL
selection='--no-suite meshio --no-suite shells --no-suite compilers --no-suite once'
for suite in $suites; do selection="$selection --suite $suite"; done
# shellcheck disable=SC2086 # options are words
run short $selection

# The Python package, as far as NumPy is enough.
for name in arguments arrays growing library threads; do
    whole "python $name" env PYTHONPATH="$root/bindings/python" PYTHONDONTWRITEBYTECODE=1 \
        MGDT_SOURCE="$root" MGDT_LIBRARY="$folder/src/libmgdt.so" \
        python3 "$root/tests/python/test_$name.py"
done

cat <<'END'

Not run here, but by `sh tests/run.sh --full`:
    sets of full size                                   they take minutes
    Fortran, Lua, Octave, Ruby, Rust, the C++ header    their compilers and interpreters
    equality with CGAL, SciPy, TetGen and Qhull         those programs
    files that meshio and VTK write and read            python3-meshio, python3-vtk9
    MPI                                                 Open MPI, MPICH, mpi4py
    the documents' examples, the style, clang-tidy      Doxygen, mandoc, ShellCheck, clang
    clang++, Valgrind, Windows, arm64                   compilers and emulators
    the ABI, installed trees and packages               libabigail, CMake
and by `sh tests/run.sh --long`: sanitizers, fuzzing, coverage, other processors.
END
