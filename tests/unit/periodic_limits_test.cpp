// SPDX-License-Identifier: MIT
// Periodic boxes near the limits of doubles, few points in uncommon places, and builds that are
// interrupted.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "../support/limited_blocks.hpp"
#include "../support/small.h"
#include "periodic/image_prediction.hpp"
#include "periodic/periodic_cells.hpp"
#include "periodic/periodic_check.hpp"
#include "periodic/periodic_diagram.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

using mgdt_tests::LimitedBlocks;
using Vectors = std::vector<double>;
using Listing = std::vector<std::array<std::int64_t, 16>>;

// A turn about an axis that is no coordinate axis.
void turn(double* x) {
    const double a = 0.6, b = 0.3, c[2] = {std::cos(a), std::cos(b)},
                 s[2] = {std::sin(a), std::sin(b)};
    const double y[3] = {c[0] * x[0] - s[0] * x[1], s[0] * x[0] + c[0] * x[1], x[2]};
    x[0] = y[0];
    x[1] = c[1] * y[1] - s[1] * y[2];
    x[2] = s[1] * y[1] + c[1] * y[2];
}

// Points with random coordinates along the vectors, and along the axes that a slab or a wire lacks.
std::vector<double> points_in(const Vectors& vectors, std::size_t n, unsigned seed,
                              double height = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<double> points;
    for (std::size_t i = 0; i < n; ++i) {
        double x[3] = {};
        for (std::size_t k = 0; k < 3; ++k) {
            const double s = place(random);
            for (unsigned c = 0; c < 3; ++c)
                x[c] += k < vectors.size() / 3 ? s * vectors[3 * k + c] : c == k ? height * s : 0;
        }
        points.insert(points.end(), x, x + 3);
    }
    return points;
}

struct Built : Periodic {
    explicit Built(const Vectors& vectors) : Periodic(nullptr, nullptr, nullptr) {
        set_vectors(static_cast<unsigned>(vectors.size() / 3), vectors.data());
    }
    Built(const Vectors& vectors, const std::vector<double>& points) : Built(vectors) {
        insert(points.size() / 3, points.data());
        build();
        check_periodic(*this, Unwatched());
    }
};

// The listed corners of all tetrahedra, by points and multiples.
Listing listing(const Periodic& built) {
    Listing all;
    for (std::size_t i = 0; i < built.tetrahedra().size(); ++i) {
        std::array<std::int64_t, 16> t;
        for (unsigned k = 0; k < 4; ++k) {
            const Image image = built.tetrahedra()[i].corners[k];
            t[4 * k] = image.point;
            for (unsigned c = 0; c < 3; ++c) t[4 * k + 1 + c] = image.multiples()[c];
        }
        all.push_back(t);
    }
    return all;
}

// Whether the tetrahedra of three periods have the numbers and the volume of a torus, and all their
// neighbours. The volume is relative to the box of the rounded vectors.
void expect_torus(const Built& built) {
    const std::size_t count = built.tetrahedra().size();
    using Edge = std::array<int, 5>;
    std::set<Edge> edges;
    std::set<std::uint32_t> vertices;
    double volume = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double x[4][3];
        for (unsigned k = 0; k < 4; ++k) {
            EXPECT_NE(built.tetrahedra().records()[i].neighbors[k].number, no_index);
            const Image a = built.tetrahedra()[i].corners[k];
            vertices.insert(a.point);
            built.grid().image(built.halo().point(a.point), a.multiples(), x[k]);
            for (unsigned l = 0; l < 4; ++l) {
                const Image b = built.tetrahedra()[i].corners[l];
                const Multiples of = b.multiples() - a.multiples();
                if (a.point < b.point || (a.point == b.point && Multiples{} < of))
                    edges.insert({static_cast<int>(a.point), static_cast<int>(b.point), of[0],
                                  of[1], of[2]});
            }
        }
        double v[3][3];
        for (unsigned k = 0; k < 3; ++k)
            for (unsigned c = 0; c < 3; ++c) v[k][c] = x[k + 1][c] - x[0][c];
        volume += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                  v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                  v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    }
    EXPECT_EQ(vertices.size() + count, edges.size());
    // The dual's slopes are the reciprocals of the heights of the box, of which one is its volume
    // by the area of a face; doubles lose what the thickness leaves.
    const BoxLattice& lattice = built.grid().lattice();
    const double *const a = lattice.vector(0), *const b = lattice.vector(1);
    const double normal[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                              a[0] * b[1] - a[1] * b[0]};
    const double area =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const double expected = area / lattice.slope(2), size = 2 * lattice.covering_radius();
    EXPECT_NEAR(volume / 6, expected,
                1e-9 * expected + static_cast<double>(count) * 1e-16 * size * size * size);
}

