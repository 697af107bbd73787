# SPDX-License-Identifier: MIT
"""Prints where `meson install` puts the package for the Python that runs this, and how it gets from
there to the library.

  installation.py PREFIX LIBRARY_FOLDER LIBRARY_NAME [PACKAGES]

Four lines: the folder of packages, the library seen from the package's folder in it (or its absolute
path, if they do not stand below one prefix), "yes" if this Python looks for packages there, and the
tag in the names of its compiled files. The folder is PACKAGES if that is given. In a virtual
environment it is that of the environment, otherwise the one below the prefix in which this Python
looks: Debian's looks in lib/python3.11/dist-packages below /usr/local, and in lib/python3/dist-packages
below /usr.
"""

import os
import site
import sys
import sysconfig


def is_below(path, folder):
    return os.path.commonpath([path, folder]) == folder


def known_folders():
    """Where this Python looks for packages, whether the folders are there yet or not."""
    return [*site.getsitepackages(), site.getusersitepackages()]


def package_folder(prefix):
    """The folder of packages that belongs to the prefix."""
    if sys.prefix != sys.base_prefix:
        return sysconfig.get_path("purelib")
    # Below lib itself: /usr/local/lib is not /usr's, and lib64 is for compiled packages.
    found = [path for path in known_folders() if is_below(path, os.path.join(prefix, "lib"))]
    scheme = {"base": prefix, "platbase": prefix}
    return found[0] if found else sysconfig.get_path("purelib", "posix_prefix", scheme)


def library_from(package, library, prefix):
    if is_below(package, prefix) and is_below(library, prefix):
        return os.path.relpath(library, package)
    return library


def main():
    prefix = os.path.normpath(sys.argv[1])
    library = os.path.normpath(os.path.join(prefix, *sys.argv[2:4]))
    chosen = os.path.join(prefix, sys.argv[4]) if sys.argv[4:] else package_folder(prefix)
    packages = os.path.normpath(chosen)
    print(packages)
    print(library_from(os.path.join(packages, "mgdt"), library, prefix))
    print("yes" if packages in known_folders() else "no")
    print(sys.implementation.cache_tag)


if __name__ == "__main__":
    main()
