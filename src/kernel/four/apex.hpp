// SPDX-License-Identifier: MIT
// Finds the apex of a facet, testing four vertices at a time: see kernel/apex.hpp.
#pragma once

#include "kernel/four.hpp"
#include "kernel/sphere_columns.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Spheres through the vertices a, b and c of the facet intersect the half-space beyond the facet in
// nested caps. So the vertices e beyond the facet can be ordered by a number: the power of e with
// respect to any one of these spheres, divided by the distance between e and the plane of the
// facet. The vertex with the least computed number is a candidate. It is the apex if the powers of
// all other vertices with respect to the candidate's sphere are positive by more than their error
// bounds.
inline ApexResult find_apex(const HoleColumns& vertices, const std::uint32_t (&facet)[3]) {
    const auto corner = [&](std::uint32_t k) {
        return PointColumns<double>{vertices.x[k], vertices.y[k], vertices.z[k]};
    };
    const PointColumns<double> a = corner(facet[0]), b = corner(facet[1]), c = corner(facet[2]);
    const LocalVertex rb = local_vertex(b.x - a.x, b.y - a.y, b.z - a.z),
                      rc = local_vertex(c.x - a.x, c.y - a.y, c.z - a.z);
    // (a, c, b, e) is positively oriented for e beyond: n . (e - a) > 0.
    const double nx = rc.y * rb.z - rc.z * rb.y, ny = rc.z * rb.x - rc.x * rb.z,
                 nz = rc.x * rb.y - rc.y * rb.x;
    const double side_bound = proved_bounds.sphere_det * unit_roundoff * (rb.largest * rc.largest);
    // The sphere with its centre in the plane: w = (|b|^2 n x c + |c|^2 b x n) / |n|^2 for n = c x
    // b.
    const double scale = reciprocal(nx * nx + ny * ny + nz * nz);
    const double px = rc.square * rb.x - rb.square * rc.x, py = rc.square * rb.y - rb.square * rc.y,
                 pz = rc.square * rb.z - rb.square * rc.z;
    const double wx = (ny * pz - nz * py) * -scale, wy = (nz * px - nx * pz) * -scale,
                 wz = (nx * py - ny * px) * -scale;

    std::uint64_t skipped[] = {vertices.skipped[0], vertices.skipped[1]};
    const auto skip = [&](std::uint32_t k) { skipped[k / 64] |= std::uint64_t{1} << (k % 64); };
    for (const std::uint32_t k : facet) skip(k);
    // A bit for each of four elements that counts.
    const auto counted = [&](std::size_t begin) {
        return static_cast<std::uint32_t>(~skipped[begin / 64] >> (begin % 64)) & 15;
    };

    const Four none(infinity);
    std::uint32_t some_beyond = 0;
    Four least = none, at(0.0);
    Four k(0.0, 1.0, 2.0, 3.0);
    std::uint32_t open = 0;
    for (std::size_t begin = 0; begin < vertices.size; begin += 4, k = k + Four(4.0)) {
        const Four ux = Four::load(vertices.x + begin) - Four(a.x),
                   uy = Four::load(vertices.y + begin) - Four(a.y),
                   uz = Four::load(vertices.z + begin) - Four(a.z);
        const Four side = multiply_add(uz, Four(nz), multiply_add(uy, Four(ny), ux * Four(nx)));
        const Four bound =
            Four(side_bound) * larger(magnitude(ux), larger(magnitude(uy), magnitude(uz)));
        const Four square = multiply_add(uz, uz, multiply_add(uy, uy, ux * ux));
        const Four dot = multiply_add(uz, Four(wz), multiply_add(uy, Four(wy), ux * Four(wx)));
        open |= ~(magnitude(side) > bound).bits() & counted(begin);
        // False for the corners of the facet, where the error bound covers all of the side.
        const FourMask is_beyond = side > bound;
        some_beyond |= is_beyond.bits();
        const Four order = where(is_beyond, (square - dot) / side, none);
        const FourMask is_less = least > order;
        least = where(is_less, order, least);
        at = where(is_less, k, at);
    }
    if (open != 0) return {no_apex, {}};
    if (some_beyond == 0) return {infinite_apex, {}};
    const double best = -largest_element(Four(0.0) - least);
    if (!(best < infinity)) return {no_apex, {}};
    alignas(32) double numbers[4];
    at.store(numbers);
    const auto apex = static_cast<std::uint32_t>(numbers[lowest_bit((least == Four(best)).bits())]);

    ApexResult result;
    result.number = apex;
    const PointColumns<double> e = corner(apex);
    set_sphere(rc, rb, local_vertex(e.x - a.x, e.y - a.y, e.z - a.z), result.sphere);
    const Sphere& s = result.sphere;
    skip(apex);
    const Four quadratic(proved_bounds.quadratic * unit_roundoff);
    std::uint32_t inside = 0;
    for (std::size_t begin = 0; begin < vertices.size; begin += 4) {
        const Four ux = Four::load(vertices.x + begin) - Four(a.x),
                   uy = Four::load(vertices.y + begin) - Four(a.y),
                   uz = Four::load(vertices.z + begin) - Four(a.z);
        const Four square = multiply_add(uz, uz, multiply_add(uy, uy, ux * ux));
        const Four dot =
            multiply_add(uz, Four(s.w[2]), multiply_add(uy, Four(s.w[1]), ux * Four(s.w[0])));
        const Four error = multiply_add(Four(s.e), magnitude(ux) + magnitude(uy) + magnitude(uz),
                                        quadratic * square);
        inside |= ~((square - dot) > error).bits() & counted(begin);
    }
    if (inside != 0) result.number = no_apex;
    return result;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
