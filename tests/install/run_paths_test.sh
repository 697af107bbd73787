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
passed=0
failed=0
check() { # what, whether it is so
    if [ "$2" -eq 0 ]; then
        passed=$((passed + 1))
        echo "passed: $1"
    else
        failed=$((failed + 1))
        echo "failed: $1"
    fi
}

run_paths() { LC_ALL=C readelf -dW "$1" | grep -E '\((RPATH|RUNPATH)\)'; }

rm -rf "$scratch"
mkdir -p "$scratch"
meson install -C "$build" --no-rebuild --tags runtime --destdir "$scratch/installed" \
    >"$scratch/log" 2>&1
status=$?
[ $status -eq 0 ] || cat "$scratch/log"
check "installing" $status

for name; do
    found=1
    # shellcheck disable=SC2044 # no name has a blank in it
    for file in $(find "$scratch/installed" -type f -name "$name"); do
        found=0
        # A file that readelf cannot read shows no paths either.
        LC_ALL=C readelf -hW "$file" | grep -q 'Type: *DYN'
        check "$name is for the loader" $?
        if run_paths "$file"; then check "$name has no run path" 1; else check "$name has no run path" 0; fi
    done
    check "$name is installed" $found
done

# Both kinds of path are seen where they are.
echo 'int main(void) { return 0; }' >"$scratch/main.c"
for tags in disable enable; do
    # shellcheck disable=SC2086 # a compiler may be several words
    $compiler -o "$scratch/$tags" "$scratch/main.c" -Wl,-rpath,"$scratch" -Wl,--$tags-new-dtags &&
        run_paths "$scratch/$tags"
    check "a path is seen, new tags: $tags" $?
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
