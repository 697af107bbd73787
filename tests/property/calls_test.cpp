// SPDX-License-Identifier: MIT
// Calls that come one after another on a triangulation that grows: insertion point by point,
// location and nearest vertices in between, exports to any address.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "handle.hpp"

namespace {

// Coordinates are small integers, so that volumes and distances below are exact.
std::vector<double> lattice_points(std::size_t n, int low, int high, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> coordinate(low, high);
    std::vector<double> xyz(3 * n);
    for (double& x : xyz) x = coordinate(random);
    return xyz;
}

double volume(const double* a, const double* b, const double* c, const double* d) {
    double m[3][3];
    const double* p[3] = {b, c, d};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) m[i][k] = p[i][k] - a[k];
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
           m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

struct Mesh {
    Mesh(const mgdt_triangulation* t, const std::vector<double>& points)
        : xyz(points), tetrahedra(property::tetrahedra(t)) {}
    const double* point(std::int64_t v) const { return &xyz[3 * static_cast<std::size_t>(v)]; }
    bool contains(std::int64_t tetrahedron, const double* q) const {
        for (std::size_t i = 0; i < 4; ++i) {
            const double* p[4];
            for (std::size_t k = 0; k < 4; ++k)
                p[k] = point(tetrahedra[4 * static_cast<std::size_t>(tetrahedron) + k]);
            p[i] = q;
            // Stored positively oriented: the sign of a volume with q in place of a vertex.
            const double sign = volume(p[0], p[1], p[2], p[3]);
            if (sign * orientation() < 0) return false;
        }
        return true;
    }
    bool hull_contains(const double* q) const {
        const std::size_t count = tetrahedra.size() / 4;
        for (std::size_t t = 0; t < count; ++t)
            if (contains(static_cast<std::int64_t>(t), q)) return true;
        return false;
    }
    double orientation() const {
        return volume(point(tetrahedra[0]), point(tetrahedra[1]), point(tetrahedra[2]),
                      point(tetrahedra[3])) > 0
                   ? 1
                   : -1;
    }

