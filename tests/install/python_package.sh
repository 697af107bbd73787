# SPDX-License-Identifier: MIT
# The Python package from the commands of docs/python.md: this Python finds it where they install it,
# and it finds the library, with no ldconfig and no variables. Read by install_test.sh, whose functions
# and variables it uses.

python=/usr/bin/python3
program='import mgdt, sys
mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]).check()
print(mgdt.library_path(), mgdt.__file__)
assert mgdt.library_path() == sys.argv[1], sys.argv[1]
assert mgdt.__file__ == sys.argv[2], sys.argv[2]'

# Runs the program as `python3 -I` does: no PYTHON* variables, no packages of the user.
use_package() { # python, library, file of the package
    env -u LD_LIBRARY_PATH -u MGDT_LIBRARY "$1" -I -B -c "$program" "$2" "$3"
}

# The library that the shared build has made, with the package for another prefix.
install_package() { # PATH, prefix, destination or nothing, meson options...
    search=$1
    prefix=$2
    destination=$3
    shift 3
    PATH=$search meson setup --reconfigure "$scratch/shared" "$source" --prefix "$prefix" -Dpython=true \
        -Ddocs=false -Dbindings=none -Dbindings_dir= "$@" &&
        PATH=$search meson compile -C "$scratch/shared" &&
        PATH=$search meson install -C "$scratch/shared" --no-rebuild \
            ${destination:+--destdir "$destination"}
}

# Staged, since /usr/local is the system's: the folder must be one in which Python looks, and there is
# nothing else in the stage.
debian_finds_it() { # prefix
    root=$scratch/python-root
    rm -rf "$root"
    install_package "/usr/bin:$PATH" "$1" "$root" || return 1
    file=$(find "$root" -path '*/mgdt/__init__.py')
    library=$(find "$root" -name libmgdt.so.1)
    folder=${file%/mgdt/__init__.py}
    "$python" -I -c 'import site, sys; assert sys.argv[1] in site.getsitepackages(), sys.argv' \
        "${folder#"$root"}" || return 1
    env -u LD_LIBRARY_PATH -u MGDT_LIBRARY "$python" -I -B -c "import sys
sys.path.insert(0, sys.argv[3])
$program" "$library" "$file" "$folder"
}

venv_finds_it() { # prefix or nothing for that of the environment
    rm -rf "$scratch/venv" "$scratch/python-prefix"
    "$python" -m venv --system-site-packages "$scratch/venv" || return 1
    install_package "$scratch/venv/bin:$PATH" "${1:-"$scratch/venv"}" "" || return 1
    library=$(find "${1:-"$scratch/venv"}" -name libmgdt.so.1)
    packages=$("$scratch/venv/bin/python" -I -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
    use_package "$scratch/venv/bin/python" "$library" "$packages/mgdt/__init__.py"
}

# A prefix of one's own is told of, and PYTHONPATH makes Python look there, also after a move.
own_prefix_is_told() {
    rm -rf "$scratch/python-prefix" "$scratch/python-moved"
    install_package "/usr/bin:$PATH" "$scratch/python-prefix" "" >"$scratch/told" 2>&1
    status=$?
    cat "$scratch/told"
    [ $status -eq 0 ] && grep -q 'WARNING: .*PYTHONPATH' "$scratch/told" || return 1
    mv "$scratch/python-prefix" "$scratch/python-moved"
    file=$(find "$scratch/python-moved" -path '*/mgdt/__init__.py')
    library=$(find "$scratch/python-moved" -name libmgdt.so.1)
    env -u LD_LIBRARY_PATH -u MGDT_LIBRARY PYTHONPATH="${file%/mgdt/__init__.py}" \
        "$python" -B -c "$program" "$library" "$file"
}

# Also after an import that may write what it likes.
uninstalled_it_is_gone() {
    rm -rf "$scratch/venv"
    "$python" -m venv --system-site-packages "$scratch/venv" || return 1
    install_package "$scratch/venv/bin:$PATH" "$scratch/venv" "" || return 1
    in_venv="env -u LD_LIBRARY_PATH -u MGDT_LIBRARY $scratch/venv/bin/python -I -c"
    $in_venv 'import mgdt, mgdt.export' && ninja -C "$scratch/shared" uninstall &&
        $in_venv 'import mgdt' 2>"$scratch/told"
    cat "$scratch/told"
    grep -q 'ModuleNotFoundError' "$scratch/told"
}

check "Debian's Python finds the package below /usr/local" debian_finds_it /usr/local
check "Debian's Python finds the package below /usr" debian_finds_it /usr
check "a virtual environment finds the package, library below its own prefix" venv_finds_it
check "a virtual environment finds the package, library elsewhere" venv_finds_it "$scratch/python-prefix"
check "when it is uninstalled, Python finds no package" uninstalled_it_is_gone
check "a prefix where Python does not look is told of, and may be moved" own_prefix_is_told
