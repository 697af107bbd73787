# SPDX-License-Identifier: MIT
"""Values between points."""

import unittest

import numpy as np
import scipy.interpolate
import scipy.spatial

import mgdt

METHODS = ("linear", "nearest", "sibson", "laplace", "sibson_c1")
OUTSIDES = ("none", "nearest", "boundary", "linear")


def field(x):
    return x @ [1.0, -2.0, 0.5] + 3


class Interpolation(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(1)
        corners = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).reshape(3, 8).T
        self.points = np.concatenate([random.random((200, 3)), corners])
        self.tri = mgdt.Delaunay(self.points)
        self.inside = random.random((50, 4, 3))
        self.outside = self.inside[0] + [2, 0, 0]

    def test_linear_functions(self):
        values = field(self.points)
        for method in METHODS:
            for outside in OUTSIDES:
                got = self.tri.interpolate(values, self.inside, method=method, outside=outside)
                self.assertEqual(got.shape, (50, 4))
                if method != "nearest":
                    np.testing.assert_allclose(got, field(self.inside), atol=1e-13)
                beyond = self.tri.interpolate(
                    values, self.outside, -7, method=method, outside=outside
                )
                if outside == "none":
                    self.assertEqual(beyond.tolist(), [-7] * 4)
                elif outside == "linear" and method != "nearest":
                    np.testing.assert_allclose(beyond, field(self.outside), atol=1e-13)
                elif outside == "boundary" and method != "nearest":
                    np.testing.assert_allclose(
                        beyond, field(np.minimum(self.outside, 1)), atol=1e-13
                    )

    def test_values_of_any_kind(self):
        values = np.stack([field(self.points), field(self.points) * 2j], axis=1)
        got = self.tri.interpolate(values, self.inside, method="sibson")
        self.assertEqual(got.shape, (50, 4, 2))
        self.assertEqual(got.dtype, np.complex128)
        np.testing.assert_allclose(got[..., 1], 2j * field(self.inside), atol=1e-13)
        single = self.tri.interpolate(values.real.astype(np.float32), self.inside, method="laplace")
        self.assertEqual(single.dtype, np.float64)
        np.testing.assert_allclose(single[..., 0], field(self.inside), atol=1e-5)
        # A value that is no number is one all the same.
        gaps = field(self.points)
        gaps[0] = np.nan
        here = self.tri.interpolate(gaps, self.points[:2], -7, method="sibson")
        self.assertTrue(np.isnan(here[0]))
        self.assertEqual(here[1], gaps[1])
        nowhere = self.tri.interpolate(gaps, [[np.nan, 0, 0], [5, 5, 5]], -7, method="sibson")
        self.assertEqual(nowhere.tolist(), [-7, -7])

    def test_weights(self):
        values = field(self.points)
        places = self.inside[0]
        for method in METHODS:
            offsets, indices, weights = self.tri.interpolation_weights(places, method)
            self.assertEqual((offsets[0], offsets.shape), (0, (5,)))
            sums = [
                weights[a:b] @ values[indices[a:b]] for a, b in zip(offsets[:-1], offsets[1:])
            ]
            np.testing.assert_allclose(
                sums, self.tri.interpolate(values, places, method=method), atol=1e-13
            )
        offsets, indices, weights = self.tri.interpolation_weights(self.outside)
        self.assertEqual(offsets.tolist(), [0] * 5)
        # More weights than there is room for at first.
        offsets, indices, weights = self.tri.interpolation_weights(
            places, "sibson_c1", outside="linear"
        )
        self.assertEqual(len(weights), offsets[-1])
        self.assertGreater(offsets[-1], 24 * 4 + 8)

    def test_gradients(self):
        gradients = self.tri.gradients(field(self.points))
        np.testing.assert_allclose(gradients, np.tile([1, -2, 0.5], (208, 1)), atol=1e-11)
        two = self.tri.gradients(np.stack([field(self.points), 1j * field(self.points)], axis=1))
        self.assertEqual(two.shape, (208, 2, 3))
        np.testing.assert_allclose(two[:, 1], 1j * gradients, atol=1e-15)

    def test_refused(self):
        values = field(self.points)
        with self.assertRaisesRegex(ValueError, "method is 'cubic'; it must be one of linear"):
            self.tri.interpolate(values, self.inside, method="cubic")
        with self.assertRaisesRegex(ValueError, "outside is 1; it must be one of none"):
            self.tri.interpolate(values, self.inside, outside=1)
        with self.assertRaisesRegex(ValueError, "there are 208 points"):
            self.tri.interpolate(values[:-1], self.inside, method="sibson")
        flat = mgdt.Delaunay(self.points * [1, 1, 0])
        with self.assertRaisesRegex(mgdt.ArgumentError, "in one plane"):
            flat.interpolate(values, self.inside, method="sibson")
        with self.assertRaisesRegex(mgdt.ArgumentError, "there are no gradients"):
            flat.gradients(values)
        nearest = flat.interpolate(values, self.points * [1, 1, 0], method="nearest", outside="nearest")
        self.assertEqual(nearest[:200].tolist(), values[:200].tolist())


