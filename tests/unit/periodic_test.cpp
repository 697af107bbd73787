// SPDX-License-Identifier: MIT
// Triangulations of points in periodic boxes, beside those of copies by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "../support/small.h"
#include "periodic/periodic_tetrahedra.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// A vertex of a periodic tetrahedron: a point, and which image of it.
struct Corner {
    std::uint32_t point;
    Multiples of;
    bool operator<(const Corner& other) const {
        return point != other.point ? point < other.point : of < other.of;
    }
    bool operator==(const Corner& other) const { return point == other.point && of == other.of; }
};
using Corners = std::array<Corner, 4>;

struct Box {
    std::string name;
    unsigned dimensions;
    std::vector<double> vectors;
    // How many images along each vector of the reduced basis, shortest first, show what the middle
    // one is.
    int copies[3];
};

std::vector<Box> boxes() {
    std::vector<Box> all = {
        {"cube", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {2, 2, 2}},
        {"brick", 3, {0, 2, 0, 3, 0, 0, 0, 0, 5}, {3, 2, 2}},
        {"oblique", 3, {1, 0, 0, 0.5, 0.75, 0, 0.25, 0.375, 0.625}, {2, 2, 2}},
        {"very oblique", 3, {1, 0, 0, 1000.25, 1, 0, 17.125, -33.5, 1}, {2, 2, 2}},
        {"rhombohedron", 3, {0, 1, 1, 1, 0, 1, 1, 1, 0}, {2, 2, 2}},
        {"plate", 3, {1, 0, 0, 0, 1, 0, 0, 0, 0.0625}, {20, 2, 2}},
        {"inclined plate", 3, {1, 0, 0, 0, 1, 0, 0.375, 0.25, 0.03125}, {40, 3, 2}},
        {"slab", 2, {1, 0, 0, 0, 1, 0}, {4, 4, 0}},
        {"inclined slab", 2, {1, 0, 0.5, 0.25, 1, -0.25}, {4, 4, 0}},
        {"narrow slab", 2, {0.0625, 0, 0, 0, 1, 0}, {50, 3, 0}},
        {"wire", 1, {1, 0, 0}, {9, 0, 0}},
        {"inclined wire", 1, {0.5, 0.25, 1}, {9, 0, 0}},
    };
    if (is_smallest()) all = {all[0], all[2], all[7], all[11]};
    return all;
}

std::vector<double> points_in(const Box& box, std::size_t n, unsigned seed, int denominator) {
    std::mt19937 random(seed);
    std::vector<double> points;
    for (std::size_t i = 0; i < n; ++i) {
        double x[3] = {}, s[3];
        for (double& c : s) {
            c = std::uniform_real_distribution<double>(-1, 2)(random);
            if (denominator > 0) c = std::floor(c * denominator) / denominator;
        }
        for (unsigned k = 0; k < 3; ++k)
            for (unsigned c = 0; c < 3; ++c)
                x[c] += k < box.dimensions ? s[k] * box.vectors[3 * k + c] : 0;
        // The other coordinates of a slab or a wire.
        for (unsigned k = box.dimensions; k < 3; ++k) x[2 - (k - box.dimensions)] += s[k];
        points.insert(points.end(), x, x + 3);
    }
    return points;
}

// The corners, as images such that the lexicographically least one is in the box.
Corners canonical(Corners corners, const std::array<const double*, 4>& x) {
    unsigned least = 0;
    for (unsigned i = 1; i < 4; ++i)
        if (std::lexicographical_compare(x[i], x[i] + 3, x[least], x[least] + 3)) least = i;
    const Multiples shift = corners[least].of;
    for (Corner& corner : corners) corner.of = corner.of - shift;
    std::sort(corners.begin(), corners.end());
    return corners;
}

struct Wrapped {
    Wrapped(const Box& box, const std::vector<double>& points)
        : given(box.dimensions, box.vectors.data()),
          grid(given, reach(points)),
          lattice(grid.lattice()) {
        for (std::size_t i = 0; i < points.size(); i += 3) {
            double x[3];
            Multiples taken;
            EXPECT_TRUE(grid.wrap(points.data() + i, x, taken));
            coordinates.insert(coordinates.end(), x, x + 3);
        }
    }
    PointReach reach(const std::vector<double>& points) const {
        PointReach reach(given);
        for (std::size_t i = 0; i < points.size(); i += 3)
            EXPECT_TRUE(reach.add(points.data() + i));
        return reach;
    }
    BoxLattice given;
    ImageGrid grid;
    const BoxLattice& lattice;
    std::vector<double> coordinates;
};

