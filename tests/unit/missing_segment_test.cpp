// SPDX-License-Identifier: MIT
// Segments that are edges of a triangulation, and those that are not, from both of their ends.
#include "domain/missing_segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace mgdt {
namespace {

// Some points of a lattice, or all.
std::vector<double> lattice_points(unsigned seed, std::size_t count) {
    constexpr unsigned side = 5;
    std::vector<unsigned> numbers(side * side * side);
    std::iota(numbers.begin(), numbers.end(), 0u);
    std::shuffle(numbers.begin(), numbers.end(), std::mt19937(seed));
    numbers.resize(std::min(count, numbers.size()));
    std::vector<double> points;
    for (const unsigned i : numbers)
        for (const unsigned x : {i % side, i / side % side, i / side / side}) points.push_back(x);
    return points;
}

// Segments of a lattice pass through edges and along faces of its tetrahedra.
TEST(MissingSegment, IsTheSameFromBothEnds) {
    std::size_t missing = 0;
    for (unsigned seed = 1; seed < 9; ++seed) {
        const std::vector<double> points = lattice_points(seed, seed % 2 == 0 ? 125 : 40);
        Allocator allocator;
        Triangulation triangulation(nullptr, nullptr, nullptr);
        const double* const axis[3] = {points.data(), points.data() + 1, points.data() + 2};
        const auto n = static_cast<std::uint32_t>(points.size() / 3);
        triangulation.insert(n, axis, 3);
        ASSERT_EQ(triangulation.dimension(), 3);
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        const Mesh& mesh = triangulation.mesh();
        for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
            if (mesh.tetrahedra[t].is_dead() || mesh.tetrahedra[t].is_ghost()) continue;
            for (const VertexId a : mesh.tetrahedra[t].v)
                for (const VertexId b : mesh.tetrahedra[t].v)
                    edges.insert({mesh.vertices[a].index, mesh.vertices[b].index});
        }
        MissingSegment search(triangulation, allocator);
        for (std::uint32_t a = 0; a < n; ++a)
            for (std::uint32_t b = a + 1; b < n; ++b) {
                int divisor = 0;
                for (std::size_t k = 0; k < 3; ++k)
                    divisor = std::gcd(divisor, int(points[3 * a + k]) - int(points[3 * b + k]));
                if (divisor > 1) continue;  // other points may be inside of the segment
                const bool is_missing = edges.count({a, b}) == 0;
                ASSERT_EQ(search.find(a, b), is_missing);
                const std::uint32_t reference = is_missing ? search.reference() : 0;
                ASSERT_EQ(search.find(b, a), is_missing);
                if (!is_missing) continue;
                ASSERT_EQ(search.reference(), reference)
                    << "seed " << seed << ": " << a << ", " << b;
                ++missing;
            }
    }
    EXPECT_GT(missing, 10000u);
}

}  // namespace
}  // namespace mgdt
