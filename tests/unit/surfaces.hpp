// SPDX-License-Identifier: MIT
// Boundaries of domains, made for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "domain/domain.hpp"
#include "solid/mesh_check.hpp"
#include "unwatched.hpp"

namespace mgdt {

// A domain and the mesh of its last build.
class MeshedDomain : public Domain {
  public:
    MeshedDomain() : Domain(nullptr, nullptr, nullptr) {}
    void build() {
        mesh_ = SolidMesh(memory_);
        Domain::build(mesh_);
    }
    // Checks the mesh, and compares it with the domain.
    void check() const {
        check_mesh(mesh_, settings().index_base, allocator(), Unwatched());
        Domain::check(mesh_, Unwatched());
    }
    SolidMesh& mesh() { return mesh_; }
    const SolidMesh& mesh() const { return mesh_; }

  private:
    Allocator memory_;
    SolidMesh mesh_{memory_};
};

struct Surface {
    explicit Surface(std::string of) : name(std::move(of)) {}

    std::string name;
    std::vector<double> points;
    std::vector<std::vector<std::uint32_t>> facets;
    std::vector<std::int32_t> markers;
    std::vector<std::uint32_t> segments;
    std::vector<double> holes;
    double volume = -1;       // of the inside, if it is known
    std::size_t regions = 1;  // of the inside; 0 if the number is not known

    std::uint32_t point(double x, double y, double z) {
        for (const double c : {x, y, z}) points.push_back(c);
        return static_cast<std::uint32_t>(points.size() / 3 - 1);
    }
    void facet(std::vector<std::uint32_t> corners, std::int32_t marker = 0) {
        facets.push_back(std::move(corners));
        markers.push_back(marker);
    }
};

// Adds the box from a to b with polygons as sides, and returns its first point.
inline std::uint32_t add_box(Surface& s, const double (&a)[3], const double (&b)[3]) {
    std::uint32_t v[8];
    for (unsigned i = 0; i < 8; ++i)
        v[i] = s.point((i & 1) != 0 ? b[0] : a[0], (i & 2) != 0 ? b[1] : a[1],
                       (i & 4) != 0 ? b[2] : a[2]);
    s.facet({v[0], v[2], v[3], v[1]});
    s.facet({v[4], v[5], v[7], v[6]});
    s.facet({v[0], v[1], v[5], v[4]});
    s.facet({v[2], v[6], v[7], v[3]});
    s.facet({v[0], v[4], v[6], v[2]});
    s.facet({v[1], v[3], v[7], v[5]});
    return v[0];
}

inline Surface cube() {
    Surface s{"cube"};
    add_box(s, {0, 0, 0}, {1, 1, 1});
    s.volume = 1;
    return s;
}

inline Surface plate() {
    Surface s{"plate of 1e-6"};
    add_box(s, {0, 0, 0}, {1, 1, 1e-6});
    s.volume = 1e-6;
    return s;
}

inline void rotate(Surface& s, double a, double b) {
    for (std::size_t i = 0; i < s.points.size(); i += 3) {
        double* const p = s.points.data() + i;
        const double x = p[0] * std::cos(a) - p[1] * std::sin(a),
                     y = p[0] * std::sin(a) + p[1] * std::cos(a), z = p[2];
        p[0] = x;
        p[1] = y * std::cos(b) - z * std::sin(b);
        p[2] = y * std::sin(b) + z * std::cos(b);
    }
}

// Boxes inside of boxes; `hollow` ones are holes, the others are regions.
inline Surface nested_shells(int shells, bool hollow) {
    Surface s{hollow ? "hollow shells" : "nested shells"};
    for (int i = 0; i < shells; ++i) {
        const double r = shells - i;
        add_box(s, {-r, -r, -r}, {r, r, r});
    }
    s.regions = static_cast<std::size_t>(shells);
    s.volume = 8.0 * shells * shells * shells;
    if (hollow) {
        for (const double x : {0.1, 0.2, 0.3}) s.holes.push_back(x);
        s.volume -= 8;
        s.regions -= 1;
    }
    rotate(s, 0.3, 0.7);
    if (hollow)
        for (double& x : s.holes) x = 0;
    return s;
}

// A box with a square tunnel through it.
inline Surface tunnel() {
    Surface s{"tunnel in a rotated box"};
    std::uint32_t out[2][4], in[2][4];
    const double x[4] = {0, 3, 3, 0}, y[4] = {0, 0, 3, 3}, u[4] = {1, 2, 2, 1}, v[4] = {1, 1, 2, 2};
    for (int z = 0; z < 2; ++z)
        for (int i = 0; i < 4; ++i) {
            out[z][i] = s.point(x[i], y[i], 3 * z);
            in[z][i] = s.point(u[i], v[i], 3 * z);
        }
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        s.facet({out[0][i], out[0][j], out[1][j], out[1][i]});
        s.facet({in[0][j], in[0][i], in[1][i], in[1][j]});
        s.facet({out[0][j], out[0][i], in[0][i], in[0][j]});
        s.facet({out[1][i], out[1][j], in[1][j], in[1][i]});
    }
    s.volume = 27 - 3;
    rotate(s, 0.4, 1.1);
    return s;
}

