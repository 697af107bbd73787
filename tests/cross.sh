#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds for another system or processor and runs the tests there, in an emulator.
set -u

usage() {
    cat <<'END'
usage: sh tests/cross.sh [--short] [--no-install] [--jobs N] TARGET

Builds in build-tests/cross-TARGET with Debian's cross compiler and runs the unit, property and API
tests and those of the C++ header, on smaller sets, and for Windows those of the program and of
Fortran; ends with a line "N passed, N failed". Installs
the Debian packages that are missing (as root or through sudo).

  windows  x86-64, with MinGW-w64, in Wine
  aarch64  64-bit ARM, in QEMU
  riscv64  64-bit RISC-V, in QEMU
  s390x    IBM Z, which is big-endian, in QEMU
  i386     32-bit x86 with SSE2, on a processor that has it

  --short       the library and the hashes of canonical output alone
  --no-install  install nothing; a missing package is a failure
  --jobs N      parallel jobs (default: the number of processors)
END
}

known_options='short no-install jobs='
short=no no_install=no
. "$(dirname "$0")/options.sh"
[ $# -eq 1 ] || { usage >&2; exit 2; }
target=$1

cd "$(dirname "$0")/.." || exit 1
root=$(pwd)
. tests/debian.sh
. tests/cache.sh
PATH=/usr/bin:/bin:$PATH
LC_ALL=C.UTF-8
MGDT_TEST_SMALL=1
WINEDEBUG=-all
export PATH LC_ALL MGDT_TEST_SMALL WINEDEBUG
unset CC CXX CFLAGS CXXFLAGS LDFLAGS

# What there is of each: the compiler's prefix and suffix, its package, the emulator, the processor.
suffix=
arguments=
system=linux
endian=little
emulator_package=qemu-user
more_packages=
libraries=
case $target in
windows)
    prefix=x86_64-w64-mingw32
    suffix=-posix
    compiler_package=g++-mingw-w64-x86-64-posix
    emulator_package='wine wine64'
    [ $short = yes ] || more_packages='libcli11-dev libfmt-dev libz-mingw-w64-dev gfortran-mingw-w64-x86-64-posix python3-meshio python3-vtk9 python3-numpy'
    emulator=wine
    system=windows
    family=x86_64
    ;;
aarch64 | riscv64 | s390x)
    prefix=$target-linux-gnu
    family=$target
    [ "$target" != s390x ] || endian=big
    ;;
i386)
    prefix=i686-linux-gnu
    family=x86
    arguments="'-msse2', '-mfpmath=sse'"
    emulator_package=
    ;;
*) usage >&2; exit 2 ;;
esac
if [ $system = linux ]; then
    compiler_package=g++-$prefix
    emulator=qemu-$target
    libraries=", '-L', '/usr/$prefix'"
fi
# QEMU's i386 loses wake-ups of threads.
if [ "$target" = i386 ]; then
    emulator=/usr/$prefix/lib/ld-linux.so.2
    libraries=", '--library-path', '/usr/$prefix/lib'"
fi

lose() { # why
    printf 'failed: %s\n\n0 passed, 1 failed\n' "$1"
    exit 1
}

# Headers of the tests' libraries are the same for all; GoogleTest is compiled from its sources.
packages="meson ninja-build pkg-config python3 libgtest-dev libboost-dev $compiler_package $emulator_package $more_packages"
# shellcheck disable=SC2086 # packages are words
install_packages $packages
[ -z "$wanted" ] || lose "missing packages: $wanted"

compiler=$prefix-gcc$suffix
folder=$root/build-tests/cross-$target
rm -rf "$folder"
mkdir -p "$folder/headers"
# Alone in a folder: beside them are the C library's headers of this machine.
ln -s /usr/include/boost "$folder/headers/boost"
program=disabled
if [ $system = windows ] && [ $short = no ]; then
    # The program's libraries are headers too, but for one.
    program=enabled
    ln -s /usr/include/CLI /usr/include/fmt "$folder/headers"
    mkdir "$folder/pkgconfig"
    for library in CLI11 fmt; do
        printf 'Name: %s\nDescription: headers\nVersion: %s\nCflags: -I%s -DFMT_HEADER_ONLY\n' $library \
            "$(pkg-config --modversion $library)" "$folder/headers" >"$folder/pkgconfig/$library.pc"
    done
    cp /usr/$prefix/lib/pkgconfig/zlib.pc "$folder/pkgconfig"
fi
cat >"$folder/cross.ini" <<END
[binaries]
c = [${cache:+"'$cache', "}'$compiler']
cpp = [${cache:+"'$cache', "}'$prefix-g++$suffix']
ar = '$prefix-gcc-ar$suffix'
strip = '$prefix-strip'
pkgconfig = 'pkg-config'
exe_wrapper = ['$emulator'$libraries]
[built-in options]
c_args = [$arguments]
cpp_args = [$arguments]
[properties]
needs_exe_wrapper = true
boost_includedir = '$folder/headers'
boost_librarydir = '$folder/headers'
pkg_config_libdir = '$folder/pkgconfig'
[host_machine]
system = '$system'
cpu_family = '$family'
cpu = '$family'
endian = '$endian'
END

