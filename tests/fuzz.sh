#!/bin/sh
# SPDX-License-Identifier: MIT
# A round of fuzzing: builds the targets in build-fuzz/ and runs each in turn.
set -u

usage() {
    cat <<'END'
usage: sh tests/fuzz.sh [--merge] [seconds [target...]]

Builds tests/fuzz with clang, libFuzzer and the address and undefined-behaviour sanitizers in
build-fuzz/, and runs each target (or those named: api, domain, measures, mesh, parts, periodic, predicates, mesh_check, abaqus, boxes, gmsh, medit,
npy, ply, raw, surfaces, tetgen, text, vtk, vtu) for so many seconds, 60 unless said otherwise. Inputs are those of
tests/corpus/fuzz, a packed file for each target (tests/fuzz/corpus.py), and those of earlier rounds,
which stay in build-fuzz/inputs. What is found is
kept in build-fuzz/findings; then the exit status is 1.

  --merge  afterwards packs the smallest set of inputs that reaches as much into tests/corpus/fuzz

Needs clang, libclang-rt-dev (for libFuzzer), python3, meson, ninja-build, libboost-dev, libcli11-dev and
libfmt-dev, and takes up to five minutes to build the first time.
END
}

merge=no
case ${1:-} in
-h | --help) usage; exit 0 ;;
--merge) merge=yes; shift ;;
esac
seconds=${1:-60}
case $seconds in
'' | *[!0-9]*) usage >&2; exit 2 ;;
esac
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- api domain measures mesh parts periodic predicates mesh_check abaqus boxes gmsh medit npy ply raw surfaces tetgen text vtk vtu

cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
build=$root/build-fuzz
corpus=$root/tests/corpus/fuzz
unpacked=$build/corpus

if [ ! -e "$build/build.ninja" ]; then
    CC=${CC:-clang} CXX=${CXX:-clang++} meson setup "$build" "$root" -Dbuildtype=debugoptimized \
        -Db_lundef=false -Dtests=disabled -Dprogram=enabled -Dpeers=disabled -Dfuzz=enabled || exit 2
fi
binaries=
for target in "$@"; do
    binaries="$binaries tests/fuzz/${target}_fuzz"
done
# shellcheck disable=SC2086
ninja -C "$build" $binaries || exit 2

# The longest input of a target, and the bytes that one allocation may ask for.
limits() {
    case $1 in
    api) echo "-max_len=512 -malloc_limit_mb=256" ;;
    domain | measures | mesh | parts | periodic) echo "-max_len=512 -malloc_limit_mb=256" ;;
    predicates) echo "-max_len=192 -malloc_limit_mb=64" ;;
    mesh_check) echo "-max_len=128 -malloc_limit_mb=64" ;;
    *) echo "-max_len=4096 -malloc_limit_mb=64" ;;
    esac
}
dictionary() {
    [ ! -e "$root/tests/fuzz/$1.dict" ] || echo "-dict=$root/tests/fuzz/$1.dict"
}

# Packs the smallest inputs that reach what all of them reach. Those with a name stay.
merge_into_corpus() {
    target=$1
    rm -rf "$build/merged"
    mkdir -p "$build/merged"
    # shellcheck disable=SC2046
    "$build/tests/fuzz/${target}_fuzz" -merge=1 -use_counters=0 $(limits "$target") "$build/merged" \
        "$unpacked/$target" "$build/inputs/$target" >>"$build/logs/$target.log" 2>&1 || return 1
    # LibFuzzer names inputs by 40 hexadecimal digits.
    find "$unpacked/$target" -type f | grep -vE '/[0-9a-f]{40}$' |
        xargs -r -I{} cp {} "$build/merged/"
    find "$build/merged" -type f -size +2048c -delete
    python3 "$root/tests/fuzz/corpus.py" pack "$build/merged" "$corpus/$target.corpus"
}

found=no
mkdir -p "$build/logs" "$build/findings"
for target in "$@"; do
    inputs=$build/inputs/$target
    mkdir -p "$inputs"
    rm -rf "${unpacked:?}/$target"
    python3 "$root/tests/fuzz/corpus.py" unpack "$corpus/$target.corpus" "$unpacked/$target" || exit 2
    echo "== $target, $seconds s"
    # shellcheck disable=SC2046
    if "$build/tests/fuzz/${target}_fuzz" "$inputs" "$unpacked/$target" $(limits "$target") \
        $(dictionary "$target") -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 \
        -print_final_stats=1 -artifact_prefix="$build/findings/$target-" \
        >"$build/logs/$target.log" 2>&1; then
        grep -E 'number_of_executed_units|new_units_added' "$build/logs/$target.log"
        grep -E 'cov: ' "$build/logs/$target.log" | tail -n 1
        if [ $merge = yes ] && ! merge_into_corpus "$target"; then
            tail -n 20 "$build/logs/$target.log"
            found=yes
        fi
    else
        found=yes
        grep -vE '^(#[0-9]|	NEW_FUNC|INFO:)' "$build/logs/$target.log" | head -n 40
        echo "finding: $(ls -t "$build/findings" | head -n 1), in ${build#"$root"/}/findings"
    fi
done
[ $found = no ]