// The same box, whose ends are one polygon each that walks to the tunnel and back.
inline Surface keyhole() {
    Surface s = tunnel();
    s.name = "keyhole polygons";
    s.facets.clear();
    s.markers.clear();
    // The numbers are those of tunnel(): for each z and each i an outer and an inner corner.
    const auto out = [](int z, int i) { return static_cast<std::uint32_t>(8 * z + 2 * (i % 4)); };
    const auto in = [&](int z, int i) { return out(z, i) + 1; };
    for (int i = 0; i < 4; ++i) {
        s.facet({out(0, i), out(0, i + 1), out(1, i + 1), out(1, i)});
        s.facet({in(0, i + 1), in(0, i), in(1, i), in(1, i + 1)});
    }
    for (int z = 0; z < 2; ++z)
        s.facet({out(z, 0), out(z, 1), out(z, 2), out(z, 3), out(z, 0), in(z, 0), in(z, 3),
                 in(z, 2), in(z, 1), in(z, 0)});
    return s;
}

// Schoenhardt's polyhedron: a twisted prism that no tetrahedra fill without more points.
inline Surface schoenhardt(double twist) {
    Surface s{"Schoenhardt's polyhedron"};
    const double third = 2 * std::acos(-1.0) / 3;
    for (int z = 0; z < 2; ++z)
        for (int i = 0; i < 3; ++i)
            s.point(std::cos(third * i + z * twist), std::sin(third * i + z * twist), z);
    s.facet({0, 2, 1});
    s.facet({3, 4, 5});
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t j = (i + 1) % 3;
        s.facet({i, j, 3 + i});
        s.facet({j, 3 + j, 3 + i});
    }
    return s;
}

