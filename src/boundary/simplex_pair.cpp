// SPDX-License-Identifier: MIT
#include "boundary/simplex_pair.hpp"

#include <algorithm>

#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
namespace {

using Point = const double*;

// Whether p, on the line through a and b, is between them or equal to one of them.
bool is_between(Point a, Point b, Point p) {
    return compare_lexicographic(a, p) * compare_lexicographic(p, b) >= 0;
}

bool is_on_segment(Point a, Point b, Point p) {
    return collinear(a, b, p) && is_between(a, b, p);
}

// Whether p, in the plane of a, b and c, is in the cone of the rays from a through b and c.
bool is_in_plane_cone(Point a, Point b, Point c, Point p) {
    return side_of_edge(a, b, c, p) >= 0 && side_of_edge(a, c, b, p) >= 0;
}

// Whether p, in the plane of the triangle, is in it.
bool is_in_plane_triangle(const Point (&t)[3], Point p) {
    return is_in_plane_cone(t[0], t[1], t[2], p) && side_of_edge(t[1], t[2], t[0], p) >= 0;
}

// Whether two segments in one plane have a common point.
bool plane_segments_meet(Point a, Point b, Point c, Point d) {
    if (is_on_segment(a, b, c) || is_on_segment(a, b, d) || is_on_segment(c, d, a) ||
        is_on_segment(c, d, b))
        return true;
    if (collinear(a, b, c) || collinear(a, b, d) || collinear(c, d, a) || collinear(c, d, b))
        return false;
    return side_of_edge(a, b, c, d) < 0 && side_of_edge(c, d, a, b) < 0;
}

bool segments_meet(Point a, Point b, Point c, Point d) {
    return orientation(a, b, c, d) == 0 && plane_segments_meet(a, b, c, d);
}

bool segment_meets_triangle(Point p, Point q, const Point (&t)[3]) {
    const int of_p = orientation(t[0], t[1], t[2], p), of_q = orientation(t[0], t[1], t[2], q);
    if (of_p * of_q > 0) return false;
    if (of_p == 0 && is_in_plane_triangle(t, p)) return true;
    if (of_q == 0 && is_in_plane_triangle(t, q)) return true;
    if (of_p == 0 && of_q == 0)
        return plane_segments_meet(p, q, t[0], t[1]) || plane_segments_meet(p, q, t[1], t[2]) ||
               plane_segments_meet(p, q, t[2], t[0]);
    if (of_p == 0 || of_q == 0) return false;
    const int sides[3] = {orientation(p, q, t[0], t[1]), orientation(p, q, t[1], t[2]),
                          orientation(p, q, t[2], t[0])};
    return std::min({sides[0], sides[1], sides[2]}) >= 0 ||
           std::max({sides[0], sides[1], sides[2]}) <= 0;
}

bool triangles_meet(const Point (&s)[3], const Point (&t)[3]) {
    for (int i = 0; i < 3; ++i)
        if (segment_meets_triangle(s[i], s[(i + 1) % 3], t) ||
            segment_meets_triangle(t[i], t[(i + 1) % 3], s))
            return true;
    return false;
}

// Whether the cone from a through b and c and that through d and e have a common ray.
bool cones_meet(Point a, Point b, Point c, Point d, Point e) {
    const int of_d = orientation(a, b, c, d), of_e = orientation(a, b, c, e);
    if (of_d * of_e > 0) return false;
    if (of_d == 0 && is_in_plane_cone(a, b, c, d)) return true;
    if (of_e == 0 && is_in_plane_cone(a, b, c, e)) return true;
    // In one plane, the cones are below a straight angle: if they meet, a side of one is in the
    // other.
    if (of_d == 0 && of_e == 0) return is_in_plane_cone(a, d, e, b) || is_in_plane_cone(a, d, e, c);
    if (of_d == 0 || of_e == 0) return false;
    // The cone of d and e has one ray in the plane of a, b and c. It is in their cone if b and c
    // are not on the wrong sides of the plane of a, d and e, which contains the ray. With a as the
    // origin and n = b x c, the ray is r = x d + y e for positive x and y. Let n.d > 0. Then r is
    // on the inner side of the ray through b if (b x r).d >= 0, that is [b e d] >= 0, and on that
    // of c if (r x c).d >= 0, that is [e c d] >= 0.
    if (of_d < 0) std::swap(d, e);
    return orientation(a, b, e, d) >= 0 && orientation(a, e, c, d) >= 0;
}

// Moves the corners that both simplices have to the front, in one order. Returns their number.
int bring_common_first(Simplex& a, Simplex& b) {
    int common = 0;
    for (int i = 0; i < a.size; ++i)
        for (int j = common; j < b.size; ++j)
            if (a.number[i] == b.number[j]) {
                std::swap(a.number[i], a.number[common]);
                std::swap(a.x[i], a.x[common]);
                std::swap(b.number[j], b.number[common]);
                std::swap(b.x[j], b.x[common]);
                ++common;
                break;
            }
    return common;
}

bool are_disjoint(const Simplex& a, const Simplex& b) {
    if (a.size == 1 && b.size == 1) return true;
    if (b.size == 2) {
        return a.size == 1 ? !is_on_segment(b.x[0], b.x[1], a.x[0])
                           : !segments_meet(a.x[0], a.x[1], b.x[0], b.x[1]);
    }
    if (a.size == 1)
        return orientation(b.x[0], b.x[1], b.x[2], a.x[0]) != 0 ||
               !is_in_plane_triangle(b.x, a.x[0]);
    return a.size == 2 ? !segment_meets_triangle(a.x[0], a.x[1], b.x) : !triangles_meet(a.x, b.x);
}

// Whether two triangles, with `common` corners at the front in common, are on different sides of
// the line through corners i and j of the first, as seen along an axis, so that the common ones are
// all that they share. Only rounding may hide this.
bool are_beside_line(const Simplex& a, const Simplex& b, int common, int i, int j) {
    int own[3];
    find_rough_turns(a.x[i], a.x[j], a.x[3 - i - j], own);
    for (int k = common; k < 3; ++k) {
        int other[3];
        find_rough_turns(a.x[i], a.x[j], b.x[k], other);
        for (int axis = 0; axis < 3; ++axis)
            if (own[axis] * other[axis] >= 0) own[axis] = 0;
    }
    return own[0] != 0 || own[1] != 0 || own[2] != 0;
}

// Whether the other corners of b are on one side of the plane of the triangle a. Only rounding may
// hide this.
bool is_beside_plane(const Simplex& a, const Simplex& b, int common) {
    int sides = 0;
    for (int k = common; k < 3; ++k) {
        const int side = exact::orientation_filter(a.x[0], a.x[1], a.x[2], b.x[k]);
        if (side == exact::undecided) return false;
        sides += side;
    }
    return sides == 3 - common || sides == common - 3;
}

// Ends most pairs of triangles without the exact stages of predicates, which are slow for triangles
// in one plane.
bool are_clearly_apart(const Simplex& a, const Simplex& b, int common) {
    if (is_beside_plane(a, b, common)) return true;
    if (common == 2) return are_beside_line(a, b, common, 0, 1);
    for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 3; ++j) {
            if (i >= common && common > 0) continue;
            if (are_beside_line(a, b, common, i, j) || are_beside_line(b, a, common, i, j))
                return true;
        }
    return false;
}

}  // namespace

bool meet_in_common_face(const Simplex& first, const Simplex& second) {
    Simplex a = first, b = second;
    if (a.size > b.size) std::swap(a, b);
    const int common = bring_common_first(a, b);
    if (common == a.size || (a.size == 3 && are_clearly_apart(a, b, common))) return true;
    if (common == 0) return are_disjoint(a, b);
    const Point at = a.x[0];
    if (b.size == 2)  // two segments with a common end: one must not go on in the other's direction
        return !collinear(at, a.x[1], b.x[1]) || is_between(a.x[1], b.x[1], at);
    if (a.size == 2)
        return orientation(b.x[0], b.x[1], b.x[2], a.x[1]) != 0 ||
               !is_in_plane_cone(at, b.x[1], b.x[2], a.x[1]);
    if (common == 1) return !cones_meet(at, a.x[1], a.x[2], b.x[1], b.x[2]);
    // Two triangles with a common edge.
    return orientation(at, a.x[1], a.x[2], b.x[2]) != 0 ||
           side_of_edge(at, a.x[1], a.x[2], b.x[2]) < 0;
}

}  // namespace mgdt
