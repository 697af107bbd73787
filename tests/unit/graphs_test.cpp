// SPDX-License-Identifier: MIT
// Graphs of neighbours against their definitions, looked up among all pairs of points.
#include "query/graphs.hpp"

#include "histories.hpp"
#include "predicates/predicates.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

using namespace histories;
using Edges = std::vector<std::array<std::uint32_t, 2>>;

MeshView view(Team& team, const Triangulation& t) {
    return {team, t.mesh(), nullptr, t.allocator(), 0, false};
}

Edges gabriel(const Triangulation& t, unsigned threads) {
    Team team(threads);
    const EdgeLists lists = gabriel_edges(view(team, t), t.point_map().size(), Unwatched());
    Edges edges(lists.size());
    lists.write(
        [&](std::size_t k, std::size_t place, const std::uint32_t* others, std::size_t size) {
            for (std::size_t i = 0; i < size; ++i)
                edges[place + i] = {static_cast<std::uint32_t>(k), others[i]};
        });
    return edges;
}

Edges tree(const Triangulation& t, unsigned threads) {
    Team team(threads);
    const Buffer<std::uint32_t> ends = spanning_tree(view(team, t), t.point_map(), Unwatched());
    Edges edges;
    for (std::size_t i = 0; i < ends.size(); i += 2) edges.push_back({ends[i], ends[i + 1]});
    return edges;
}

// The points that stand for vertices.
std::vector<std::uint32_t> vertices_of(const Triangulation& t) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t i : points_in(t))
        if (t.mesh().vertices[t.point_map()[i]].index == i) all.push_back(i);
    return all;
}

TEST(Graphs, AgainstTheirDefinitions) {
    Random random(1);
    for (const Points& xyz : sets(random))
        for (const bool is_changed : {false, true}) {
            const auto t = empty();
            insert(*t, xyz);
            if (is_changed) {
                std::vector<std::uint32_t> leaving = points_in(*t);
                std::shuffle(leaving.begin(), leaving.end(), random);
                leaving.resize(leaving.size() / 3);
                remove(*t, leaving);
            }
            ASSERT_EQ(t->dimension(), 3);
            const std::vector<std::uint32_t> all = vertices_of(*t);
            const auto point = [&](std::uint32_t i) { return &xyz[3 * i]; };
            Edges expected, pairs;
            for (const std::uint32_t a : all)
                for (const std::uint32_t b : all) {
                    if (a >= b) continue;
                    pairs.push_back({a, b});
                    bool is_empty = true;
                    for (std::size_t k = 0; is_empty && k < all.size(); ++k)
                        is_empty = side_of_diametral_sphere(point(a), point(b), point(all[k])) <= 0;
                    if (is_empty) expected.push_back({a, b});
                }
            const Edges found = gabriel(*t, 1);
            // A lattice has diagonals of one length that cross: the tetrahedra have one of them.
            EXPECT_TRUE(
                std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
            for (const std::array<std::uint32_t, 2>& e : expected) {
                bool is_tied = false;
                for (const std::uint32_t c : all)
                    is_tied |= c != e[0] && c != e[1] &&
                               side_of_diametral_sphere(point(e[0]), point(e[1]), point(c)) == 0;
                EXPECT_TRUE(is_tied || std::binary_search(found.begin(), found.end(), e));
            }
            EXPECT_EQ(gabriel(*t, 3), found);

            // Prim's, with edges compared as spanning_tree() says.
            std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
                const int s = compare_lengths(point(a[0]), point(a[1]), point(b[0]), point(b[1]));
                return s != 0 ? s < 0 : a < b;
            });
            std::set<std::uint32_t> joined = {all[0]};
            Edges shortest;
            while (joined.size() < all.size())
                for (const std::array<std::uint32_t, 2>& e : pairs)
                    if (joined.count(e[0]) != joined.count(e[1])) {
                        joined.insert({e[0], e[1]});
                        shortest.push_back(e);
                        break;
                    }
            std::sort(shortest.begin(), shortest.end());
            EXPECT_EQ(tree(*t, 1), shortest);
            EXPECT_EQ(tree(*t, 3), shortest);
        }
}

TEST(Graphs, AreEmptyWithoutTetrahedra) {
    for (const Points& xyz : {Points{}, Points{1, 2, 3}, Points{0, 0, 0, 1, 0, 0, 0, 1, 0}}) {
        const auto t = empty();
        insert(*t, xyz);
        EXPECT_TRUE(gabriel(*t, 1).empty());
        EXPECT_TRUE(tree(*t, 1).empty());
    }
}

}  // namespace
}  // namespace mgdt