// Calls visit(halo) for the finished halo.
template <class Visit>
void with_halo(const Wrapped& wrapped, const Visit& visit) {
    Allocator allocator;
    StopFlag cancelled;
    StageProgress progress(CallSettings(), cancelled);
    Buffer<double> points(allocator);
    for (const double x : wrapped.coordinates) points.push_back(x);
    Halo halo(allocator);
    halo.build(wrapped.grid, std::move(points), Buffer<Image>(allocator), 1, progress);
    visit(halo);
}

// Calls visit(corners, x) for the tetrahedra at points of the box.
template <class Visit>
void each_tetrahedron(const Halo& halo, const Visit& visit) {
    const Mesh& mesh = halo.triangulation().mesh();
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        if (mesh.tetrahedra[t].is_dead() || mesh.tetrahedra[t].is_ghost()) continue;
        Corners corners;
        std::array<const double*, 4> x;
        bool is_own = false;
        for (unsigned i = 0; i < 4; ++i) {
            const std::uint32_t index = mesh.vertices[mesh.tetrahedra[t].v[i]].index;
            is_own = is_own || halo.is_own(index);
            corners[i] = {halo.image(index).point, halo.image(index).multiples()};
            x[i] = halo.point(index);
        }
        if (is_own) visit(corners, x);
    }
}

std::set<Corners> by_halo(const Wrapped& wrapped) {
    std::set<Corners> found;
    with_halo(wrapped, [&](const Halo& halo) {
        each_tetrahedron(halo, [&](const Corners& corners, const auto& x) {
            found.insert(canonical(corners, x));
        });
    });
    return found;
}

std::set<Corners> by_copies(const Wrapped& wrapped, const int (&copies)[3]) {
    const auto n = static_cast<std::uint32_t>(wrapped.coordinates.size() / 3);
    std::vector<double> points = wrapped.coordinates;
    std::vector<Corner> corner_of;
    for (std::uint32_t p = 0; p < n; ++p) corner_of.push_back({p, {}});
    for (int i = -copies[0]; i <= copies[0]; ++i)
        for (int j = -copies[1]; j <= copies[1]; ++j)
            for (int k = -copies[2]; k <= copies[2]; ++k)
                for (std::uint32_t p = 0; p < n && (i != 0 || j != 0 || k != 0); ++p) {
                    double x[3];
                    wrapped.grid.image(wrapped.coordinates.data() + 3 * p, {i, j, k}, x);
                    points.insert(points.end(), x, x + 3);
                    corner_of.push_back({p, {i, j, k}});
                }
    Triangulation triangulation(nullptr, nullptr, nullptr);
    const double* const axis[3] = {points.data(), points.data() + 1, points.data() + 2};
    triangulation.insert(points.size() / 3, axis, 3);
    std::set<Corners> found;
    const Mesh& mesh = triangulation.mesh();
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        if (mesh.tetrahedra[t].is_dead() || mesh.tetrahedra[t].is_ghost()) continue;
        Corners corners;
        std::array<const double*, 4> x;
        bool is_own = false;
        for (unsigned i = 0; i < 4; ++i) {
            const std::uint32_t index = mesh.vertices[mesh.tetrahedra[t].v[i]].index;
            corners[i] = corner_of[index];
            is_own = is_own || corners[i].of == Multiples{};
            x[i] = points.data() + 3 * index;
        }
        if (is_own) found.insert(canonical(corners, x));
    }
    return found;
}

TEST(Halo, GivesTheStarsOfManyCopies) {
    for (const Box& box : boxes())
        for (const int denominator : {0, 2, 8})
            for (const std::size_t n : {1u, 2u, 3u, 5u, 8u, 40u}) {
                SCOPED_TRACE(box.name + ", " + std::to_string(n) + " points of 1/" +
                             std::to_string(denominator));
                const Wrapped wrapped(box, points_in(box, n, unsigned(n), denominator));
                const std::set<Corners> found = by_halo(wrapped),
                                        expected = by_copies(wrapped, box.copies);
                EXPECT_EQ(found.size(), expected.size());
                EXPECT_TRUE(found == expected);
            }
}

