# SPDX-License-Identifier: MIT
"""What the tests that are scripts share: checks that are counted, and the output of commands."""
import subprocess
import sys

passed = failed = 0


def check(what, problem, names_passed=True):
    """Counts a check, which passed if there is no problem, and says so."""
    global passed, failed
    if problem:
        failed += 1
        print(f"failed: {what}: {problem}")
    else:
        passed += 1
        if names_passed:
            print(f"passed: {what}")


def finish():
    """Ends the test. One that has checked nothing has failed."""
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed or not passed else 0)


def output_of(*command):
    """What a command writes; one that fails ends the test."""
    run = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{' '.join(run.args)} ended with {run.returncode}: {run.stdout}{run.stderr}")
    return run.stdout


def differences(first, second, missing="missing", unexpected="unexpected"):
    """What the second set lacks, and what it has besides; nothing if they are equal."""
    parts = [(missing, first - second), (unexpected, second - first)]
    return "; ".join(f"{word} {' '.join(sorted(names))}" for word, names in parts if names)
