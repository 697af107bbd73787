# SPDX-License-Identifier: MIT
"""Interpolation beside SciPy's, with one thread: python3 interpolation_versus_scipy.py [POINTS [PLACES]]

Prints microseconds a place, of the clock and of the processor, and how long SciPy takes in the same run.
"""

import sys
import time

import numpy as np
import scipy.interpolate

import mgdt


def timed(work):
    clock, processor = time.perf_counter(), time.process_time()
    result = work()
    return time.perf_counter() - clock, time.process_time() - processor, result


def main():
    n = int(float(sys.argv[1])) if len(sys.argv) > 1 else 100_000
    m = int(float(sys.argv[2])) if len(sys.argv) > 2 else n
    random = np.random.default_rng(1)
    points, places = random.random((n, 3)), random.random((m, 3))
    values, truth = np.sin(points.sum(axis=1)), np.sin(places.sum(axis=1))

    made, _, linear = timed(lambda: mgdt.LinearNDInterpolator(points, values))
    linear(places[: m // 10])
    asked, asked_processor, found = timed(lambda: linear(places))
    their_made, _, theirs = timed(lambda: scipy.interpolate.LinearNDInterpolator(points, values))
    # The larger part of the time is the same for each place.
    few = min(m, 100_000)
    their_asked, _, expected = timed(lambda: theirs(places[:few]))
    their_asked *= m / few
    both = ~np.isnan(expected)
    print(f"{n} points, {m} places; linear: {1e6 * asked / m:.2f} us a place, processor "
          f"{1e6 * asked_processor / m:.2f}; SciPy {their_asked / asked:.1f} times that, with "
          f"construction {(their_made + their_asked) / (made + asked):.1f}; largest difference "
          f"{np.abs(found[:few] - expected)[both].max():.1e}")
    for method in ("nearest", "sibson", "laplace", "sibson_c1"):
        clock, processor, found = timed(
            lambda: linear.tri.interpolate(values, places, method=method)
        )
        error = np.nanmean(np.abs(found - truth))
        print(f"{method}: {1e6 * clock / m:.2f} us a place, processor {1e6 * processor / m:.2f}, "
              f"mean error {error:.1e}")
    clock, processor, _ = timed(lambda: linear.tri.gradients(values))
    print(f"gradients: {1e6 * clock / n:.2f} us a point, processor {1e6 * processor / n:.2f}")
    compare_drop_ins(points, values)


def compare_drop_ins(points, values):
    """At a grid of 64^3 places, and at one place at a time."""
    grid = np.stack(np.meshgrid(*[np.linspace(0, 1, 64)] * 3, indexing="ij"), axis=-1)
    for name in ("LinearNDInterpolator", "NearestNDInterpolator"):
        ours, theirs = ([], [])
        for module, into in ((mgdt, ours), (scipy.interpolate, theirs)):
            made, _, at = timed(lambda: getattr(module, name)(points, values))
            asked, _, _ = timed(lambda: at(grid))
            alone, _, _ = timed(lambda: [at(0.3, 0.4, 0.5) for _ in range(1000)])
            into += [made, asked, alone / 1000]
        ratios = ", ".join(f"{what} {a / b:.2f}" for what, a, b in
                           zip(("made", "at a grid", "at one place"), ours, theirs))
        print(f"{name} over SciPy's: {ratios}; one place {1e6 * ours[2]:.0f} us")


if __name__ == "__main__":
    main()
