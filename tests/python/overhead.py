# SPDX-License-Identifier: MIT
"""What Python adds to the time of C: points in, tetrahedra and neighbours out.

    overhead.py C_ROUNDS [--points N] [--rounds N]

C_ROUNDS is the program made of c_rounds.c. Both use the same library and do the same work in turn,
a round each; medians are compared. Ends with status 1 if Python adds 3 % or more.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time

# NumPy asks for huge pages for its arrays, which saves more time than Python costs. Without them
# the difference is Python's.
os.environ["NUMPY_MADVISE_HUGEPAGE"] = "0"

import numpy as np  # noqa: E402

import mgdt  # noqa: E402

LARGEST_OVERHEAD = 0.03


def python_round(points):
    begin = time.perf_counter()
    tri = mgdt.Delaunay(points)
    arrays = tri.simplices, tri.neighbors
    seconds = time.perf_counter() - begin
    del arrays
    return seconds


class CRounds:
    """The C program, which waits for its turns."""

    def __init__(self, program, points):
        with tempfile.NamedTemporaryFile() as file:
            points.tofile(file.name)
            self.process = subprocess.Popen(
                [program, file.name, str(len(points))],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
            self()

    def __call__(self):
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline())

    def close(self):
        self.process.communicate()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("c_rounds")
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=21)
    options = parser.parse_args()

    points = np.random.default_rng(1).random((options.points, 3))
    c_round = CRounds(options.c_rounds, points)
    python_round(points)
    seconds = {"C": [], "Python": []}
    for k in range(options.rounds):
        turns = [("C", c_round), ("Python", lambda: python_round(points))]
        # Who goes first alternates too.
        for name, turn in turns if k % 2 else turns[::-1]:
            seconds[name].append(turn())
    c_round.close()

    medians = {name: statistics.median(values) for name, values in seconds.items()}
    overhead = medians["Python"] / medians["C"] - 1
    for name, values in seconds.items():
        print(
            f"{name:8} median {medians[name]:.3f} s, least {min(values):.3f} s, "
            f"most {max(values):.3f} s of {len(values)} rounds, {options.points} points"
        )
    limit = f"less than {100 * LARGEST_OVERHEAD:.0f} % is asked"
    print(f"Python / C - 1 = {100 * overhead:+.1f} %; {limit}")
    return int(overhead >= LARGEST_OVERHEAD)


if __name__ == "__main__":
    sys.exit(main())
