# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# For the scripts beside it: sets `cache` to the command that compilers are called through, which is ccache where it is
# installed and otherwise empty. Its folder is kept between runs (~/.cache/ccache unless CCACHE_DIR says where), and a
# clone finds there what another one has compiled. Needs `root`, the source tree.
cache=
if command -v ccache >/dev/null; then
    cache=ccache
    # Paths below the tree are the same in every clone. Precompiled headers need the sloppiness.
    CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    export CCACHE_BASEDIR CCACHE_NOHASHDIR CCACHE_SLOPPINESS
fi
