// SPDX-License-Identifier: MIT
// Exact geometric predicates: each returns the sign (-1, 0, +1) of a determinant of the coordinates
// it is given, as if computed with real numbers. Every finite double is accepted, from subnormals
// to the largest. A point is a pointer to its three coordinates.
//
// The kernel calls a predicate only if its own filter has left a decision open, so ties may be as
// frequent as other results.
#pragma once

namespace mgdt {

// The sign of (b - a) x (c - a) . (d - a), which is positive for a positively oriented tetrahedron.
int orientation(const double* a, const double* b, const double* c, const double* d);

// For a positively oriented tetrahedron abcd: +1 if q is inside its circumsphere, 0 on it, -1
// outside.
int side_of_sphere(const double* a, const double* b, const double* c, const double* d,
                   const double* q);

// Like side_of_sphere(), but ties are broken by symbolic perturbation (Devillers and Teillaud,
// Computational Geometry 44, 2011). The result is 0 only if q is equal to a, b, c or d.
int side_of_sphere_perturbed(const double* a, const double* b, const double* c, const double* d,
                             const double* q);

// Whether three points are on one line (equal points included).
bool collinear(const double* a, const double* b, const double* c);

// The signs of the three coordinates of (b - a) x (c - a): how a, b and c turn as seen along each
// axis. They are not exact: 0 also stands for a sign that a filter leaves open.
void find_rough_turns(const double* a, const double* b, const double* c, int (&turns)[3]);

// Compares the coordinates x, then y, then z: the order of the perturbation. 0 equals -0.
int compare_lexicographic(const double* a, const double* b);

// The sign of |q - a|^2 - |q - b|^2.
int compare_distance(const double* q, const double* a, const double* b);

// The sign of |a - b|^2 - |c - d|^2.
int compare_lengths(const double* a, const double* b, const double* c, const double* d);

// For the sphere with the diameter ab: +1 if q is inside, 0 on it, -1 outside.
int side_of_diametral_sphere(const double* a, const double* b, const double* q);

// For the plane through the edge ab that is perpendicular to the triangle abc: +1 if q is on the
// side of c, 0 on the plane, -1 on the other side.
int side_of_edge(const double* a, const double* b, const double* c, const double* q);

}  // namespace mgdt