// Chazelle's polyhedron: a box with n wedges cut from above and n from below, whose edges are on
// two hyperbolic paraboloids that nearly touch.
inline Surface chazelle(int n) {
    Surface s{"Chazelle's polyhedron"};
    const double size = n + 1, gap = 0.125;
    // Ridges along x at z = x y + gap cut from above, along y at z = x y - gap from below.
    const double high = size * size + 2, low = -2;
    const auto u = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { s.facet({a, b, c}); };
    // The roof: strips between ridges y = j, each with a valley to `high` between them.
    std::vector<std::uint32_t> front, back;  // along y, at x = 0 and at x = size
    for (int j = 0; j <= 2 * n; ++j) {
        const double y = 0.5 + 0.5 * j, w = j % 2 == 1 ? 1 : 0;
        const double y0 = y, z0 = w != 0 ? gap : high, z1 = w != 0 ? size * y0 + gap : high;
        front.push_back(s.point(0, y0, z0));
        back.push_back(s.point(size, y0, z1));
    }
    for (std::size_t j = 0; j + 1 < front.size(); ++j) {
        u(front[j], back[j], back[j + 1]);
        u(front[j], back[j + 1], front[j + 1]);
    }
    std::vector<std::uint32_t> left, right;  // along x, at the least and the greatest y
    for (int i = 0; i <= 2 * n; ++i) {
        const double x = 0.5 + 0.5 * i;
        const double y0 = 0.5, y1 = 0.5 + n;
        const bool is_ridge = i % 2 == 1;
        left.push_back(s.point(x, y0, is_ridge ? x * y0 - gap : low));
        right.push_back(s.point(x, y1, is_ridge ? x * y1 - gap : low));
    }
    for (std::size_t i = 0; i + 1 < left.size(); ++i) {
        u(left[i], left[i + 1], right[i + 1]);
        u(left[i], right[i + 1], right[i]);
    }
    // Walls: the four sides, as polygons; those at x = 0 and x = size end at the roof, those at the
    // ends of y end at the floor.
    const std::uint32_t a = s.point(0, 0.5, low), b = s.point(size, 0.5, low),
                        c = s.point(0, 0.5 + n, low), d = s.point(size, 0.5 + n, low);
    std::vector<std::uint32_t> wall(front.begin(), front.end());
    wall.push_back(c);
    wall.push_back(a);
    s.facet(wall);
    wall.assign(back.begin(), back.end());
    wall.push_back(d);
    wall.push_back(b);
    s.facet(wall);
    wall = {front.front(), a};
    wall.insert(wall.end(), left.begin(), left.end());
    wall.push_back(b);
    wall.push_back(back.front());
    s.facet(wall);
    wall = {front.back(), c};
    wall.insert(wall.end(), right.begin(), right.end());
    wall.push_back(d);
    wall.push_back(back.back());
    s.facet(wall);
    // The floor beside the first and the last ridge.
    s.facet({a, left.front(), right.front(), c});
    s.facet({b, left.back(), right.back(), d});
    return s;
}

// Thin needles that meet at one point, with random lengths from the shortest to 1.
inline Surface needles(int n, double shortest = 1) {
    Surface s{"needles at a vertex"};
    const std::uint32_t o = s.point(0, 0, 0);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> length(shortest, 1);
    double volume = 0;
    for (int i = 0; i < n; ++i) {
        // Directions on a spiral over the sphere, so that no two are near each other.
        const double z = 1 - 2 * (i + 0.5) / n, r = std::sqrt(1 - z * z), turn = 2.39996 * i;
        const double d[3] = {r * std::cos(turn), r * std::sin(turn), z};
        const double e[3] = {-std::sin(turn), std::cos(turn), 0};
        const double f[3] = {d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2],
                             d[0] * e[1] - d[1] * e[0]};
        std::uint32_t v[3];
        const double h = length(random), width = 0.02, third = 2 * std::acos(-1.0) / 3;
        for (int k = 0; k < 3; ++k) {
            const double p = width * std::cos(third * k), q = width * std::sin(third * k);
            v[k] = s.point(h * (d[0] + p * e[0] + q * f[0]), h * (d[1] + p * e[1] + q * f[1]),
                           h * (d[2] + p * e[2] + q * f[2]));
        }
        s.facet({v[0], v[1], v[2]});
        for (int k = 0; k < 3; ++k) s.facet({o, v[(k + 1) % 3], v[k]});
        volume += std::sqrt(3.0) * 0.75 * width * width / 3 * h * h * h;
    }
    s.volume = volume;
    s.regions = static_cast<std::size_t>(n);
    return s;
}

// A box with facets in it that bound nothing, one of them attached to a side, and a wire.
inline Surface dangling() {
    Surface s{"dangling facets and a wire"};
    add_box(s, {0, 0, 0}, {4, 4, 4});
    const std::uint32_t a = s.point(1, 1, 1), b = s.point(3, 1, 1), c = s.point(2, 3, 1.5),
                        d = s.point(2, 2, 3);
    s.facet({a, b, c}, 5);
    s.facet({b, c, d}, 6);
    // The edge from a corner of the box to d is a part of no facet.
    s.segments = {0, d};
    s.volume = 64;
    return s;
}

inline Surface touching_cubes() {
    Surface s{"touching cubes"};
    add_box(s, {0, 0, 0}, {1, 1, 1});
    // One that shares an edge, one that shares a corner, both by equal points.
    add_box(s, {1, 1, 0}, {2, 2, 1});
    add_box(s, {-1, -1, -1}, {0, 0, 0});
    s.volume = 3;
    s.regions = 3;
    return s;
}