TEST(Periodic, ThinBoxesTurned) {
    for (const double thickness : {1e-2, 1e-4, 1e-6, 1e-8, 1e-9})
        for (const bool is_needle : {false, true}) {
            const double other = is_needle ? thickness : 1;
            // The last vector of a plate is across it.
            Vectors box = {1,        0, 0, 0.2 * other, other, 0, 0.3 * thickness, 0.1 * thickness,
                           thickness};
            for (unsigned k = 0; k < 3; ++k) turn(&box[3 * k]);
            for (const std::size_t n : {1u, 2u, 5u, 40u}) {
                SCOPED_TRACE(std::to_string(thickness) + (is_needle ? " needle " : " plate ") +
                             std::to_string(n));
                const Built built(box, points_in(box, n, unsigned(n)));
                expect_torus(built);
            }
        }
    const Vectors flat = {1, 0, 0, 0.25, 1, 0, 0, 0, 1e-12};
    try {
        const Built built(flat, {0, 0, 0});
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.status, MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(std::string(e.message).find("the box is flat, or nearly"), 0u);
    }
}

// A power of two changes nothing but the unit, up to the ends of the range of doubles.
TEST(Periodic, TinyAndHugeBoxes) {
    const Vectors box = {4, 0, 0, 1.5, 3, 0, -0.75, 0.5, 2.5}, slab(box.begin(), box.begin() + 6);
    for (const Vectors& vectors : {box, slab}) {
        const std::vector<double> points = points_in(vectors, 60, 4);
        const Built built(vectors, points);
        const auto expected = listing(built);
        std::vector<double> centroids(180);
        if (vectors.size() == 9)
            export_periodic_measures(built, Measure::centroid, Unwatched(), centroids.data());
        for (const int exponent : {-990, -900, -521, -200, 200, 341, 520, 900, 990}) {
            SCOPED_TRACE(exponent);
            Vectors scaled_vectors = vectors;
            std::vector<double> scaled_points = points;
            for (double& x : scaled_vectors) x = std::scalbn(x, exponent);
            for (double& x : scaled_points) x = std::scalbn(x, exponent);
            const Built scaled(scaled_vectors, scaled_points);
            EXPECT_TRUE(listing(scaled) == expected);
            double x[3], y[3];
            built.rounded(17, x);
            scaled.rounded(17, y);
            for (unsigned c = 0; c < 3; ++c) EXPECT_EQ(y[c], std::scalbn(x[c], exponent));
            if (vectors.size() != 9) continue;
            std::vector<double> other(180);
            export_periodic_measures(scaled, Measure::centroid, Unwatched(), other.data());
            for (std::size_t i = 0; i < 180; ++i)
                EXPECT_EQ(other[i], std::scalbn(centroids[i], exponent));
        }
    }
    const double tiny = 0x1p-1040;
    EXPECT_THROW(Built({tiny, 0, 0, 0, tiny, 0, 0, 0, tiny}, {0, 0, 0}), Error);
}

