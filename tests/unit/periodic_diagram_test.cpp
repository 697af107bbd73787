// SPDX-License-Identifier: MIT
// Voronoi diagrams of points in periodic boxes, with points in the box and far outside of it.
#include "periodic/periodic_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "periodic_built.hpp"
#include "predicates/circumcenter.hpp"
#include "predicates/predicates.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

using Place = std::array<double, 3>;

struct Diagram : VoronoiDiagram {
    explicit Diagram(const Built& built) : VoronoiDiagram(built.allocator()) {
        build_periodic_diagram(built, Unwatched(), *this);
    }
};

// The faces of a cell close it; what one side says of a face, the other says too.
TEST(PeriodicDiagram, CellsAreClosedAndAgree) {
    for (const std::vector<double>& box : {cube, oblique})
        for (const std::size_t n : {1u, 2u, 300u}) {
            SCOPED_TRACE(n);
            const Built built(box, random_points(n, box, 11));
            const Diagram diagram(built);
            const VoronoiDiagram& d = diagram;
            const std::vector<double> volumes = built.measures(Measure::volume),
                                      faces = built.measures(Measure::faces),
                                      centroids = built.measures(Measure::centroid);
            using Pair = std::tuple<std::uint32_t, std::uint32_t, std::array<std::int64_t, 3>>;
            std::map<Pair, double> areas;
            ASSERT_EQ(d.cell_count(), n);
            for (std::uint32_t p = 0; p < n; ++p) {
                const std::uint64_t begin = d.cell_begin[p], end = d.cell_begin[p + 1];
                EXPECT_EQ(static_cast<double>(end - begin), faces[p]);
                EXPECT_NEAR(d.volumes[p], volumes[p], 1e-12 * volumes[p]);
                double x[3];
                built.rounded(p, x);
                std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
                double volume = 0;
                for (std::uint64_t i = begin; i < end; ++i) {
                    const std::size_t f = d.cell_faces[i];
                    const bool is_first = d.face_sides[2 * f] == p;
                    const std::uint64_t from = d.face_begin[f], to = d.face_begin[f + 1];
                    double normal[3] = {}, height = 0;
                    for (std::uint64_t c = from; c < to; ++c) {
                        const std::uint32_t a = d.face_corners[c],
                                            b = d.face_corners[c + 1 < to ? c + 1 : from];
                        ++edges[std::minmax(a, b)];
                        const double *const u = d.vertices.begin() + 3 * std::size_t{a},
                                            *const v = d.vertices.begin() + 3 * std::size_t{b};
                        for (unsigned k = 0; k < 3; ++k) {
                            const unsigned l = (k + 1) % 3, m = (k + 2) % 3;
                            normal[k] +=
                                ((u[l] - x[l]) * (v[m] - x[m]) - (u[m] - x[m]) * (v[l] - x[l])) / 2;
                        }
                    }
                    const double* const u =
                        d.vertices.begin() + 3 * std::size_t{d.face_corners[from]};
                    for (unsigned k = 0; k < 3; ++k) height += normal[k] * (u[k] - x[k]);
                    volume += (is_first ? height : -height) / 3;
                    EXPECT_GE(is_first ? height : -height, 0);
                    std::array<std::int64_t, 3> of = {};
                    for (unsigned k = 0; k < 3; ++k)
                        of[k] = is_first ? diagram.face_shifts[3 * f + k]
                                         : -diagram.face_shifts[3 * f + k];
                    const std::uint32_t other = d.face_sides[2 * f + (is_first ? 1 : 0)];
                    EXPECT_TRUE(areas.insert({{p, other, of}, d.areas[f]}).second);
                }
                EXPECT_NEAR(volume, volumes[p], 1e-9 * volumes[p]);
                for (const auto& edge : edges) EXPECT_EQ(edge.second, 2);
                for (unsigned c = 0; c < 3; ++c)
                    EXPECT_NEAR(d.cell_centroids[3 * p + c] - x[c], centroids[3 * p + c], 1e-9);
            }
            for (const auto& [pair, area] : areas) {
                const auto& [p, q, of] = pair;
                const auto back = areas.find({q, p, {-of[0], -of[1], -of[2]}});
                ASSERT_TRUE(back != areas.end());
                EXPECT_NEAR(back->second, area, 1e-12);
            }
        }
}

// Points on a grid on which all their images are exact, moved by up to `most` of each vector.
std::vector<double> scattered(const std::vector<double>& box, std::size_t n, double grid, int most,
                              unsigned seed) {
    std::vector<double> points = random_points(n, box, seed);
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            points[3 * i + c] = std::floor(points[3 * i + c] * grid) / grid;
        for (std::size_t k = 0; k < box.size() / 3; ++k) {
            const double times =
                static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
            for (std::size_t c = 0; c < 3; ++c) points[3 * i + c] += times * box[3 * k + c];
        }
    }
    return points;
}

const std::vector<double> slab = {1, 0, 0, 0.25, 1, 0.5}, wire = {0.5, 0, 1};

