#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes mgdt's packages and uses each where nothing else is.
set -u

usage() {
    cat <<'END'
usage: sh tests/packages.sh [--no-install] PACKAGE...

Makes packages in build-tests/packages from the files that git knows, and uses each in a minimal
Debian system of its own, which it makes there with debootstrap; ends with a line "N passed, N
failed". Installs the Debian packages that are missing here, as root or through sudo.

  debian   libmgdt1, libmgdt-dev, mgdt and those for MPI from docs/packaging/debian, seen by lintian;
           C and Fortran programs compiled and run, and the programs
  python   a wheel with the library inside, used where there is no compiler; the source
           distribution, installed where there is one
  source   mgdt.cpp, the library in one file: compiled by g++ and clang++, and its canonical output
           compared for each instruction set
  recipes  those for Spack, conda, vcpkg, Homebrew, Meson's wraps and the Fortran Package Manager,
           without their servers: each is read by the language it is written in, and its commands run

  --no-install  install nothing here; a missing package is a failure
END
}

known_options=no-install
no_install=no
. "$(dirname "$0")/options.sh"
[ $# -gt 0 ] || { usage >&2; exit 2; }
for name; do case $name in debian | python | source | recipes) ;; *) usage >&2; exit 2 ;; esac done

cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
. tests/debian.sh
PATH=/usr/sbin:/usr/bin:/sbin:/bin:$PATH
LC_ALL=C.UTF-8
export PATH LC_ALL
unset CC CXX CFLAGS CXXFLAGS LDFLAGS

passed=0
failed=0
work=$root/build-tests/packages
log=$work/log
mkdir -p "$work"
finish() {
    printf '\n%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
    exit
}

packages='debootstrap git'
for name; do
    case $name in
    debian) packages="$packages devscripts debhelper lintian meson ninja-build pkg-config g++ libcli11-dev libfmt-dev mpi-default-dev zlib1g-dev python3" ;;
    python) packages="$packages meson ninja-build g++ binutils python3 python3-build python3-setuptools python3-wheel python3-venv" ;;
    source) packages="$packages g++ clang python3" ;;
    recipes) packages="$packages meson ninja-build pkg-config gcc g++ gfortran cmake ruby libcli11-dev libfmt-dev libopenmpi-dev libmpich-dev python3 python3-jinja2 python3-yaml python3-numpy python3-setuptools python3-wheel python3-venv" ;;
    esac
done
# shellcheck disable=SC2086 # packages are words
install_packages $packages
[ -z "$wanted" ] || step "these packages are here: $packages" false || finish