// A point and its image by a vector of an inclined slab are one vertex, however high they are.
TEST(Periodic, HighPointsOfInclinedSlabs) {
    const Vectors slab = {1, 0, 0.5, 0.25, 1, -0.25}, wire = {0.5, 0.25, 1};
    for (const Vectors& vectors : {slab, wire})
        for (const double height : {1e3, 1e5, 1e7, 1e8}) {
            SCOPED_TRACE(height);
            std::vector<double> points = points_in(vectors, 30, 3, height), twice = points;
            // Coordinates of few bits, so that adding vectors is exact.
            const double unit = height / 0x1p20;
            for (double& x : points) x = std::floor(x / unit) * unit;
            twice = points;
            for (std::size_t i = 0; i < points.size(); i += 3)
                for (unsigned c = 0; c < 3; ++c)
                    twice.push_back(points[i + c] + vectors[c] * static_cast<double>(i % 7));
            const Built once(vectors, points), built(vectors, twice);
            EXPECT_TRUE(listing(built) == listing(once));
            for (std::uint32_t i = 0; i < 30; ++i) EXPECT_EQ(built.vertex_of(30 + i), i);
        }
    try {
        const Built built(slab, {0, 0, 1e13});
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(std::string(e.message).find("point 0 is too far from the box"), 0u);
    }
    EXPECT_THROW(Built({1e-300, 0, 0}, {0, 0, 1e300}), Error);
}

// Rows of points in uncommon places, for which rounds add images of few points only.
TEST(Periodic, FewPointsApart) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1}, slab(cube.begin(), cube.begin() + 6);
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(0, 1);
        std::vector<double> line, clusters, flat, circle;
        for (int i = 0; i < 40; ++i) {
            const double t = place(random);
            line.insert(line.end(), {t, t + 1e-9 * place(random), t});
            for (int k = 0; k < 3; ++k) clusters.push_back((i % 3) * 0.3 + 1e-6 * place(random));
            flat.insert(flat.end(), {t, place(random), 1e-9 * place(random)});
            circle.insert(circle.end(), {0.3 * std::cos(6 * t), 0.3 * std::sin(6 * t), 0.5});
        }
        for (const auto& points : {line, clusters, flat, circle}) expect_torus(Built(cube, points));
        // A slab with one point far above it has the points of the slab as vertices.
        flat[2] = 1e3;
        const Built built(slab, flat);
        std::set<std::uint32_t> vertices;
        for (std::size_t i = 0; i < built.tetrahedra().size(); ++i)
            for (const Image& image : built.tetrahedra()[i].corners) vertices.insert(image.point);
        EXPECT_EQ(vertices.size(), 40u);
    }
}

TEST(Periodic, ThreadsGiveTheSame) {
    const Vectors box = {4, 0, 0, 1.5, 3, 0, -0.75, 0.5, 2.5};
    const std::vector<double> points = points_in(box,
                                                 is_smallest() ? 2000
                                                 : is_small()  ? 5000
                                                               : 30000,
                                                 6);
    const Built one(box, points);
    Built four(box);
    four.settings().threads = 4;
    four.insert(points.size() / 3, points.data());
    four.build();
    EXPECT_TRUE(listing(four) == listing(one));
}

// The limit holds for the triangulation inside too.
TEST(Periodic, MemoryIsLimited) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    Built built(cube);
    const std::vector<double> points = points_in(cube, 2000, 8);
    built.insert(points.size() / 3, points.data());
    const std::size_t before = built.allocator().bytes();
    built.allocator().set_limit(before + 300000);
    EXPECT_THROW(built.build(), std::bad_alloc);
    EXPECT_FALSE(built.has_triangulation());
    EXPECT_EQ(built.allocator().bytes(), before);
    built.allocator().set_limit(before + 20000000);
    built.build();
    EXPECT_GT(built.allocator().peak(), before + 300000);
    built.allocator().set_limit(0);
    built.build();
    expect_torus(built);
}

TEST(Periodic, RefusedAllocationsLeaveThePoints) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<double> points = points_in(cube, 60, 8);
    const auto expected = listing(Built(cube, points));
    int refused = 0;
    for (std::size_t i = 0;; i += is_smallest() ? 5 : 1) {
        LimitedBlocks blocks{1000000, true};
        Periodic built(LimitedBlocks::take, LimitedBlocks::give_back, &blocks);
        built.set_vectors(3, cube.data());
        built.insert(points.size() / 3, points.data());
        blocks.refuse_after(i);
        try {
            built.build();
            EXPECT_EQ(built.tetrahedra().size(), expected.size());
            VoronoiDiagram diagram(built.allocator());
            build_periodic_diagram(built, Unwatched(), diagram);
            if (blocks.refused == 0) break;
            continue;  // what was refused was not necessary
        } catch (const std::bad_alloc&) {
            ++refused;
        }
        blocks.refuse_after(1000000);
        built.build();
        EXPECT_EQ(built.tetrahedra().size(), expected.size());
    }
    EXPECT_GT(refused, is_smallest() ? 6 : 30);
}

