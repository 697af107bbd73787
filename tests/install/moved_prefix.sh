# SPDX-License-Identifier: MIT
# The prefixes after a move to another place: nothing in them may know where they were made. Read
# by install_test.sh, whose functions and variables it uses.

moved=$scratch/elsewhere/with\ a\ space
rm -rf "$scratch/elsewhere"
mkdir -p "$scratch/elsewhere"

mv "$scratch/prefix" "$moved"
pkg_moved() { # shared or static, arguments...
    PKG_CONFIG_LIBDIR=$moved/$1/lib/pkgconfig
    PKG_CONFIG_PATH=
    export PKG_CONFIG_LIBDIR PKG_CONFIG_PATH
    shift
    pkg-config "$@" mgdt
}

no_text_names_the_old_place() {
    files=8
    [ ! -f "$moved/shared/lib/pkgconfig/mgdt_mpi.pc" ] || files=12
    test "$(find "$moved" -name '*.cmake' -o -name '*.pc' | wc -l)" -eq $files &&
        ! grep -rlF "$scratch/prefix" "$moved" --include='*.cmake' --include='*.pc' --include='*.h*'
}

through_pkg_config() { # shared or static, extra pkg-config arguments
    eval "$CC -std=c99 -Wall -Wextra -Werror $(pkg_moved "$1" --cflags) -o '$scratch/moved-$1' \
        '$here/example.c' $(pkg_moved "$1" --libs ${2-})" &&
        LD_LIBRARY_PATH=$moved/$1/lib "$scratch/moved-$1"
}

# A project of one language, so that C needs no C++ compiler; out of nothing but the prefix.
cmake_project() { # folder, language, source file, what find_package is given
    rm -rf "${scratch:?}/$1"
    mkdir -p "$scratch/$1"
    cp "$here/$3" "$scratch/$1/"
    cat >"$scratch/$1/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.16)
project(host $2)
find_package(mgdt $4 CONFIG REQUIRED)
find_package(mgdt CONFIG REQUIRED) # once more does no harm
message(STATUS "found mgdt \${mgdt_VERSION}")
add_executable(host $3)
if("$2" STREQUAL "CXX")
  target_compile_features(host PRIVATE cxx_std_17)
endif()
target_link_libraries(host PRIVATE mgdt::mgdt)
END
}

configure_cmake() { # folder, shared or static
    cmake -S "$scratch/$1" -B "$scratch/$1/build" -DCMAKE_PREFIX_PATH="$moved/$2" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
}

through_cmake() { # shared or static, language, source file
    cmake_project "cmake-$1-$2" "$2" "$3" 1.0
    configure_cmake "cmake-$1-$2" "$1" && cmake --build "$scratch/cmake-$1-$2/build" &&
        LD_LIBRARY_PATH="" "$scratch/cmake-$1-$2/build/host" &&
        if [ "$1" = shared ]; then
            readelf -dW "$scratch/cmake-$1-$2/build/host" | grep -q 'NEEDED.*libmgdt\.so\.1\]'
        else
            ! readelf -dW "$scratch/cmake-$1-$2/build/host" | grep -q 'NEEDED.*libmgdt'
        fi
}

fortran_through_cmake() {
    mkdir -p "$scratch/cmake-fortran"
    cp "$source"/bindings/fortran/examples/poisson.f "$source"/bindings/fortran/examples/adaptive.f90 \
        "$scratch/cmake-fortran/"
    cat >"$scratch/cmake-fortran/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.16)
project(host Fortran)
find_package(mgdt 1.3 CONFIG REQUIRED COMPONENTS fortran)
add_library(mgdt_f77 STATIC ${mgdt_F77_SOURCES})
target_link_libraries(mgdt_f77 PUBLIC mgdt::mgdt)
add_executable(poisson poisson.f)
target_include_directories(poisson PRIVATE ${mgdt_FORTRAN_DIRECTORY})
target_link_libraries(poisson PRIVATE mgdt_f77)
add_executable(adaptive adaptive.f90 ${mgdt_FORTRAN_SOURCES})
target_link_libraries(adaptive PRIVATE mgdt::mgdt)
END
    configure_cmake cmake-fortran shared && cmake --build "$scratch/cmake-fortran/build" &&
        "$scratch/cmake-fortran/build/poisson" && "$scratch/cmake-fortran/build/adaptive"
}

refused_by_cmake() { # what find_package is given, a word of the reason
    cmake_project cmake-refused C example.c "$1"
    configure_cmake cmake-refused shared >"$scratch/refused" 2>&1 && return 1
    cat "$scratch/refused"
    grep -q "$2" "$scratch/refused"
}
found_by_cmake() { # what find_package is given
    cmake_project cmake-found C example.c "$1"
    configure_cmake cmake-found shared
}

library_lost() {
    mv "$moved/shared/lib/libmgdt.so.1.4.0" "$scratch/lost"
    refused_by_cmake 1.0 'is missing'
    status=$?
    mv "$scratch/lost" "$moved/shared/lib/libmgdt.so.1.4.0"
    return $status
}

check "no installed text names the prefix" no_text_names_the_old_place
check "moved: pkg-config, shared" through_pkg_config shared
check "moved: pkg-config, static" through_pkg_config static --static
for kind in shared static; do
    check "moved: CMake, C, $kind" through_cmake $kind C example.c
    check "moved: CMake, C++, $kind" through_cmake $kind CXX example.cpp
done
check "moved: CMake, Fortran" fortran_through_cmake
for version in '' 1 1.0.0 1.1 1.2 1.3 1.4 '1.4.0 EXACT' 1.0...1.9 1.0...2; do
    check "CMake finds '$version'" found_by_cmake "$version"
done
for version in 0.9 1.5 2.0 1.5...1.9 '1.0.0 EXACT' '1.0...<1.4.0' 0.5...1.5; do
    check "CMake refuses version $version" refused_by_cmake "$version" 'version'
done
check "CMake refuses a component" refused_by_cmake '1.0 COMPONENTS solver' 'no component solver'
check "CMake says what is missing" library_lost