# The files that git knows, in a folder.
sources() { # folder
    rm -rf "$1" && mkdir -p "$1" && git ls-files -z | xargs -0 cp --parents -t "$1"
}
# A minimal system of this release, with packages.
new_system() { # folder, packages...
    system=$1
    shift
    as_root rm -rf "$system"
    as_root debootstrap --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$system" &&
        in_system sh -c 'apt-get install -y --no-install-recommends "$@"' sh "$@"
}
in_system() { as_root chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
put_in_system() { as_root cp "$@" "$system/root/"; }

# ----------------------------------------------------------------------------------------- debian

build_debian() {
    version=$(sed -n '1s/.*(\(.*\)-.*/\1/p' docs/packaging/debian/changelog)
    rm -rf "$work/debian"
    sources "$work/debian/mgdt-$version" && cd "$work/debian" &&
        tar czf "mgdt_$version.orig.tar.gz" "mgdt-$version" && cd "mgdt-$version" &&
        cp -r docs/packaging/debian . && dpkg-buildpackage -us -uc
}
see_debian() {
    # These two are for whoever uploads the package: a report to close, and an address.
    lintian --allow-root --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs,bogus-mail-host "$work"/debian/*.changes &&
        [ ! -s "$log" ]
}
use_debian() {
    new_system "$work/debian-system" g++ gfortran pkg-config || return 1
    put_in_system "$work"/debian/*.deb
    in_system sh -euc '
        cd
        apt-get install -y --no-install-recommends ./mgdt_*.deb
        mgdt generate machine 1000 -o machine.npy
        apt-get install -y --no-install-recommends ./libmgdt1_*.deb ./libmgdt-dev_*.deb
        cat >first.c <<"END"
#include <mgdt/mgdt.h>
#include <stdio.h>
int main(void) {
    static const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    mgdt_triangulation* t = NULL;
    if (mgdt_create(&t) != MGDT_OK || mgdt_insert_points(t, 5, xyz) != MGDT_OK) return 1;
    printf("%d\n", (int)mgdt_tetrahedron_count(t));
    mgdt_destroy(t);
    return 0;
}
END
        gcc first.c $(pkg-config --cflags --libs mgdt) -o first
        [ "$(./first)" = 2 ]
        gcc first.c "$(pkg-config --variable=libdir mgdt)/libmgdt.a" -lstdc++ -lm -o static
        [ "$(./static)" = 2 ]
        gfortran $(pkg-config --variable=f77_sources mgdt-fortran) "$(pkg-config --variable=fortran_source_dir mgdt-fortran)/examples/poisson.f" \
            $(pkg-config --cflags --libs mgdt-fortran) -o poisson
        ./poisson
        mgdt generate uniform 1000 -o points.npy
        mgdt triangulate points.npy -o mesh.vtu --check 3

        apt-get install -y --no-install-recommends ./mgdt-mpi_*.deb
        mgdt generate uniform 20000 -o many.npy
        export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
        on_ranks() { mpirun --oversubscribe -n 2 "$@"; }
        on_ranks mgdt-mpi many.npy -o pieces.pvtu
        [ -s pieces.pvtu ]
        apt-get install -y --no-install-recommends ./libmgdt-mpi1_*.deb ./libmgdt-mpi-dev_*.deb
        cat >ranks.c <<"END"
#include <mgdt/mgdt_mpi.h>
#include <stdio.h>
int main(int argc, char** argv) {
    static const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    mgdt_parts* m = NULL;
    int64_t tetrahedra = 0;
    int rank = 0;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (mgdt_mpi_create(MPI_COMM_WORLD, &m) != MGDT_OK) return 1;
    if (rank == 0 && mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, 5, xyz, NULL) != MGDT_OK) return 1;
    if (mgdt_parts_build(m) != MGDT_OK) return 1;
    mgdt_parts_get_stat(m, MGDT_PARTS_THIS_PART, MGDT_PARTS_ALL_TETRAHEDRA, &tetrahedra);
    if (rank == 0) printf("%d\n", (int)tetrahedra);
    mgdt_parts_destroy(m);
    MPI_Finalize();
    return 0;
}
END
        mpicc ranks.c $(pkg-config --cflags --libs mgdt_mpi) -o ranks
        [ "$(on_ranks ./ranks)" = 2 ]
        apt-get remove -y libmgdt1 libmgdt-mpi1 mgdt mgdt-mpi libmgdt-dev libmgdt-mpi-dev
        for left in /usr/lib/*/libmgdt* /usr/share/mgdt /usr/include/mgdt; do
            if [ -e "$left" ]; then exit 1; fi
        done
    '
}
make_debian() {
    step "Debian packages are built" build_debian || return
    step "lintian has nothing to say" see_debian
    step "they are installed, used and removed in an empty system" use_debian
}

# ----------------------------------------------------------------------------------------- python

# Its library was made there, and not found elsewhere.
use_mgdt='
import mgdt
triangulation = mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
triangulation.check()
assert triangulation.nsimplex == 2 and "site-packages" in mgdt.library_path(), mgdt.library_path()
'
build_python() {
    sources "$work/python/mgdt" && cd "$work/python/mgdt/bindings/python" &&
        /usr/bin/python3 -m build --no-isolation --outdir "$work/python/dist" . &&
        ls "$work"/python/dist/mgdt-*-manylinux_*.whl "$work"/python/dist/mgdt-*.tar.gz
}
use_wheel() {
    new_system "$work/python-system" python3-numpy python3-venv || return 1
    put_in_system "$work"/python/dist/*.whl
    in_system sh -euc '
        cd
        if command -v gcc; then exit 1; fi
        python3 -m venv --system-site-packages environment
        environment/bin/pip install --no-index ./mgdt-*.whl
        environment/bin/python -c "$1"
    ' sh "$use_mgdt"
}
use_source_distribution() {
    put_in_system "$work"/python/dist/*.tar.gz
    in_system sh -euc '
        cd
        apt-get install -y --no-install-recommends g++ meson ninja-build binutils python3-setuptools python3-wheel
        python3 -m venv --system-site-packages other
        other/bin/pip install --no-index --no-build-isolation ./mgdt-*.tar.gz
        other/bin/python -c "$1"
    ' sh "$use_mgdt"
}
make_python() {
    rm -rf "$work/python"
    step "a wheel and a source distribution are built" build_python || return
    step "the wheel is used where there is no compiler" use_wheel || return
    step "the source distribution is built and used" use_source_distribution
}

# ----------------------------------------------------------------------------------------- source

compile_source() { # compiler
    "$1" -std=c++17 -O2 -DNDEBUG -ffp-contract=off -I "$work/source" \
        -c "$work/source/mgdt.cpp" -o "$work/source/$1.o" &&
        cc -std=c99 -D_POSIX_C_SOURCE=200809L -I "$work/source" -I . -c tests/property/canonical_hashes_test.c \
            -o "$work/source/test.o" &&
        "$1" "$work/source/test.o" "$work/source/$1.o" -lm -pthread -o "$work/source/$1"
}
make_source() {
    rm -rf "$work/source"
    step "the source in one file is written" /usr/bin/python3 docs/packaging/amalgamate.py "$work/source" || return
    for compiler in g++ clang++; do
        step "$compiler compiles it" compile_source $compiler || continue
        for isa in baseline avx2 avx512; do
            step "canonical output by $compiler, $isa or what is there" env MGDT_ISA=$isa "$work/source/$compiler"
        done
    done
}

# ---------------------------------------------------------------------------------------- recipes

make_recipes() {
    for recipe in spack conda vcpkg homebrew meson_wrap fpm; do
        step "the recipe $recipe" /usr/bin/python3 tests/recipes_test.py "$root" "$work/recipes" "Recipes.test_$recipe"
    done
}

for name; do
    echo "== $name"
    make_"$name"
    cd "$root" || exit 1
done
finish
