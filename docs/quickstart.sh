#!/bin/sh
# SPDX-License-Identifier: MIT
#
# From a clone to a checked triangulation and a picture of it: sh docs/quickstart.sh
#
# For Debian 12 or newer (and its derivatives). Installs the packages that are missing, builds in
# build-quickstart/, and writes everything there. Run it again at will: what is done stays done.
set -eu

POINTS=200000
# What builds the library and the program, then what draws the picture.
BUILD_PACKAGES="g++ meson ninja-build pkg-config libcli11-dev libfmt-dev"
PICTURE_PACKAGES="python3-numpy python3-matplotlib"

here=$(cd "$(dirname "$0")/.." && pwd)
build=$here/build-quickstart
log=$build/quickstart.log

step() { printf '\n== %s\n' "$*"; }

fail() {
    printf '\nquickstart: %s\n' "$*" >&2
    exit 1
}

# Runs a command that says much, quietly; what it said is shown if it fails.
quietly() {
    "$@" >"$log" 2>&1 || {
        tail -n 40 "$log" >&2
        fail "this failed: $*
(its last lines are above, all of them in $log)"
    }
}

installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed'; }

started=$(date +%s)
mkdir -p "$build" || fail "cannot make the folder $build"

step "Packages: $BUILD_PACKAGES $PICTURE_PACKAGES"
command -v dpkg-query >/dev/null || fail "this script is for Debian and its derivatives.
Elsewhere, install a C++17 compiler, Meson, Ninja, pkg-config, CLI11, fmt, and for the picture
NumPy and Matplotlib for Python 3; then see README.md."
missing=
for package in $BUILD_PACKAGES $PICTURE_PACKAGES; do
    # pkg-config is a virtual package of pkgconf in later releases.
    [ "$package" = pkg-config ] && command -v pkg-config >/dev/null && continue
    installed "$package" || missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "all are installed"
else
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "as root, install:
    apt-get install --no-install-recommends$missing
and run this again."
        as_root=sudo
    fi
    echo "installing:$missing"
    export DEBIAN_FRONTEND=noninteractive
    quietly $as_root apt-get update
    # shellcheck disable=SC2086 # the list is meant to be split
    quietly $as_root apt-get install -y --no-install-recommends $missing
fi

# Debian's Python has Debian's packages; another one earlier on the PATH may not.
python=/usr/bin/python3

step "Building the library and the program in $build"
# Many files in one compilation, and without what this script does not need: half the time.
[ -f "$build/build.ninja" ] ||
    quietly meson setup "$build" "$here" --buildtype release -Dunity=on -Dunity_size=16 \
        -Dtests=disabled -Dprogram=enabled -Dmpi=disabled
quietly ninja -C "$build"
mgdt=$build/src/cli/mgdt
[ -x "$mgdt" ] || fail "the build gave no program at $mgdt"
"$mgdt" --version

cd "$build"
step "Points: the nodes of a bearing bracket's finite-element mesh, refined to $POINTS"
"$mgdt" generate machine "$POINTS" --data "$here/docs/data" -o points.npy ||
    fail "the points could not be made"

step "Triangulating them and checking the result, exactly"
"$mgdt" triangulate points.npy -o machine.vtu --stats --check 3 ||
    fail "the triangulation failed"

step "Drawing"
"$python" "$here/docs/picture.py" machine.vtu machine.png \
    --title "Nodes of a bearing bracket, refined at its oil hole" || fail "the picture failed"
for result in machine.vtu machine.png; do
    [ -s "$result" ] || fail "$build/$result is missing"
done

cat <<END

Done in $(($(date +%s) - started)) seconds. In $build:

    machine.png   the picture: look at it
    machine.vtu   the mesh: open it in ParaView
    points.npy    the points: numpy.load
    src/cli/mgdt  the program

Next, try
    cd $build
    src/cli/mgdt generate galaxy 1e6 -o galaxy.npy
    src/cli/mgdt triangulate galaxy.npy -o galaxy.vtu --stats
    src/cli/mgdt --help
    meson install -C .      (the library, its headers, mgdt.pc and the program, as root;
                             without what is for MPI)
and read README.md for the C interface.
END
