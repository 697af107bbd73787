#!/bin/sh
# SPDX-License-Identifier: MIT
# What the Fortran calls cost over the C calls, against an installed mgdt that pkg-config finds:
#
#   sh tests/fortran/overhead.sh [POINTS]        default one million, about a minute
set -eu
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
# shellcheck disable=SC2046 # flags are words
${CC:-cc} -O2 $(pkg-config --cflags mgdt) -c "$here/overhead.c"
# shellcheck disable=SC2046
${FC:-gfortran} -O2 $(pkg-config --variable=fortran_sources mgdt-fortran) "$here/checks.f90" \
    "$here/overhead.f90" overhead.o -o overhead $(pkg-config --cflags --libs mgdt-fortran)
./overhead "$@"