// 4,200 points on a line, a plane or a sphere, whose images are predicted from samples.
std::vector<std::vector<double>> thin_sets() {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> place(0, 1);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> line, plane, sphere;
    for (int i = 0; i < 4200; ++i) {
        const double t = place(random);
        line.insert(line.end(), {t, 0.5, 0.5});
        plane.insert(plane.end(), {t, place(random), 0.25});
        double x[3], square = 0;
        for (double& c : x) {
            c = normal(random);
            square += c * c;
        }
        for (const double c : x) sphere.push_back(0.5 + 0.4 * c / std::sqrt(square));
    }
    return {line, plane, sphere};
}

// The halo that no images were predicted for gives the same tetrahedra.
TEST(Periodic, PredictedImagesChangeNothing) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1}, slab = {1, 0, 0, 0, 1, 0};
    int predictions = 0;
    std::vector<std::vector<double>> sets = thin_sets();
    if (is_small()) sets = {sets[1]};
    for (const std::vector<double>& points : sets)
        for (const Vectors& box : {cube, slab}) {
            const Built built(box, points);
            Allocator allocator;
            Buffer<double> wrapped(allocator);
            for (std::uint32_t i = 0; i < points.size() / 3; ++i)
                for (unsigned c = 0; c < 3; ++c) wrapped.push_back(built.halo().point(i)[c]);
            StopFlag cancelled;
            StageProgress progress(CallSettings(), cancelled);
            Buffer<Image> predicted(allocator);
            predict_images(built.grid(), wrapped, 1, progress, predicted);
            Halo halo(allocator);
            halo.build(built.grid(), std::move(wrapped), Buffer<Image>(allocator), 1, progress);
            if (!predicted.empty()) {
                EXPECT_GT(halo.rounds(), built.halo().rounds());
                ++predictions;
            }
            const PeriodicTetrahedra expected(allocator, halo);
            ASSERT_EQ(expected.size(), built.tetrahedra().size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                for (unsigned k = 0; k < 4; ++k) {
                    const Image a = expected[i].corners[k], b = built.tetrahedra()[i].corners[k];
                    ASSERT_TRUE(a.point == b.point && a.multiples() == b.multiples());
                }
        }
    EXPECT_GE(predictions, is_small() ? 1 : 2);
}

// A lattice, a little out of order, with a void at one face: few balls leave the shell, and in one
// place.
TEST(Periodic, VoidsAtAFace) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1}, slab = {1, 0, 0, 0, 1, 0}, wire = {1, 0, 0};
    std::mt19937 random(22);
    std::uniform_real_distribution<double> place(0, 0.2);
    std::vector<double> all;
    constexpr int side = 14;
    for (int i = 0; i < side * side * side; ++i)
        for (const int k : {i % side, i / side % side, i / (side * side)})
            all.push_back((k + place(random)) / side);
    const std::vector<std::array<double, 2>> voids = {{0.097830706010922891, 0.02286881832767259},
                                                      {0.12112120140999749, 0.035814444483591168},
                                                      {0.12858778462906448, 0.043227967803212933},
                                                      {0.0, 0.06},
                                                      {0.94, 0.06}};
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const auto& [center, square_radius] : voids) {
            std::vector<double> points;
            for (std::size_t i = 0; i < all.size(); i += 3) {
                double x[3], square = 0;
                for (unsigned c = 0; c < 3; ++c) {
                    x[c] = all[i + c];
                    const double d = std::fabs(x[c] - (c == axis ? center : 0.5));
                    square += std::min(d, 1 - d) * std::min(d, 1 - d);
                }
                if (square > square_radius) points.insert(points.end(), x, x + 3);
            }
            expect_torus(Built(cube, points));
            if (is_smallest()) break;
            if (is_small()) continue;
            for (const Vectors& box : {slab, wire})
                EXPECT_TRUE(Built(box, points).has_triangulation());
        }
}

