#!/bin/sh
# SPDX-License-Identifier: MIT
# The FORTRAN 77 subroutines compiled with one set of flags and a program with another: what is
# noticed of kinds that differ. With flang as well where there is one.
#
#   kinds_test.sh SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY
set -eu

. "$(dirname "$0")/installed.sh"

integers=-fdefault-integer-8
reals=-fdefault-real-8

sources() { # folder, flags
    mkdir -p "$1"
    # shellcheck disable=SC2086 # flags and sources are words
    (cd "$1" && $compiler $2 -c $f77_sources)
}
prints() { # folder, flags, program, what it prints
    # shellcheck disable=SC2086
    (cd "$1" && rm -f program && $compiler $2 $cflags "$here/$3.f" ./mgdt*.o $libs -o program &&
        timeout 60 ./program >printed && echo "$4" | tr ';' '\n' | diff printed -)
}
has() { case $1 in *"$2"*) true ;; *) false ;; esac }

agree='next: no difference;odd: no difference;apart: no difference'
differ='next: kinds differ;odd: kinds differ;apart: kinds differ'

all_flags() { # compiler, flags for both
    compiler=$1
    n=0
    for ours in "$2" "$2 $integers" "$2 $reals" "$2 $integers $reals"; do
        n=$((n + 1))
        set=$scratch/$(basename "$1")-$n
        check "$1: sources with '$ours'" sources "$set" "$ours"
        for theirs in "$2" "$2 $integers" "$2 $reals" "$2 $integers $reals"; do
            same=yes
            wider=no
            if has "$ours" $integers && ! has "$theirs" $integers; then same=no wider=yes; fi
            if ! has "$ours" $integers && has "$theirs" $integers; then same=no; fi
            asked='kinds agree'
            if [ $same = no ] || has "$theirs" $reals; then asked='kinds differ'; fi
            check "$1: '$ours' asked by '$theirs': $asked" prints "$set" "$theirs" kinds_asked "$asked"
            # Where the program's integers are the longer ones, nothing shows it.
            if [ $same = yes ]; then
                check "$1: '$ours' and '$theirs' without asking" prints "$set" "$theirs" kinds_shown "$agree"
            elif [ $wider = yes ]; then
                check "$1: '$theirs' shows that it differs from '$ours'" \
                    prints "$set" "$theirs" kinds_shown "$differ"
            fi
        done
        check "$1: '$ours $integers' with 8-byte doubles" prints "$set" \
            "$ours -fdefault-real-8 -fdefault-double-8" kinds_asked 'kinds agree'
    done
}

all_flags "$FC" -O2
all_flags "$FC" '-O0 -fsanitize=address,undefined'
for flang in flang-new flang flang-new-19; do
    if command -v $flang >/dev/null; then
        all_flags $flang -O2
        break
    fi
done

conclude
