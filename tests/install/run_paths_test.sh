#!/bin/sh
# SPDX-License-Identifier: MIT
# What is installed looks for its libraries where the system does: no RPATH or RUNPATH, which would
# lead to a build directory that someone else may own one day.
#
#   run_paths_test.sh BUILD_DIRECTORY SCRATCH_DIRECTORY COMPILER NAME...
#
# The names are those of the files that have to be among what is installed.
set -u

build=$1
scratch=$2
compiler=$3
shift 3
rm -rf "$scratch"
mkdir -p "$scratch"
. "$(dirname "$0")/../checks.sh"

# A file that readelf cannot read shows no paths either.
is_for_the_loader() { LC_ALL=C readelf -hW "$1" | grep 'Type: *DYN'; }
has_run_path() { LC_ALL=C readelf -dW "$1" | grep -E '\((RPATH|RUNPATH)\)'; }
has_no_run_path() { ! has_run_path "$1"; }

check "installing" meson install -C "$build" --no-rebuild --tags runtime \
    --destdir "$scratch/installed"

for name; do
    found=false
    # shellcheck disable=SC2044 # no name has a blank in it
    for file in $(find "$scratch/installed" -type f -name "$name"); do
        found=true
        check "$name is for the loader" is_for_the_loader "$file"
        check "$name has no run path" has_no_run_path "$file"
    done
    check "$name is installed" $found
done

# Both kinds of path are seen where they are.
echo 'int main(void) { return 0; }' >"$scratch/main.c"
path_is_seen() { # enable or disable
    # shellcheck disable=SC2086 # a compiler may be several words
    $compiler -o "$scratch/$1" "$scratch/main.c" -Wl,-rpath,"$scratch" -Wl,--"$1"-new-dtags &&
        has_run_path "$scratch/$1"
}
for tags in disable enable; do
    check "a path is seen, new tags: $tags" path_is_seen $tags
done

conclude