TEST(Periodic, RefusedAllocationsInAPrediction) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<double> points = thin_sets()[1];
    LimitedBlocks blocks{1000000, true};
    Periodic built(LimitedBlocks::take, LimitedBlocks::give_back, &blocks);
    built.set_vectors(3, cube.data());
    built.insert(points.size() / 3, points.data());
    int refused = 0;
    for (std::size_t i = 0;; i += 1 + (is_small() ? i : i / 6)) {
        blocks.refuse_after(i);
        try {
            built.build();
            if (blocks.refused == 0) break;
        } catch (const std::bad_alloc&) {
            ++refused;
            EXPECT_FALSE(built.has_triangulation());
        }
    }
    EXPECT_GT(refused, is_small() ? 4 : 12);
    blocks.refuse_after(1000000);
    EXPECT_TRUE(listing(built) == listing(Built(cube, points)));
}

TEST(Periodic, CancelWithin) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<double> points = points_in(cube, 5000, 8);
    Built built(cube);
    built.insert(points.size() / 3, points.data());
    struct Watch {
        Built* built;
        double last = 0;
        int calls = 0, cancel_at = 0;
    } watch{&built};
    built.settings().progress = [](double done, void* user) {
        Watch& w = *static_cast<Watch*>(user);
        EXPECT_GE(done, w.last);
        w.last = done;
        if (++w.calls == w.cancel_at) w.built->stop().set();
        return 0;
    };
    built.settings().progress_user = &watch;
    built.build();
    EXPECT_EQ(watch.last, 1);
    const int calls = watch.calls;
    EXPECT_GE(calls, 4);
    for (int i = 1; i < calls; i += 1 + calls / 10) {
        watch = {&built, 0, 0, i};
        try {
            built.build();
            ADD_FAILURE();
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_CANCELLED);
        }
        EXPECT_FALSE(built.has_triangulation());
    }
}

TEST(PeriodicDiagram, IsSetAnewByEachBuild) {
    const Vectors cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const Built many(cube, points_in(cube, 50, 3)), few(cube, points_in(cube, 3, 3));
    VoronoiDiagram diagram(many.allocator());
    build_periodic_diagram(many, Unwatched(), diagram);
    const std::size_t faces = diagram.face_count();
    build_periodic_diagram(few, Unwatched(), diagram);
    EXPECT_EQ(diagram.cell_count(), 3u);
    build_periodic_diagram(many, Unwatched(), diagram);
    EXPECT_EQ(diagram.face_count(), faces);
    EXPECT_EQ(diagram.face_shifts.size(), 3 * faces);
}

// The cells of a slab's outermost points are unbounded.
TEST(PeriodicDiagram, SlabsHaveRays) {
    const Vectors slab = {1, 0, 0, 0, 1, 0};
    std::vector<double> points = points_in(slab, 200, 9);
    const Built built(slab, points);
    VoronoiDiagram diagram(built.allocator());
    build_periodic_diagram(built, Unwatched(), diagram);
    std::vector<double> volumes(200);
    export_periodic_measures(built, Measure::volume, Unwatched(), volumes.data());
    std::size_t unbounded = 0;
    for (std::uint32_t p = 0; p < 200; ++p) {
        EXPECT_EQ(diagram.is_bounded[p] != 0, std::isfinite(volumes[p]));
        unbounded += std::isfinite(volumes[p]) ? 0 : 1;
    }
    // The hull touches the images of the highest and of the lowest point.
    EXPECT_EQ(unbounded, 2u);
    EXPECT_GT(diagram.ray_directions.size(), 0u);
    // Rays go up or down: the slab has no other direction to infinity.
    for (std::size_t i = 0; i < diagram.ray_directions.size(); i += 3)
        EXPECT_GT(std::fabs(diagram.ray_directions[i + 2]), 0.1);
}

}  // namespace
}  // namespace mgdt