// Faces, vertices and rays that cells share are listed once, also where the points were moved into
// the box by different multiples.
TEST(PeriodicDiagram, ListsWhatIsSharedOnce) {
    std::size_t shared = 0, rays = 0;
    for (const std::vector<double>& box : {cube, oblique, slab, wire})
        for (const double grid : {1048576.0, 4.0})
            for (const int most : {0, 1, 2, 1000}) {
                SCOPED_TRACE(testing::Message() << grid << " " << most);
                const Built built(box, scattered(box, 120, grid, most, 3));
                const Diagram d(built);
                std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
                for (std::size_t f = 0; f < d.face_count(); ++f) {
                    const auto image = d.face_shifts.begin() + 3 * f;
                    if (image[0] != 0 || image[1] != 0 || image[2] != 0) continue;
                    const std::uint32_t p = d.face_sides[2 * f], q = d.face_sides[2 * f + 1];
                    EXPECT_LT(p, q);
                    EXPECT_TRUE(pairs.insert({p, q}).second);
                    ++shared;
                    for (const std::uint32_t cell : {p, q})
                        EXPECT_EQ(std::count(d.cell_faces.begin() + d.cell_begin[cell],
                                             d.cell_faces.begin() + d.cell_begin[cell + 1], f),
                                  1);
                }
                // Different vertices are so near to each other only by chance.
                std::set<Place> places;
                for (std::size_t v = 0; v < d.vertices.size(); v += 3)
                    EXPECT_TRUE(places.insert({d.vertices[v], d.vertices[v + 1], d.vertices[v + 2]})
                                    .second);
                std::set<std::tuple<std::uint32_t, long, long, long>> directions;
                for (std::size_t r = 0; r < d.ray_vertices.size(); ++r, ++rays) {
                    const double* const way = d.ray_directions.begin() + 3 * r;
                    EXPECT_TRUE(directions
                                    .insert({d.ray_vertices[r], std::lround(way[0] * 1e9),
                                             std::lround(way[1] * 1e9), std::lround(way[2] * 1e9)})
                                    .second);
                }
            }
    EXPECT_GT(shared, 1500u);
    EXPECT_GT(rays, 500u);
}

// Each vertex is the circumcentre of the points whose faces have it, rounded once.
TEST(PeriodicDiagram, VerticesAreTheNearestDoubles) {
    std::size_t compared = 0;
    for (const std::vector<double>& box : {cube, oblique, slab, wire})
        for (const double grid : {1048576.0, 4.0})
            for (const int most : {0, 1, 1000}) {
                SCOPED_TRACE(testing::Message() << grid << " " << most);
                const Built built(box, scattered(box, 100, grid, most, 8));
                const Diagram d(built);
                std::map<std::uint32_t, std::set<Place>> around;
                for (std::size_t f = 0; f < d.face_count(); ++f)
                    for (std::uint64_t c = d.face_begin[f]; c < d.face_begin[f + 1]; ++c) {
                        if ((d.face_corners[c] & VoronoiDiagram::ray) != 0) continue;
                        const std::int64_t* const of = d.face_shifts.begin() + 3 * f;
                        std::set<Place>& points = around[d.face_corners[c]];
                        points.insert(built.place(d.face_sides[2 * f], {}));
                        points.insert(built.place(d.face_sides[2 * f + 1], {of[0], of[1], of[2]}));
                    }
                for (const auto& [vertex, set] : around) {
                    const std::vector<Place> p(set.begin(), set.end());
                    ASSERT_GE(p.size(), 4u);
                    const double* t[4] = {p[0].data(), p[1].data(), nullptr, nullptr};
                    int sign = 0;
                    for (std::size_t i = 2; i < p.size() && sign == 0; ++i)
                        for (std::size_t k = i + 1; k < p.size() && sign == 0; ++k)
                            sign = orientation(t[0], t[1], t[2] = p[i].data(), t[3] = p[k].data());
                    ASSERT_NE(sign, 0);
                    if (sign < 0) std::swap(t[2], t[3]);
                    const Circumcenter center = circumcenter(t);
                    for (std::size_t c = 0; c < 3; ++c)
                        EXPECT_EQ(d.vertices[3 * std::size_t{vertex} + c], center.x[c]);
                    ++compared;
                }
            }
    EXPECT_GT(compared, 5000u);
}

// The centroids of faces and cells have the accuracy of the diagram where the caller sees them.
TEST(PeriodicDiagram, CentroidsNearTheOrigin) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-1, 1);
    for (const double size : {1e-3, 1e-8}) {
        std::vector<double> points;
        for (int i = 0; i < 30; ++i)
            for (int c = 0; c < 3; ++c)
                points.push_back(std::round(std::ldexp(size * place(random), 44)) * 0x1p-44);
        const Built built(cube, points);
        const Diagram d(built);
        const std::vector<double> offsets = built.measures(Measure::centroid);
        for (std::size_t i = 0; i < offsets.size(); ++i)
            EXPECT_NEAR(d.cell_centroids[i], points[i] + offsets[i],
                        1e-13 * (std::fabs(points[i]) + std::fabs(offsets[i])));
        for (std::size_t f = 0; f < d.face_count(); ++f) {
            // In the plane half way between the two points.
            const std::array<double, 3> p = built.place(d.face_sides[2 * f], {}),
                                        q = built.place(
                                            d.face_sides[2 * f + 1],
                                            {d.face_shifts[3 * f], d.face_shifts[3 * f + 1],
                                             d.face_shifts[3 * f + 2]});
            double height = 0, length = 0, distance = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double way = q[c] - p[c], from = d.face_centroids[3 * f + c] - p[c];
                height += way * (from - way / 2);
                length += way * way;
                distance += from * from;
            }
            EXPECT_NEAR(height, 0, 2e-12 * std::sqrt(length * distance));
        }
    }
}

}  // namespace
}  // namespace mgdt