    const std::vector<double>& xyz;
    std::vector<std::int64_t> tetrahedra;
};

std::vector<std::int64_t> locate(const mgdt_triangulation* t, const std::vector<double>& queries) {
    std::vector<std::int64_t> found(queries.size() / 3);
    EXPECT_EQ(mgdt_locate_points(t, static_cast<std::int64_t>(found.size()), queries.data(),
                                 found.data(), nullptr),
              MGDT_OK);
    return found;
}

// Queries on vertices, edges, facets, inside and outside; the count is no multiple of the streams.
TEST(Calls, LocationsContainTheirPoints) {
    const std::vector<double> xyz = lattice_points(is_small() ? 60 : 400, -40, 40, 1);
    const property::Handle t = property::create();
    ASSERT_EQ(property::insert(t.get(), xyz, {0}), MGDT_OK);
    const Mesh mesh(t.get(), xyz);
    for (const std::size_t n : {1u, 2u, 7u, 17u, is_small() ? 50u : 1001u}) {
        const std::vector<double> queries = lattice_points(n, -45, 45, static_cast<unsigned>(n));
        const std::vector<std::int64_t> found = locate(t.get(), queries);
        for (std::size_t i = 0; i < n; ++i) {
            const double* q = &queries[3 * i];
            if (found[i] >= 0)
                EXPECT_TRUE(mesh.contains(found[i], q)) << i;
            else
                EXPECT_FALSE(mesh.hull_contains(q)) << i;
        }
    }
}

TEST(Calls, NearestVerticesAreNearest) {
    const std::vector<double> xyz = lattice_points(is_small() ? 60 : 2000, -40, 40, 2);
    const std::vector<double> queries = lattice_points(is_small() ? 20 : 300, -60, 60, 3);
    const property::Handle t = property::create();
    ASSERT_EQ(property::insert(t.get(), xyz, {0}), MGDT_OK);
    for (std::size_t i = 0; i < queries.size(); i += 3) {
        std::int64_t found = -1, expected = -1;
        ASSERT_EQ(mgdt_nearest_vertex(t.get(), &queries[i], &found), MGDT_OK);
        double least = 1e300;
        for (std::size_t v = 0; v < xyz.size(); v += 3) {
            double square = 0;
            for (std::size_t k = 0; k < 3; ++k)
                square += (xyz[v + k] - queries[i + k]) * (xyz[v + k] - queries[i + k]);
            if (square >= least) continue;
            least = square;
            expected = static_cast<std::int64_t>(v / 3);
        }
        EXPECT_EQ(found, expected);
    }
}

// What keeps places for later walks has to follow: the set grows many times over, everywhere and
// then in one corner, with repeats, and is asked in between.
TEST(Calls, PointByPointAfterABatch) {
    const std::size_t batch = is_small() ? 520 : 700;
    std::vector<double> xyz = lattice_points(batch, -1000, 1000, 4);
    const std::vector<double> everywhere = lattice_points(batch, -1000, 1000, 5),
                              corner = lattice_points(4 * batch, 900, 1000, 6);
    xyz.insert(xyz.end(), everywhere.begin(), everywhere.end());
    xyz.insert(xyz.end(), corner.begin(), corner.end());
    const property::Handle t = property::create(), whole = property::create();
    ASSERT_EQ(mgdt_insert_points(t.get(), static_cast<std::int64_t>(batch), xyz.data()), MGDT_OK);
    for (std::size_t i = batch; i < xyz.size() / 3; ++i) {
        ASSERT_EQ(mgdt_insert_points(t.get(), 1, &xyz[3 * i]), MGDT_OK);
        if (i % 64 != 0) continue;
        std::int64_t vertex = -1;
        ASSERT_EQ(mgdt_nearest_vertex(t.get(), &xyz[3 * i], &vertex), MGDT_OK);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(xyz[3 * static_cast<std::size_t>(vertex) + k], xyz[3 * i + k]);
        locate(t.get(), {xyz[3 * i], 0, 0});
    }
    EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK) << property::error_of(t.get());
    ASSERT_EQ(property::insert(whole.get(), xyz, {0}), MGDT_OK);
    EXPECT_EQ(property::keys(property::tetrahedra(t.get())),
              property::keys(property::tetrahedra(whole.get())));
}

TEST(Calls, ExportsToAnyAddress) {
    const std::vector<double> xyz = lattice_points(200, -50, 50, 7);
    const property::Handle t = property::create();
    ASSERT_EQ(property::insert(t.get(), xyz, {0}), MGDT_OK);
    const std::vector<std::int64_t> tetrahedra = property::tetrahedra(t.get()),
                                    neighbors = property::neighbors(t.get());
    const std::int64_t size = static_cast<std::int64_t>(tetrahedra.size());
    for (std::size_t shift = 0; shift < 8; ++shift) {
        // What stands before and after stays.
        std::vector<std::int32_t> out(tetrahedra.size() + 16, -7);
        std::vector<std::int64_t> wide(tetrahedra.size() + 16, -7);
        const auto expect = [&](const auto& got, const std::vector<std::int64_t>& wanted) {
            for (std::size_t i = 0; i < got.size(); ++i)
                ASSERT_EQ(got[i], i < shift || i - shift >= wanted.size() ? -7 : wanted[i - shift]);
        };
        ASSERT_EQ(mgdt_get_tetrahedra_i32(t.get(), size, out.data() + shift), MGDT_OK);
        expect(out, tetrahedra);
        ASSERT_EQ(mgdt_get_neighbors_i32(t.get(), size, out.data() + shift), MGDT_OK);
        expect(out, neighbors);
        ASSERT_EQ(mgdt_get_tetrahedra(t.get(), size, wide.data() + shift), MGDT_OK);
        expect(wide, tetrahedra);
    }
}

}  // namespace
