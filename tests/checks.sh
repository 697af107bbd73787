# SPDX-License-Identifier: MIT
# What the tests that are shell scripts share: checks that are counted. Read by them, with `scratch` a
# folder of theirs.

passed=0
failed=0
log=$scratch/log
pass() { # what
    passed=$((passed + 1))
    echo "passed: $1"
}
lose() { # what; the log says why
    failed=$((failed + 1))
    echo "failed: $1"
    head -n 60 "$log" | sed 's/^/    /'
}
check() { # what, command...
    what=$1
    shift
    if "$@" >"$log" 2>&1; then pass "$what"; else lose "$what"; fi
}
# Ends the test. One that has checked nothing has failed.
conclude() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
    exit
}