class BesideSciPy(unittest.TestCase):
    """What SciPy's classes give in three dimensions."""

    def setUp(self):
        random = np.random.default_rng(2)
        self.points = random.random((300, 3))
        self.places = 1.2 * random.random((40, 5, 3)) - 0.1
        self.real = np.sin(self.points @ [3.0, 4.0, 5.0])
        self.values = [
            self.real,
            self.real + 1j * self.points[:, 0],
            np.stack([self.real, self.points[:, 1]], axis=1),
            (100 * self.real).astype(int),
            self.real.astype(np.float32),
        ]

    def compare(self, ours, theirs, *places):
        expected, got = theirs(*places), ours(*places)
        self.assertEqual(got.shape, expected.shape)
        self.assertEqual(np.iscomplexobj(got), np.iscomplexobj(expected))
        np.testing.assert_allclose(got, expected, atol=1e-12)

    def test_linear(self):
        for values in self.values:
            for options in ({}, {"fill_value": -3}, {"rescale": True}):
                points = self.points * [1, 1e3, 1e-3] if "rescale" in options else self.points
                places = self.places * [1, 1e3, 1e-3] if "rescale" in options else self.places
                ours = mgdt.LinearNDInterpolator(points, values, **options)
                theirs = scipy.interpolate.LinearNDInterpolator(points, values, **options)
                self.compare(ours, theirs, places)
                self.compare(ours, theirs, *places.T)
                self.compare(ours, theirs, tuple(places.T))
                self.compare(ours, theirs, places[0, 0])
        for given in (mgdt.Delaunay(self.points), scipy.spatial.Delaunay(self.points),
                      tuple(self.points.T)):
            ours = mgdt.LinearNDInterpolator(given, self.real)
            theirs = scipy.interpolate.LinearNDInterpolator(self.points, self.real)
            self.compare(ours, theirs, self.places)

    def test_nearest(self):
        for rescale in (False, True):
            ours = mgdt.NearestNDInterpolator(self.points, self.real, rescale)
            theirs = scipy.interpolate.NearestNDInterpolator(self.points, self.real, rescale)
            self.compare(ours, theirs, self.places)
            self.compare(ours, theirs, *self.places.T)
        words = np.array(["a", "b"])[(self.real > 0).astype(int)]
        self.assertEqual(
            mgdt.NearestNDInterpolator(self.points, words)(self.points).tolist(), words.tolist()
        )

    def test_griddata(self):
        grid = tuple(np.mgrid[0:1:4j, 0:1:3j, 0:1:5j])
        for method in ("linear", "nearest"):
            for values in self.values:
                for rescale in (False, True):
                    given = (self.points, values, grid, method, -1, rescale)
                    expected = scipy.interpolate.griddata(*given)
                    np.testing.assert_allclose(mgdt.griddata(*given), expected, atol=1e-12)
        with self.assertRaisesRegex(ValueError, "Unknown interpolation method 'cubic'"):
            mgdt.griddata(self.points, self.real, grid, "cubic")

    def test_places_that_rounding_brings_outside(self):
        """On a slanted edge of the hull, where SciPy's tolerance takes nearly all."""
        corners = np.array([[0, 0, 0], [1, 0.3, 0.1], [0.1, 1, 0.2], [0.3, 0.1, 1]])
        points = np.concatenate([0.2 + 0.3 * np.random.default_rng(5).random((100, 3)), corners])
        values = field(points)
        shares = np.linspace(0, 1, 101)[:, np.newaxis]
        bare = 0
        for a in range(4):
            for b in range(a):
                places = corners[a] * (1 - shares) + corners[b] * shares
                for shift in (0.0, 8.0):
                    at = mgdt.LinearNDInterpolator(points + shift, values)
                    np.testing.assert_allclose(at(places + shift), field(places), atol=1e-13)
                exact = mgdt.LinearNDInterpolator(points, values, tol=0)(places)
                bare += int(np.isnan(exact).sum())
                np.testing.assert_array_equal(exact, mgdt.Delaunay(points).interpolate(values, places))
                for method in ("sibson", "linear"):
                    found = mgdt.griddata(points, values, places, method)
                    np.testing.assert_allclose(found, field(places), atol=1e-12)
        self.assertGreater(bare, 50)
        # No farther than the tolerance, which is 100 units in the last place of the extent.
        at = mgdt.LinearNDInterpolator(points, values)
        self.assertAlmostEqual(at.tol, 100 * 2.0**-52, delta=1e-15)
        off = np.array([[-1.0, -1, -1]]) / np.sqrt(3)
        self.assertFalse(np.isnan(at(off * at.tol * 0.9)).any())
        self.assertTrue(np.isnan(at(off * at.tol * 1.1)).all())
        wide = mgdt.LinearNDInterpolator(points, values, tol=0.5)
        np.testing.assert_allclose(wide(off * 0.4), field(np.zeros((1, 3))), atol=1e-12)
        self.assertTrue(np.isnan(wide(off * 0.6)).all())
        self.assertEqual(mgdt.LinearNDInterpolator(points, values, -7)(5, 5, 5), -7)

    def test_outside_and_fill_value(self):
        beyond = [[5.0, 5, 5]]
        for outside in OUTSIDES[1:]:
            expected = mgdt.Delaunay(self.points).interpolate(self.real, beyond, outside=outside)
            at = mgdt.LinearNDInterpolator(self.points, self.real, outside=outside)
            np.testing.assert_array_equal(at(beyond), expected)
            np.testing.assert_array_equal(
                mgdt.griddata(self.points, self.real, beyond, outside=outside), expected
            )
        tri = mgdt.Delaunay(self.points)
        for call in (
            lambda: mgdt.LinearNDInterpolator(self.points, self.real, fill_value="x"),
            lambda: mgdt.NaturalNeighborInterpolator(self.points, self.real, "x"),
            lambda: mgdt.griddata(self.points, self.real, beyond, fill_value="x"),
            lambda: tri.interpolate(self.real, beyond, "x"),
            lambda: tri.interpolator(beyond)(self.real, [1.0, 2.0]),
        ):
            with self.assertRaisesRegex(TypeError, "fill_value is .*; it must be a number"):
                call()
        for tol in (-1, np.nan):
            with self.assertRaisesRegex(ValueError, "tol is"):
                mgdt.LinearNDInterpolator(self.points, self.real, tol=tol)

    def test_one_rule_for_places_that_are_not_finite(self):
        """They are outside, for every method; masked arrays are refused by all."""
        tri = mgdt.Delaunay(self.points)
        inside = self.points.mean(axis=0)
        places = np.array([inside, [np.nan, 0, 0], [0.5, np.inf, 0], inside])
        nowhere = [1, 2]
        self.assertEqual(tri.find_simplex(places)[nowhere].tolist(), [-1, -1])
        simplices, weights = tri.locate(places)
        self.assertEqual(simplices[nowhere].tolist(), [-1, -1])
        self.assertEqual(np.abs(weights[nowhere]).max(), 0)
        self.assertEqual(tri.nearest_vertex(places)[nowhere].tolist(), [-1, -1])
        self.assertGreaterEqual(tri.nearest_vertex(places)[[0, 3]].min(), 0)
        offsets, indices, some = tri.interpolation_weights(places)
        self.assertEqual(np.diff(offsets).tolist(), [4, 0, 0, 4])
        np.testing.assert_array_equal(indices[:4], indices[4:])
        self.assertEqual(len(some), 8)
        for method in METHODS:
            found = tri.interpolate(self.real, places, method=method, outside="nearest")
            self.assertEqual(np.isnan(found).tolist(), [False, True, True, False])
        nearest = mgdt.NearestNDInterpolator(self.points, self.real)
        self.assertEqual(np.isnan(nearest(places)).tolist(), [False, True, True, False])
        several = mgdt.NearestNDInterpolator(self.points, np.stack([self.real, self.real], axis=1))
        self.assertEqual(np.isnan(several(places)).all(axis=1).tolist(), [False, True, True, False])
        with self.assertRaisesRegex(ValueError, "a place is not finite"):
            mgdt.NearestNDInterpolator(self.points, np.arange(len(self.points)))(places)
        masked, values = np.ma.array(places), np.ma.array(self.real)
        for call in (
            lambda: tri.find_simplex(masked), lambda: tri.locate(masked),
            lambda: tri.nearest_vertex(masked), lambda: tri.interpolation_weights(masked),
            lambda: tri.interpolator(masked), lambda: tri.interpolate(self.real, masked),
            lambda: tri.interpolate(values, places), lambda: tri.gradients(values),
            lambda: mgdt.LinearNDInterpolator(self.points, values),
            lambda: mgdt.LinearNDInterpolator(self.points, self.real)(masked),
            lambda: mgdt.NearestNDInterpolator(self.points, values), lambda: nearest(masked),
            lambda: nearest(*masked.T), lambda: mgdt.griddata(self.points, self.real, masked),
        ):
            with self.assertRaisesRegex(ValueError, "cannot be a masked array"):
                call()

    def test_natural_neighbors(self):
        corners = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).reshape(3, 8).T
        points = np.concatenate([self.points, corners])
        smooth = np.sin(points).sum(axis=1)
        places = np.clip(self.places, 0, 1)
        errors = {}
        for method in ("sibson", "laplace", "sibson_c1"):
            at = mgdt.NaturalNeighborInterpolator(points, smooth, method=method)
            self.assertFalse(np.isnan(at(places)).any())
            errors[method] = np.abs(at(places) - np.sin(places).sum(axis=-1)).max()
            self.assertTrue(np.isnan(at(2, 2, 2)))
            np.testing.assert_array_equal(
                mgdt.griddata(points, smooth, places, method), at(places)
            )
        self.assertLess(max(errors.values()), 0.2)
        self.assertLess(errors["sibson_c1"], errors["sibson"])
        on = mgdt.NaturalNeighborInterpolator(points, points[:, 0], outside="linear", rescale=True)
        np.testing.assert_allclose(on([[3, 0.5, 0.5], [-9, 7, 0.5]]), [3, -9], atol=1e-12)

    def test_refused(self):
        for maker in (mgdt.LinearNDInterpolator, mgdt.NaturalNeighborInterpolator):
            with self.assertRaisesRegex(ValueError, "there are 300 points"):
                maker(self.points, self.real[1:])
            with self.assertRaisesRegex(ValueError, "rescale is not supported"):
                maker(mgdt.Delaunay(self.points), self.real, rescale=True)
            with self.assertRaisesRegex(ValueError, "must have 3 coordinates"):
                maker(self.points, self.real)(0, 0)
        with self.assertRaisesRegex(ValueError, "there are 300 points"):
            mgdt.NearestNDInterpolator(self.points, self.real[1:])
        with self.assertRaisesRegex(ValueError, "method is 'cubic'"):
            mgdt.NaturalNeighborInterpolator(self.points, self.real, method="cubic")


if __name__ == "__main__":
    unittest.main()