// Cubes in a block that share whole sides, as grains do.
inline Surface grains(int n) {
    Surface s{"grains"};
    const auto at = [&](int x, int y, int z) {
        return static_cast<std::uint32_t>((x * (n + 1) + y) * (n + 1) + z);
    };
    for (int x = 0; x <= n; ++x)
        for (int y = 0; y <= n; ++y)
            for (int z = 0; z <= n; ++z) s.point(x, y, z);
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j < n; ++j)
                for (int k = 0; k < n; ++k) {
                    const auto corner = [&](int dj, int dk) {
                        int p[3];
                        p[axis] = i;
                        p[(axis + 1) % 3] = j + dj;
                        p[(axis + 2) % 3] = k + dk;
                        return at(p[0], p[1], p[2]);
                    };
                    s.facet({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, axis);
                }
    s.volume = n * n * n;
    s.regions = static_cast<std::size_t>(n * n * n);
    return s;
}

// A torus of n times m quadrilaterals that are not planar.
inline Surface torus(int n, int m) {
    Surface s{"torus"};
    const double turn = 2 * std::acos(-1.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const double u = turn * i / n, v = turn * (j + 0.3 * i) / m;
            s.point((3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v));
        }
    const auto at = [&](int i, int j) {
        // The turn by 0.3 for each i adds up to a whole number of steps.
        const int shift = i >= n ? static_cast<int>(std::lround(0.3 * n)) : 0;
        return static_cast<std::uint32_t>((i % n) * m + ((j + shift) % m));
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j)
            s.facet({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return s;
}

// A star with n spikes of random length over the triangles of an icosahedron, divided once.
inline Surface spiky(double height) {
    Surface s{"spikes"};
    const double g = (1 + std::sqrt(5.0)) / 2;
    const double corner[12][3] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                  {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                  {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    const std::uint32_t side[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (const auto& c : corner) s.point(c[0], c[1], c[2]);
    for (const auto& t : side) {
        double x[3] = {0, 0, 0};
        for (const std::uint32_t v : t)
            for (int k = 0; k < 3; ++k) x[k] += corner[v][k] * height / 3;
        const std::uint32_t top = s.point(x[0], x[1], x[2]);
        for (int k = 0; k < 3; ++k) s.facet({t[k], t[(k + 1) % 3], top});
    }
    return s;
}

// A large square below a dense cloud of small boxes: the square is missing nearly everywhere.
inline Surface city(int n) {
    Surface s{"city on a large square"};
    add_box(s, {-1, -1, -1}, {n + 1.0, n + 1.0, 0});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> height(0.01, 0.4);
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y) {
            const double z = height(random), d = height(random) / 2, under = x % 2 == 0 ? 1 : -1;
            const double low = under > 0 ? d : -d - z;
            add_box(s, {x + 0.1, y + 0.1, low}, {x + 0.7, y + 0.8, low + z});
        }
    s.regions = 0;
    return s;
}

// A square among points on both sides of it, which is missing, and through which many edges pass.
inline Surface square_in_a_cloud(int n) {
    Surface s("square in a cloud");
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int i = 0; i < n; ++i) {
        const double x = place(random), y = place(random), z = place(random);
        s.point(x, y, 0.2 * z);
    }
    const double corner[3] = {3, 3, 3};
    add_box(s, {-3, -3, -3}, corner);
    const std::uint32_t a = s.point(-2, -2, 0), b = s.point(2, -2, 0), c = s.point(2, 2, 0),
                        d = s.point(-2, 2, 0);
    s.facet({a, b, c, d});
    s.volume = 216;
    return s;
}

// A prism over a star polygon with n tips.
inline Surface star_prism(int n, double inner) {
    Surface s{"prism over a star"};
    std::vector<std::uint32_t> ring[2];
    for (int z = 0; z < 2; ++z)
        for (int i = 0; i < 2 * n; ++i) {
            const double r = i % 2 == 0 ? 1 : inner, a = std::acos(-1.0) * i / n;
            ring[z].push_back(s.point(r * std::cos(a), r * std::sin(a), z));
        }
    s.facet({ring[0].rbegin(), ring[0].rend()});
    s.facet(ring[1]);
    for (std::size_t i = 0; i < ring[0].size(); ++i) {
        const std::size_t j = (i + 1) % ring[0].size();
        s.facet({ring[0][i], ring[0][j], ring[1][j], ring[1][i]});
    }
    s.volume = n * inner * std::sin(std::acos(-1.0) / n);
    return s;
}

// A box with a wall inside, whose edges are on the sides, so that it divides the box.
inline Surface divided_box() {
    Surface s{"box divided by a wall"};
    const std::uint32_t a = s.point(0, 0, 0), b = s.point(2, 0, 0), c = s.point(2, 1, 0),
                        d = s.point(0, 1, 0), e = s.point(0, 0, 1), f = s.point(2, 0, 1),
                        g = s.point(2, 1, 1), h = s.point(0, 1, 1), p = s.point(0.9, 0, 0),
                        q = s.point(1.1, 1, 0), r = s.point(1.1, 1, 1), t = s.point(0.9, 0, 1);
    s.facet({a, d, q, p}, 1);
    s.facet({p, q, c, b}, 1);
    s.facet({e, t, r, h}, 2);
    s.facet({t, f, g, r}, 2);
    s.facet({a, p, t, e}, 3);
    s.facet({p, b, f, t}, 3);
    s.facet({d, h, r, q}, 4);
    s.facet({q, r, g, c}, 4);
    s.facet({a, e, h, d}, 5);
    s.facet({b, c, g, f}, 6);
    s.facet({p, q, r, t}, 7);
    s.volume = 2;
    s.regions = 2;
    return s;
}

// Random boxes on a lattice that do not meet.
inline Surface scattered_boxes(int n, unsigned seed) {
    Surface s{"scattered boxes"};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.05, 0.45);
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z) {
                const double a[3] = {x + part(random), y + part(random), z + part(random)};
                const double b[3] = {x + 1 - part(random), y + 1 - part(random),
                                     z + 1 - part(random)};
                add_box(s, a, b);
            }
    s.regions = static_cast<std::size_t>(n * n * n);
    return s;
}

inline std::vector<Surface> test_surfaces() {
    std::vector<Surface> all = {cube(),
                                plate(),
                                nested_shells(3, false),
                                nested_shells(3, true),
                                tunnel(),
                                keyhole(),
                                schoenhardt(0.5),
                                schoenhardt(1.04),
                                chazelle(2),
                                chazelle(5),
                                needles(12),
                                needles(40),
                                needles(80, 0.3),
                                dangling(),
                                touching_cubes(),
                                grains(3),
                                torus(30, 12),
                                torus(10, 5),
                                spiky(0.3),
                                spiky(3),
                                spiky(20),
                                city(6),
                                square_in_a_cloud(500),
                                star_prism(5, 0.4),
                                star_prism(12, 0.1),
                                divided_box(),
                                scattered_boxes(3, 1)};
    for (unsigned seed = 2; seed < 5; ++seed) {
        all.push_back(scattered_boxes(2, seed));
        rotate(all.back(), seed, 2 * seed);
    }
    return all;
}

inline void give(Domain& domain, const Surface& s) {
    DomainInput& input = domain.input();
    for (const double x : s.points) input.points.push_back(x);
    input.facet_begin.push_back(0);
    for (std::size_t f = 0; f < s.facets.size(); ++f) {
        for (const std::uint32_t v : s.facets[f]) input.corners.push_back(v);
        input.facet_begin.push_back(static_cast<std::uint32_t>(input.corners.size()));
        input.facet_markers.push_back(s.markers[f]);
    }
    for (std::size_t i = 0; i < s.segments.size(); ++i) {
        input.segments.push_back(s.segments[i]);
        if (i % 2 == 0) input.segment_markers.push_back(static_cast<std::int32_t>(i));
    }
    for (std::size_t i = 0; i < s.holes.size(); i += 3)
        input.holes.push_back({{s.holes[i], s.holes[i + 1], s.holes[i + 2]}, 0});
}

// The status and the message of a call, MGDT_OK if it does not fail.
template <class Call>
Error error_of(Call call) {
    try {
        call();
    } catch (const Error& e) {
        return e;
    }
    return {MGDT_OK, ""};
}

}  // namespace mgdt