// Points of a box that fill it, or a line, a plane or a small part of it.
std::vector<double> shape(const std::string& name, std::size_t n, const Box& box) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<double> points;
    for (std::size_t i = 0; i < n; ++i) {
        double s[3] = {place(random), place(random), place(random)};
        if (name == "diagonal") s[1] = s[2] = s[0];
        if (name == "line") s[1] = s[2] = 0.5;
        if (name == "plane") s[2] = 0.25;
        if (name == "cluster")
            for (double& c : s) c = 0.9 + 0.001 * c;
        for (unsigned c = 0; c < 3; ++c)
            points.push_back(s[0] * box.vectors[c] + s[1] * box.vectors[3 + c] +
                             s[2] * box.vectors[6 + c]);
    }
    return points;
}

// The tetrahedra fill the box once, and numbers of vertices, edges and tetrahedra are those of a
// torus: V - E + F - T = 0, and F = 2 T.
TEST(Halo, FillsTheTorus) {
    std::vector<Box> all = boxes();
    all.push_back({"needle", 3, {100, 0, 0, 0, 1, 0, 0, 0, 1}, {}});
    all.push_back({"thin plate", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1e-6}, {}});
    all.push_back({"flat", 3, {1, 0.25, 0.125, 0.5, 1, 0.25, 0.75, 0.625, 0.1875 + 1e-7}, {}});
    for (const Box& box : all) {
        if (box.dimensions < 3) continue;
        for (const char* const name : {"filled", "diagonal", "line", "plane", "cluster"})
            for (const std::size_t n : {1u, 7u, is_smallest() ? 40u : 300u}) {
                SCOPED_TRACE(box.name + ", " + name + ", " + std::to_string(n));
                const Wrapped wrapped(box, shape(name, n, box));
                std::set<Corners> tetrahedra;
                std::set<std::array<Corner, 2>> edges;
                std::set<std::uint32_t> vertices;
                double volume = 0;
                with_halo(wrapped, [&](const Halo& halo) {
                    each_tetrahedron(halo, [&](const Corners& corners, const auto& x) {
                        for (const Corner& a : corners) {
                            vertices.insert(a.point);
                            for (const Corner& b : corners) {
                                Corner from = a, to = b;
                                if (to < from) std::swap(from, to);
                                to.of = to.of - from.of;
                                // From one point to an image of it, there are two names.
                                if (from.point == to.point && to.of < Multiples{}) to.of = -to.of;
                                from.of = {};
                                if (&a != &b) edges.insert({from, to});
                            }
                        }
                        if (!tetrahedra.insert(canonical(corners, x)).second) return;
                        double v[3][3];
                        for (unsigned k = 0; k < 3; ++k)
                            for (unsigned c = 0; c < 3; ++c) v[k][c] = x[k + 1][c] - x[0][c];
                        volume += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                                  v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                                  v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
                    });
                });
                EXPECT_EQ(vertices.size(), n);
                EXPECT_EQ(vertices.size() + tetrahedra.size(), edges.size());
                const double *const a = wrapped.lattice.vector(0),
                                    *const b = wrapped.lattice.vector(1),
                                    *const c = wrapped.lattice.vector(2);
                const double expected = std::fabs(a[0] * (b[1] * c[2] - b[2] * c[1]) -
                                                  a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                                  a[2] * (b[0] * c[1] - b[1] * c[0]));
                EXPECT_NEAR(volume / 6, expected, 1e-9 * expected);
            }
    }
}

