# SPDX-License-Identifier: MIT
# Installs the build under a scratch prefix and finds the Fortran bindings there by pkg-config. Read
# by the scripts of this folder, each with the arguments SOURCE_DIRECTORY BUILD_DIRECTORY
# SCRATCH_DIRECTORY.

source=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)
rm -rf "$3"
mkdir -p "$3"
scratch=$(cd "$3" && pwd)
here=$source/tests/fortran
: "${CC:=cc}" "${FC:=gfortran}"

. "$source/tests/checks.sh"

DESTDIR=$scratch/root meson install -C "$build" --no-rebuild --quiet >"$log" 2>&1 || {
    cat "$log"
    exit 1
}
pc=$(find "$scratch/root" -name mgdt-fortran.pc)
PKG_CONFIG_PATH=$(dirname "$pc")
LD_LIBRARY_PATH=$(dirname "$PKG_CONFIG_PATH")
export PKG_CONFIG_PATH LD_LIBRARY_PATH

folder=$(pkg-config --variable=fortran_source_dir mgdt-fortran)
module_sources=$(pkg-config --variable=fortran_sources mgdt-fortran)
parts_sources=$(pkg-config --variable=fortran_parts_sources mgdt-fortran)
f77_sources=$(pkg-config --variable=f77_sources mgdt-fortran)
cflags=$(pkg-config --cflags mgdt-fortran)
libs=$(pkg-config --libs mgdt-fortran)
