#!/bin/sh
# SPDX-License-Identifier: MIT
# Meshes surfaces that others have made, and prints a table beside tetgen's.
set -u

usage() {
    cat <<'END'
usage: sh tests/models.sh [--no-install] [--only WORD] [--cdt PROGRAM] [--jobs N]

Collects some 500 surfaces from Debian and npm packages in build-tests/models, and prints what becomes of each:
its points and facets, Steiner points and processor time of `mgdt mesh`, `tetgen -p` and, if it is given, the
program of MarcoAttene/CDT. Valid surfaces have to be meshed, and the meshes to pass `mgdt mesh --check`; what
`mgdt validate` lists of the others has to be what CGAL finds. Ends with a line "N passed, N failed". Takes a
quarter of an hour on one core, the first time half an hour more.

  --no-install    install nothing; a missing package is a failure
  --only WORD     surfaces with this word in their names
  --cdt PROGRAM   a program of MarcoAttene/CDT, built elsewhere
  --jobs N        parallel jobs of the build (default: the number of processors)
END
}

known_options='no-install only= cdt= jobs='
no_install=no only='' cdt=''
. "$(dirname "$0")/options.sh"
[ $# -eq 0 ] || { usage >&2; exit 2; }
[ -z "$cdt" ] || cdt=$(realpath "$cdt")

cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
. tests/debian.sh
PATH=/usr/bin:/bin:$PATH
export PATH
unset CC CXX CFLAGS CXXFLAGS LDFLAGS
install_packages g++ meson ninja-build pkg-config python3 python3-numpy python3-meshio libcgal-dev libgmp-dev libmpfr-dev \
    libcli11-dev libfmt-dev zlib1g-dev tetgen openscad gmsh npm
if [ -n "$wanted" ]; then
    echo "missing packages: $wanted"
    printf '\n0 passed, 1 failed\n'
    exit 1
fi

folder=$root/build-tests/models
build=$folder/mgdt
mkdir -p "$folder"
fail() {
    tail -n 30 "$folder/log"
    printf 'failed: %s\n\n0 passed, 1 failed\n' "$1"
    exit 1
}
[ -f "$build/build.ninja" ] || meson setup "$build" "$root" -Dbuildtype=release -Db_ndebug=true -Dtests=disabled \
    -Dpeers=disabled -Dprogram=enabled >"$folder/log" 2>&1 || fail 'the build'
ninja -C "$build" -j "$jobs" src/cli/mgdt >"$folder/log" 2>&1 || fail 'the build'
g++ -O2 -std=c++17 tests/models/facet_pairs.cpp -o "$folder/facet_pairs" -lgmp -lmpfr >"$folder/log" 2>&1 ||
    fail 'facet_pairs'
sh tests/models/collect.sh "$folder" >"$folder/log" 2>&1 || fail 'the collection of surfaces'
grep '^not converted' "$folder/log"

set -- "$folder" "$build/src/cli/mgdt" --pairs "$folder/facet_pairs" --only "$only"
[ -n "$only" ] || set -- "$@" --least 480
[ -z "$cdt" ] || set -- "$@" --cdt "$cdt"
python3 tests/models/models.py "$@"