// Checks the representatives of all classes, their order, orientation and neighbours.
void expect_listed(const Halo& halo, const Wrapped& wrapped) {
    Allocator allocator;
    const PeriodicTetrahedra all(allocator, halo);
    std::set<Corners> expected, found;
    each_tetrahedron(halo, [&](const Corners& corners, const auto& x) {
        expected.insert(canonical(corners, x));
    });
    const auto moved = [](const Image& image, const std::int8_t* of) {
        return Corner{image.point, image.multiples() + Multiples{of[0], of[1], of[2]}};
    };
    std::vector<Corner> before;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Corners corners;
        std::array<std::array<double, 3>, 4> x;
        std::array<const double*, 4> places;
        std::vector<Corner> order;
        for (unsigned k = 0; k < 4; ++k) {
            const Image image = all[i].corners[k];
            corners[k] = {image.point, image.multiples()};
            order.push_back(corners[k]);
            wrapped.grid.image(halo.point(image.point), image.multiples(), x[k].data());
            places[k] = x[k].data();
        }
        EXPECT_EQ(corners[0].of, Multiples{});
        EXPECT_TRUE(corners[1] < corners[2] && corners[1] < corners[3]);
        EXPECT_TRUE(i == 0 || before < order);
        before = order;
        EXPECT_EQ(orientation(places[0], places[1], places[2], places[3]), 1);
        const Corners as_given = canonical(corners, places);
        std::sort(corners.begin(), corners.end());
        EXPECT_TRUE(corners == as_given);  // the least corner is in the box already
        EXPECT_TRUE(found.insert(corners).second);
        for (unsigned k = 0; k < 4; ++k) {
            const PeriodicTetrahedra::Neighbor n = all.records()[i].neighbors[k];
            if (n.number == no_index) {
                EXPECT_LT(wrapped.lattice.dimensions(), 3u);
                continue;
            }
            // The neighbour has the three other corners, and lists this tetrahedron at its fourth.
            unsigned shared = 0, apex = 4;
            for (unsigned l = 0; l < 4; ++l) {
                const Corner corner = moved(all[n.number].corners[l], n.of);
                bool is_shared = false;
                for (unsigned m = 0; m < 4; ++m)
                    is_shared = is_shared || (m != k && corner == order[m]);
                if (is_shared)
                    ++shared;
                else
                    apex = l;
            }
            EXPECT_EQ(shared, 3u);
            const PeriodicTetrahedra::Neighbor back = all.records()[n.number].neighbors[apex];
            EXPECT_EQ(back.number, i);
            for (unsigned c = 0; c < 3; ++c) EXPECT_EQ(back.of[c], -n.of[c]);
        }
    }
    EXPECT_TRUE(found == expected);
}

TEST(PeriodicTetrahedra, AreListedOnce) {
    for (const Box& box : boxes())
        for (const int denominator : {0, 2})
            for (const std::size_t n : {1u, 2u, 5u, 60u}) {
                SCOPED_TRACE(box.name + ", " + std::to_string(n) + " points of 1/" +
                             std::to_string(denominator));
                const Wrapped wrapped(box, points_in(box, n, unsigned(n), denominator));
                with_halo(wrapped, [&](const Halo& halo) { expect_listed(halo, wrapped); });
            }
}

// Exact decisions need exact images, also of points far away and at the faces of the box.
TEST(ImageGrid, WrapsEveryImageToOnePoint) {
    std::mt19937 random(3);
    for (const Box& box : boxes()) {
        SCOPED_TRACE(box.name);
        const std::vector<double> points = points_in(box, 50, 1, 4);
        const Wrapped wrapped(box, points);
        for (std::size_t i = 0; i < points.size(); i += 3) {
            const double* const home = wrapped.coordinates.data() + i;
            double s[3];
            wrapped.lattice.coordinates(home, s);
            for (unsigned k = 0; k < box.dimensions; ++k)
                EXPECT_TRUE(s[k] > -1e-9 && s[k] < 1 + 1e-9);
            for (int j = 0; j < 20; ++j) {
                Multiples k = {}, taken;
                const std::int32_t most = j % 2 == 0 ? 3 : 20;
                for (unsigned d = 0; d < box.dimensions; ++d)
                    k[d] =
                        static_cast<std::int32_t>(random() % static_cast<unsigned>(2 * most + 1)) -
                        most;
                double image[3], x[3];
                wrapped.grid.image(home, k, image);
                for (double& c : image) c = wrapped.lattice.to_callers(c);
                EXPECT_TRUE(wrapped.grid.wrap(image, x, taken));
                EXPECT_TRUE(std::equal(x, x + 3, home));
                EXPECT_EQ(taken, k);
            }
        }
        const double far[3] = {1e15 * box.vectors[0], 1e15 * box.vectors[1], 1e15 * box.vectors[2]};
        double x[3];
        Multiples taken;
        EXPECT_FALSE(wrapped.grid.wrap(far, x, taken));
        const double near[3] = {1e6 * box.vectors[0], 1e6 * box.vectors[1], 1e6 * box.vectors[2]};
        EXPECT_TRUE(wrapped.grid.wrap(near, x, taken));
        const std::array<std::int64_t, 3> of_callers = wrapped.lattice.multiples_of_callers(taken);
        if (x[0] == 0 && x[1] == 0 && x[2] == 0) {
            EXPECT_TRUE(of_callers[0] == 1000000 && of_callers[1] == 0 && of_callers[2] == 0);
        }
    }
}

