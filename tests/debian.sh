#!/bin/sh
# SPDX-License-Identifier: MIT
# For the scripts beside it: Debian packages, and counts of what passed and failed.
#
#   install_packages PACKAGE...
#                        installs those that are missing, as root or through sudo, unless no_install
#                        is yes; sets wanted to those that are still missing
#   as_root COMMAND...   runs a command as root
#   step WHAT COMMAND... runs a command with its output in the file $log, and shows the end of that if it
#                        fails; counts in passed and failed
#   count_tests FILE     adds what `meson test` printed into FILE to passed and failed; a test that is
#                        skipped or runs out of time failed

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

is_installed() {
    dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed' && return 0
    # From elsewhere than Debian will do for the one that is a command of that name.
    [ "$1" = npm ] && command -v npm >/dev/null
}

missing_packages() { for p; do is_installed "$p" || printf '%s ' "$p"; done; }

install_packages() {
    wanted=$(missing_packages "$@")
    if [ -n "$wanted" ] && [ "${no_install:-no}" = no ]; then
        printf '\n== installing %s\n' "$wanted"
        # shellcheck disable=SC2086 # packages are words
        as_root apt-get update -qq && as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq \
            --no-install-recommends $wanted >/dev/null
        wanted=$(missing_packages "$@")
    fi
}

count_tests() {
    count_of() { sed -n "s/^$2: *\([0-9][0-9]*\) *\$/\1/p" "$1" | tail -n 1; }
    passed=$((passed + $(count_of "$1" Ok) + 0))
    failed=$((failed + $(count_of "$1" Fail) + $(count_of "$1" 'Unexpected Pass') +
        $(count_of "$1" Skipped) + $(count_of "$1" Timeout) + 0))
}

step() {
    what=$1
    shift
    if "$@" >"${log:?}" 2>&1; then
        passed=$((passed + 1))
        echo "passed: $what"
    else
        failed=$((failed + 1))
        tail -n 40 "$log"
        echo "failed: $what"
        return 1
    fi
}