echo "== building for $target in ${folder#"$root"/}"
targets=
[ $short = no ] || targets=tests/property/canonical_hashes_test
[ $system != windows ] || targets=$(for t in $targets; do printf '%s.exe ' "$t"; done)
# shellcheck disable=SC2086 # targets are words
if ! { meson setup "$folder/build" "$root" --cross-file "$folder/cross.ini" -Dtests=auto -Ddebug=false \
    -Dcgal=disabled -Dpeers=disabled -Dprogram=$program -Dmpi=disabled >"$folder/log" 2>&1 &&
    ninja -C "$folder/build" -j "$jobs" $targets >"$folder/log" 2>&1; }; then
    tail -n 40 "$folder/log"
    lose "the build for $target"
fi
# Of the library's own code.
ours='^\.\./\.\./\.\./\(src\|include\)/.*warning:'
if grep -q "$ours" "$folder/log"; then
    grep "$ours" "$folder/log" | head -n 20
    lose "the build for $target, which has warnings"
fi

# The first start of Wine makes its folder, and takes long. Its server stays until the end: one that a
# test starts would keep the test's pipes open.
if [ $system = windows ]; then
    WINEPREFIX=$folder/wine
    export WINEPREFIX
    wineserver -p600 </dev/null >/dev/null 2>&1
    trap 'wineserver -k' EXIT
    wine cmd /c exit </dev/null >/dev/null 2>&1
fi
echo "== running the tests of $target"
set --
[ $short = no ] || set -- 'canonical hashes'
meson test -C "$folder/build" --no-rebuild --num-processes "$jobs" --timeout-multiplier 3 --print-errorlogs \
    "$@" >"$folder/log" 2>&1
status=$?
cat "$folder/log"

# For each kernel, what 20,000 points take after 20,000 others: no clock means anything in an emulator.
count_instructions() {
    gcc -shared -fPIC -O1 -o "$folder/count.so" tests/bench/instruction_count.c &&
        "$compiler" -O1 -I include -I "$folder/build/include" -o "$folder/insertions" tests/bench/insertions.c \
            -L "$folder/build/src" -lmgdt "-Wl,-rpath,$folder/build/src" || return 1
    echo "== instructions an insertion"
    for isa in baseline neon; do
        for n in 20000 40000; do
            MGDT_ISA=$isa $emulator -L "/usr/$prefix" -plugin "$folder/count.so" -d plugin -D "$folder/count-$n" \
                "$folder/insertions" $n >"$folder/said" || return 1
            grep -q "^$isa," "$folder/said" || continue 2 # none for this processor
        done
        echo "$isa: $((($(sed 's/.* //' "$folder/count-40000") - $(sed 's/.* //' "$folder/count-20000")) / 20000))"
    done
}
counted=0
case $emulator in
qemu-*) [ $short = yes ] || count_instructions || counted=1 ;;
esac

passed=0
failed=$counted
count_tests "$folder/log"

# What needs no build of the tests: the program by its tests that hold on every system, and Fortran.
run_fortran() {
    $prefix-gfortran-posix -static -o "$folder/poisson.exe" bindings/fortran/mgdt_constants.f90 bindings/fortran/mgdt_c.f90 \
        bindings/fortran/mgdt_support.f90 bindings/fortran/mgdt_layout.f90 bindings/fortran/mgdt_f77_support.f90 \
        bindings/fortran/mgdt_f77.f90 bindings/fortran/examples/poisson.f -J "$folder" -I bindings/fortran \
        "$folder/build/src/libmgdt.dll.a" && cp "$folder/build/src/libmgdt-1.dll" "$folder" && wine "$folder/poisson.exe"
}
log=$folder/log
if [ $program = enabled ]; then
    printf '#!/bin/sh\nexec wine "%s" "$@"\n' "$folder/build/src/cli/mgdt.exe" >"$folder/mgdt"
    chmod +x "$folder/mgdt"
    step "the program reads and writes files of others" python3 tests/cli/solver_files_test.py "$folder/mgdt"
    step "the program: usage, pipes, messages" python3 tests/cli/cli_test.py "$folder/mgdt" Usage.test_wrong_usage \
        Pipelines.test_every_output_checks Pipelines.test_pipes Pipelines.test_canonical_is_one_file \
        Pipelines.test_every_point_format Pipelines.test_info BadInput.test_messages_name_file_and_place \
        BadInput.test_check_finds_defects
    step "FORTRAN 77" run_fortran
fi
[ $status -eq 0 ] || [ $failed -gt 0 ] || failed=1
printf '\n%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
