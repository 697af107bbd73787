#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the Fortran examples at 100,000 points and more under a small stack, compiled with -Ofast,
which puts automatic arrays and temporaries there.

  small_stack_test.py SOURCE_DIRECTORY BUILD_DIRECTORY SCRATCH_DIRECTORY

The examples are those of docs/fortran.md and those that are installed. Each names its size in a
constant, which is made larger. FC says which compiler; where there is flang, it has its turn too."""
import os
import re
import resource
import shutil
import subprocess
import sys
from pathlib import Path

source, build, scratch = (Path(p).resolve() for p in sys.argv[1:4])
sys.dont_write_bytecode = True
sys.path.insert(0, str(source / "tests" / "docs"))
import installation
import run_examples

STACK = 512 * 1024
POINTS = 120000
bad = done = 0


def larger_n(text):
    """The example with its constant n made POINTS; None where it has none."""
    larger, count = re.subn(r"(\bn = )\d+", rf"\g<1>{POINTS}", text, count=1)
    return larger if count else None


# What the other examples call their size. FIRST and cube have nine points at most.
SIZES = {
    "transfer.f90": [(r"m = 12", "m = 40"), (r"\[5, 10, 20\]", "[5, 10, 45]")],
    "carry.f": [(r"N = 11", "N = 47")],
    "columns.f": [(r"PARAMETER \(N = \d+", f"PARAMETER (N = {POINTS}")],
    # 38^3 + 37^3 points.
    "poisson.f": [(r"CALL SOLVE\(8,", "CALL SOLVE(18,"), (r"CALL SOLVE\(16,", "CALL SOLVE(37,"),
                  (r"MAXP = 10000\b", "MAXP = 110000"), (r"MAXT = 60000\b", "MAXT = 700000"),
                  (r"MAXF = 4000\b", "MAXF = 20000"), (r"MAXE = 80000\b", "MAXE = 900000")],
    "adaptive.f90": [(r"tolerance = 0\.02_dp", "tolerance = 0.009_dp"), (r"make_grid\(37,", "make_grid(50,")],
    "stirred.f": [(r"MAXP = 4000\b", "MAXP = 40000"), (r"MAXT = 20000\b", "MAXT = 200000"),
                  (r"MAXM = 20000\b", "MAXM = 200000"), (r"NSTEPS = 30, M = 8", "NSTEPS = 12, M = 24"),
                  # Small tetrahedra are not inverted so soon.
                  (r"IF \(VLEAST \.GT\. 0\.0D0\) STOP 1", "CONTINUE")],
}
UNCHANGED = {"first.f", "cube.f90"}


def enlarged(name, text):
    if name in UNCHANGED:
        return text
    if name not in SIZES:
        return larger_n(text)
    for pattern, larger in SIZES[name]:
        text, count = re.subn(pattern, larger, text)
        if not count:
            return None
    return text


def report(what, well, output=""):
    global bad, done
    done += well
    bad += not well
    print(("passed: " if well else "failed: ") + what, flush=True)
    if not well:
        print("".join(f"    {line}\n" for line in output.splitlines()[:40]), end="")


def run(command, folder, environment, small_stack=False):
    def limit():
        resource.setrlimit(resource.RLIMIT_STACK, (STACK, STACK))
    result = subprocess.run(command, cwd=folder, env=environment, text=True, timeout=600,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            preexec_fn=limit if small_stack else None)
    return result.returncode, result.stdout


def examples_of(document):
    """name -> text of the Fortran files of a document."""
    blocks, problems = run_examples.blocks_of(document)
    assert not problems, problems
    return {b.file: b.text for b in blocks if b.file and b.kind == "fortran"}


def compile_and_run(compiler, flags, examples, prefix, environment):
    folder = scratch / Path(compiler).name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)

    def words(*arguments):
        return subprocess.run(["pkg-config", *arguments, "mgdt-fortran"], env=environment, check=True,
                              capture_output=True, text=True).stdout.split()

    sources = words("--variable=fortran_sources")
    sources += [s for s in words("--variable=f77_sources") if s not in sources]
    cflags, libs = words("--cflags"), words("--libs")
    status, output = run([compiler, *flags, "-c", *sources], folder, environment)
    report(f"{compiler}: the sources compile", status == 0, output)
    if status:
        return
    objects = sorted(p.name for p in folder.glob("*.o"))
    for name, text in examples.items():
        larger = enlarged(name, text)
        report(f"{compiler}: {name} says its size", larger is not None)
        if larger is None:
            continue
        (folder / name).write_text(larger, encoding="utf-8")
        program = "./" + name.replace(".", "-")
        extra = ["-fopenmp"] if "!$omp" in text else []
        status, output = run([compiler, *flags, *extra, *cflags, name, "-o", program, *objects, *libs],
                             folder, environment)
        report(f"{compiler}: {name} compiles", status == 0, output)
        if status:
            continue
        status, output = run([program], folder, environment, small_stack=True)
        # One of them ends with an error on purpose.
        well = status == 0 or (name == "errors.f90" and status == 1 and "no order scheme" in output)
        report(f"{compiler}: {name} runs", well, f"status {status}\n{output}")


def main():
    scratch.mkdir(parents=True, exist_ok=True)
    prefix = installation.of_build(build, scratch / "installed")
    environment = prefix.environment(source, scratch)
    # Both runtimes give threads of OpenMP the stack that this says.
    environment.update(OMP_NUM_THREADS="4", OMP_STACKSIZE=f"{STACK // 1024}K")
    examples = examples_of(source / "docs" / "fortran.md")
    for file in sorted((prefix.prefix / "share" / "mgdt" / "fortran" / "examples").iterdir()):
        # Those of MPI are not for this compiler alone (tests/mpi/).
        if not file.stem.endswith("_mpi"):
            examples[file.name] = file.read_text(encoding="utf-8")
    compile_and_run(os.environ.get("FC", "gfortran"), ["-Ofast"], examples, prefix, environment)
    flang = next((f for f in ("flang-new", "flang", "flang-new-19") if shutil.which(f)), None)
    if flang:
        # Its runtime for OpenMP is a package of its own.
        alone = {name: text for name, text in examples.items() if "!$omp" not in text}
        compile_and_run(flang, ["-Ofast"], alone, prefix, environment)
    print(f"{done} passed, {bad} failed")
    return 1 if bad or not done else 0


if __name__ == "__main__":
    sys.exit(main())
