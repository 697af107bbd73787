# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# A change proved in minutes: what `sh tests/run.sh --quick` does. Read by run.sh, whose functions and
# variables it uses.
#
# The build is kept in build-tests/quick and brought up to date. The style, unit and API tests always
# run; the others that run are those of the folders in which files have changed since the last commit
# for which all of this passed, or since the one before the last commit, with small sets of points.

# shellcheck disable=SC2086 # packages are words
need $packages

folder=$builds/quick
stamp=$folder/passed

changed_files() {
    base=$(cat "$stamp" 2>/dev/null)
    git rev-parse --quiet --verify "$base^{commit}" >/dev/null 2>&1 || base=HEAD~1
    git diff --name-only "$base" 2>/dev/null
    git ls-files --others --exclude-standard
}

# The suites, or "=" and the names of tests, that belong to a changed file.
tests_for() {
    case $1 in
    src/bench/* | src/cli/*) echo 'cli =files' ;;
    src/*) echo 'property fuzz faults cli cxx =files' ;;
    include/*) echo 'property fuzz faults cli cxx' ;;
    bindings/interface/*) echo 'languages fortran python' ;;
    bindings/python/*) echo python ;;
    bindings/fortran/*) echo fortran ;;
    bindings/lua/*) echo '=lua' ;;
    bindings/octave/*) echo '=octave' ;;
    bindings/ruby/*) echo '=ruby' ;;
    bindings/rust/*) echo '=rust' ;;
    docs/*.md | README.md) echo "=${1##*/} =references =trust" ;;
    docs/*) echo docs ;;
    tests/bench/*) ;;
    tests/*/*) f=${1#tests/} && echo "${f%%/*}" ;;
    tests/* | *meson*) echo docs ;;
    esac
}

. tests/cache.sh
mkdir -p "$builds"
say "building in ${folder#"$root"/}"
if { [ -f "$folder/build.ninja" ] ||
    CC="$cache gcc" CXX="$cache g++" meson setup "$folder" "$root" -Dwerror=true -Dtests=enabled \
        -Dcgal=disabled -Dpeers=disabled -Dprogram=enabled -Dbench=enabled -Dbuildtype=debugoptimized \
        -Ddebug=false; } >"$builds/setup.log" 2>&1 &&
    compile "$folder" all; then
    pass "the build"
else
    tail -n 40 "$builds/setup.log" "$builds/compile.log"
    lose "the build"
    finish
fi

MGDT_TEST_SMALL=1
export MGDT_TEST_SMALL
wanted=$(changed_files | while read -r file; do tests_for "$file"; done | tr ' ' '\n' | sort -u)
suites='--suite style --suite unit --suite api'
names=
for word in $wanted; do
    case $word in
    =*) names="$names ${word#=}" ;;
    *) suites="$suites --suite $word" ;;
    esac
done
# shellcheck disable=SC2086 # suites and names are words
run quick $suites
if [ -n "$names" ]; then
    # shellcheck disable=SC2046,SC2086 # as above
    run quick $(printf '%s\n' $names | sort -u)
fi
[ "$failed" -ne 0 ] || git rev-parse --quiet --verify HEAD >"$stamp" 2>/dev/null
