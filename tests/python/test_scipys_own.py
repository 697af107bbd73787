# SPDX-License-Identifier: MIT
"""SciPy's own tests of its interpolators, run with mgdt's in their place.

They are in the plane. Here it is the plane z = 0 in space, with one point more above it: then it is
a side of the convex hull, in which the triangulation of the points is that of the plane, and so are
values between them.
"""

import inspect
import types
import unittest

import mgdt
import numpy as np
import scipy.interpolate
from scipy.interpolate.tests import test_interpnd, test_ndgriddata

HEIGHT = 10.0

# What does not apply, and why.
LEFT_OUT = {
    "test_1d": "on a line",
    "test_1d_borders": "on a line",
    "test_1d_unsorted": "on a line",
    "test_tri_input_rescale": "refused too, in other words",
}


def points_in_space(points):
    if hasattr(points, "simplices"):
        points = points.points
    if isinstance(points, tuple):
        points = np.stack(points, axis=-1)
    flat = np.asarray(points, dtype=float)
    if flat.shape[1] == 3:
        return flat
    above = [*flat.mean(axis=0), HEIGHT]
    return np.vstack([np.column_stack([flat, np.zeros(len(flat))]), above])


def values_in_space(points, values):
    values = np.asarray(values)
    is_flat = len(points_in_space(points)) > len(values)
    return np.concatenate([values, values[:1]]) if is_flat else values


def places_in_space(*places):
    given = places[0] if len(places) == 1 else places
    if isinstance(given, tuple):
        return ((*given, 0.0),)
    array = np.asarray(given, dtype=float)
    if array.ndim > 1 and array.shape[-1] == 3:
        return (array,)
    return (np.concatenate([array, np.zeros((*array.shape[:-1], 1))], axis=-1),)


class InSpace:
    def __init__(self, points, values, **options):
        self.inner = self.kind(points_in_space(points), values_in_space(points, values), **options)

    def __call__(self, *places):
        return self.inner(*places_in_space(*places))


class Linear(InSpace):
    kind = mgdt.LinearNDInterpolator


class Nearest(InSpace):
    kind = mgdt.NearestNDInterpolator


def griddata(points, values, xi, method="linear", **options):
    if method == "cubic":  # of the plane alone
        return scipy.interpolate.griddata(points, values, xi, method=method, **options)
    (places,) = places_in_space(xi)
    return mgdt.griddata(points_in_space(points), values_in_space(points, values), places,
                         method=method, **options)


class SciPysOwn(unittest.TestCase):
    def setUp(self):
        replacements = [
            (test_interpnd, "interpnd", types.SimpleNamespace(LinearNDInterpolator=Linear)),
            (test_ndgriddata, "griddata", griddata),
            (test_ndgriddata, "NearestNDInterpolator", Nearest),
            (test_ndgriddata, "LinearNDInterpolator", Linear),
        ]
        for module, name, replacement in replacements:
            self.addCleanup(setattr, module, name, getattr(module, name))
            setattr(module, name, replacement)

    def run_all(self, tests, expected):
        count = 0
        for name, test in inspect.getmembers(tests(), inspect.ismethod):
            if not name.startswith("test_") or name in LEFT_OUT:
                continue
            for argument in [Linear, Nearest] if inspect.signature(test).parameters else [None]:
                with self.subTest(name, argument=argument):
                    test() if argument is None else test(argument)
                count += 1
        self.assertGreaterEqual(count, expected)

    def test_linear(self):
        self.run_all(test_interpnd.TestLinearNDInterpolation, 9)

    def test_griddata(self):
        self.run_all(test_ndgriddata.TestGriddata, 7)

    def test_nearest(self):
        self.run_all(test_ndgriddata.TestNearestNDInterpolator, 2)

    def test_both(self):
        self.run_all(test_ndgriddata.TestNDInterpolators, 4)


if __name__ == "__main__":
    unittest.main()
