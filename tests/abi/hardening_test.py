#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the build option `hardened` promises is in the files that were built.

  hardening_test.py --fortified yes|no --branches yes|no FILE...

--fortified: optimised, so that glibc's checked calls are used; --branches: the compiler has
-fcf-protection. A file with a program header of an interpreter is a program, else a library.
"""
import argparse
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, finish, output_of


def functions_without_marker(file):
    """Of those that can be called through a pointer from elsewhere: the exported ones."""
    names = set(re.findall(r" T (mgdt_\w+)", output_of("nm", "-D", "--defined-only", file)))
    unmarked, seen = [], 0
    code = output_of("objdump", "-d", "--no-show-raw-insn", file)
    for name, first in re.findall(r"^[0-9a-f]+ <(mgdt_\w+)(?:@@\S+)?>:\n\s*[0-9a-f]+:\s*(\w+)", code, flags=re.M):
        if name in names:
            seen += 1
            if first != "endbr64":
                unmarked.append(name)
    return " ".join(unmarked) if seen == len(names) and seen else f"{seen} of {len(names)} functions found"


def inspect(file, options):
    name = Path(file).name
    segments, dynamic = output_of("readelf", "-lW", file), output_of("readelf", "-dW", file)
    undefined = output_of("nm", "-D", "--undefined-only", file)
    is_program = "INTERP" in segments

    stack = re.search(r"GNU_STACK.*", segments)
    check(f"{name}: the stack is not executable", "" if stack and "RWE" not in stack.group() else str(stack))
    check(f"{name}: no segment is both written and executed", " ".join(re.findall(r"LOAD.* RWE .*", segments)))
    check(f"{name}: relocations become read-only", "" if "GNU_RELRO" in segments else "no GNU_RELRO")
    check(f"{name}: they are all made at the start", "" if re.search(r"BIND_NOW|FLAGS_1.*\bNOW\b", dynamic) else dynamic)
    check(f"{name}: no relocation changes code", "TEXTREL" if "TEXTREL" in dynamic else "")
    check(f"{name}: libraries are found where the system has them",
          " ".join(re.findall(r"\((?:RPATH|RUNPATH)\).*", dynamic)))
    check(f"{name}: stack protector", "" if "__stack_chk_fail" in undefined else "no __stack_chk_fail")
    if options.fortified == "yes":
        check(f"{name}: calls that glibc checks", "" if re.search(r"__\w+_chk\b", undefined.replace("__stack_chk", ""))
              else "none")
    if is_program:
        header = output_of("readelf", "-hW", file)
        check(f"{name}: can be loaded anywhere", "" if re.search(r"Type:\s+DYN", header) else "not PIE")
    elif options.branches == "yes":
        check(f"{name}: functions begin where an indirect call may go", functions_without_marker(file))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--fortified", choices=("yes", "no"), required=True)
    parser.add_argument("--branches", choices=("yes", "no"), required=True)
    parser.add_argument("files", nargs="+")
    options = parser.parse_args()
    for file in options.files:
        inspect(file, options)
    finish()


if __name__ == "__main__":
    main()