TEST(BoxLattice, RefusesWhatDoesNotSpan) {
    const auto status_of = [](unsigned dimensions, std::vector<double> vectors) -> std::int32_t {
        try {
            const BoxLattice lattice(dimensions, vectors.data());
            const ImageGrid grid(lattice, PointReach(lattice));
        } catch (const Error& e) {
            return e.status;
        }
        return MGDT_OK;
    };
    EXPECT_EQ(status_of(3, {1, 0, 0, 0, 1, 0, 0, 0, 1}), MGDT_OK);
    EXPECT_EQ(status_of(3, {1e-200, 0, 0, 0, 1e-200, 0, 0, 0, 1e-200}), MGDT_OK);
    EXPECT_EQ(status_of(3, {1e200, 0, 0, 0, 1e200, 0, 0, 0, 1e200}), MGDT_OK);
    EXPECT_EQ(status_of(3, {1, 0, 0, 0, 1, 0, 0, 0, 1e-300}), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of(1, {0, 0, 0}), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of(2, {1, 2, 3, -2, -4, -6}), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of(2, {1, 2, 3, 0, 0, 0}), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of(3, {1, 2, 3, 4, 5, 6, 7, 8, 9}), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of(3, {1, 0, 0, 0, 1, 0, 1, 1, 1e-11}), MGDT_OK);
    EXPECT_EQ(status_of(3, {1, 0, 0, 0, 1, 0, 1, 1, 1e-12}), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of(3, {1, 0.5, 0.25, 0.5, 1, 0.25, 1e-16, 1e-16, -2e-16}),
              MGDT_ERR_INVALID_ARGUMENT);
}

// Each two vectors of the basis, and of these and minus their sum, make no acute angle: exactly,
// also of boxes that are thin.
TEST(BoxLattice, HasAnObtuseBasis) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-1, 1);
    int accepted = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<double> vectors(9);
        for (double& x : vectors) x = place(random);
        if (i % 4 == 1)
            for (unsigned k = 0; k < 3; ++k) vectors[k] = 1000 * vectors[3 + k] + 1e-3 * vectors[k];
        if (i % 4 == 2)
            for (double& x : vectors) x = std::floor(2 * x);
        if (i % 4 == 3)  // the last vector nearly in the plane of the others
            for (unsigned k = 0; k < 3; ++k)
                vectors[6 + k] = 0.3 * vectors[k] + 0.6 * vectors[3 + k] +
                                 std::pow(0.1, i % 40 / 4) * place(random);
        try {
            for (unsigned d = 1; d <= 3; ++d) {
                const BoxLattice given(d, vectors.data());
                const BoxLattice lattice = ImageGrid(given, PointReach(given)).lattice();
                ++accepted;
                double v[4][3] = {};
                for (unsigned k = 0; k < d; ++k)
                    for (unsigned c = 0; c < 3; ++c) {
                        v[k][c] = lattice.vector(k)[c];
                        v[d][c] -= v[k][c];
                    }
                for (unsigned k = 0; k <= d && d > 1; ++k)
                    for (unsigned l = 0; l < k; ++l) {
                        const double opposite[3] = {-v[l][0], -v[l][1], -v[l][2]};
                        EXPECT_LE(compare_lengths(v[k], opposite, v[k], v[l]), 0);
                    }
                for (unsigned k = 0; k < d; ++k) {
                    double s[3];
                    lattice.coordinates(lattice.vector(k), s);
                    for (unsigned l = 0; l < d; ++l)
                        EXPECT_NEAR(s[l], k == l,
                                    lattice.error_of(l, 2 * lattice.covering_radius()));
                }
            }
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_INVALID_ARGUMENT);
        }
    }
    EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace mgdt
