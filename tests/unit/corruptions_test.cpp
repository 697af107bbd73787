// SPDX-License-Identifier: MIT
// Every field of every record is spoiled, in sound triangulations of every kind, at random places:
// the check must say so at the level that promises it and the deeper ones, in words that name what
// and where, and must follow nothing that leads nowhere.
#include "corruptions.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "../support/small.h"

namespace mgdt {
namespace {

using namespace surgery;

TEST(Corruptions, SoundOnesPass) {
    Random random(1);
    for (const Family& family : families()) {
        Patient p = family.make(random);
        for (int level = 1; level <= 3; ++level)
            for (const unsigned threads : {1u, 3u})
                EXPECT_EQ(p.complaint(level, threads), "") << family.name;
        // As they would be put together from nothing but their tetrahedra.
        p.assemble(p.finite());
        EXPECT_EQ(p.complaint(3), "") << family.name << ", reassembled";
    }
}

TEST(Corruptions, AreFound) {
    Random random(2);
    const unsigned seeds = is_small() ? 1 : 12;
    for (const Corruption& corruption : corruptions()) {
        int done = 0;
        for (const Family& family : families())
            for (unsigned seed = 0; seed < seeds; ++seed) {
                Patient p = family.make(random);
                if (!corruption.act(p, random)) continue;
                ++done;
                for (int level = 1; level <= 3; ++level) {
                    const std::string found = p.complaint(level, 1 + seed % 2);
                    const std::string where = std::string(corruption.name) + " in " + family.name +
                                              " at level " + std::to_string(level);
                    if (level < corruption.level) {
                        EXPECT_EQ(found, "") << where;
                        continue;
                    }
                    EXPECT_NE(found, "") << where;
                    EXPECT_NE(found.find(corruption.complaint), std::string::npos)
                        << where << ": " << found;
                }
            }
        EXPECT_GT(done, 0) << corruption.name;
    }
}

// Any number of fields overwritten by anything: what the check says is then of no matter, but it
// must come to an end and read nothing that is not there.
TEST(Corruptions, NothingIsFollowedBlindly) {
    Random random(3);
    const int rounds = is_small() ? 2 : 150;
    int found = 0;
    for (const Family& family : families())
        for (int round = 0; round < rounds; ++round) {
            Patient p = family.make(random);
            Mesh& m = p.mesh();
            const auto spoil = [&](std::uint32_t& value, std::size_t limit) {
                value =
                    static_cast<std::uint32_t>(below(random, 3) ? below(random, limit) : random());
            };
            for (std::size_t fields = 1 + below(random, 8); fields-- > 0;) {
                const std::size_t id = below(random, m.tetrahedra.size());
                Tetrahedron& t = m.tetrahedra[id];
                KeptSphere& s = m.tetrahedra.sphere(id);
                Vertex& v = m.vertices[below(random, m.vertices.size())];
                switch (below(random, 9)) {
                    case 0:
                        spoil(t.v[below(random, 4)], m.vertices.size());
                        break;
                    case 1:
                        spoil(t.n[below(random, 4)], 4 * m.tetrahedra.size());
                        break;
                    case 2:
                        s.w[below(random, 3)] = upper_half(any_double(random));
                        break;
                    case 3:
                        s.e = upper_half(any_double(random));
                        break;
                    case 4:
                        v.x[below(random, 3)] = any_double(random);
                        break;
                    case 5:
                        spoil(v.index, p.map().size());
                        break;
                    case 6:
                        spoil(p.map()[below(random, p.map().size())], m.vertices.size());
                        break;
                    case 7:
                        spoil(m.vertex_hint[below(random, m.vertex_hint.size())],
                              m.tetrahedra.size());
                        break;
                    default:
                        spoil(m.a_ghost, m.tetrahedra.size());
                        break;
                }
            }
            // Nothing that would be reported first may hide the rest.
            for (int level = 1; level <= 3; ++level) found += !p.complaint(level).empty();
        }
    EXPECT_GT(found, rounds);
}

// What may be otherwise without harm is not reported.
TEST(Corruptions, HarmlessOnesPass) {
    Random random(4);
    for (const Family& family : families()) {
        Patient p = family.make(random);
        Mesh& m = p.mesh();
        for (TetId& t : m.vertex_hint) t = static_cast<TetId>(below(random, m.tetrahedra.size()));
        for (Vertex& v : m.vertices) v.moved_to = static_cast<VertexId>(random());
        for (double& x : m.vertices[0].x) x = any_double(random);
        m.a_ghost = p.any(random, true);
        p.input.last = p.any_live(random);
        m.has_extremes = true;
        for (std::size_t id = 0; id < m.tetrahedra.size(); ++id) {
            Tetrahedron& t = m.tetrahedra[id];
            KeptSphere& s = m.tetrahedra.sphere(id);
            const double e = from_upper_half(s.e);
            if (t.is_dead()) {
                for (int i = 0; i < 4; ++i) {
                    t.n[i] = static_cast<FacetCode>(random());
                    if (i > 0) t.v[i] = static_cast<VertexId>(random());
                }
                s.e = upper_half(any_double(random));
            } else if (below(random, 4) == 0) {
                // Larger bounds leave more to the exact predicates, infinite ones all.
                s.e = upper_half(below(random, 2)
                                     ? 2 * e
                                     : std::copysign(std::numeric_limits<double>::infinity(), e));
            } else if (below(random, 2) == 0) {
                // As little as that the bound can spare.
                s.e -= std::isinf(e) ? 0 : 1;
            } else {
                // The last bit of an upper half is twice what its rounding adds to the bound.
                s.e = upper_half(4 * e);
                for (std::uint32_t& w : s.w)
                    if ((w & 0x7FFFFFFFu) != 0) w += below(random, 2) ? 1u : ~0u;
            }
        }
        EXPECT_EQ(p.complaint(3), "") << family.name;
    }
}

// Points that do not span space have no tetrahedra; they are checked as well.
TEST(Corruptions, OfPointsThatDoNotSpanSpace) {
    Random random(5);
    const auto make = [&] {
        Points xyz;
        for (int i = 0; i < 30; ++i)
            xyz.insert(xyz.end(), {uniform(random), uniform(random), 0.25});
        return triangulate(xyz);
    };
    EXPECT_EQ(make().complaint(3), "");
    EXPECT_EQ(triangulate({}).complaint(3), "");
    EXPECT_EQ(triangulate({1, 2, 3}).complaint(3), "");
    EXPECT_EQ(triangulate({1, 2, 3, 4, 5, 6, 7, 8, 9}).complaint(3), "");
    {
        Patient p = make();
        p.mesh().vertices[7].x[2] += 0x1p-50;
        EXPECT_EQ(p.complaint(1), "");
        EXPECT_NE(p.complaint(2).find("dimension"), std::string::npos) << p.complaint(2);
    }
    {
        Patient p = make();
        std::copy_n(p.mesh().vertices[3].x, 3, p.mesh().vertices[4].x);
        EXPECT_NE(p.complaint(2).find("one place"), std::string::npos) << p.complaint(2);
    }
    {
        Patient p = make();
        p.input.dimension = 1;
        EXPECT_NE(p.complaint(2).find("dimension 2, not 1"), std::string::npos) << p.complaint(2);
    }
    {
        Patient p = make();
        p.input.dimension = 3;
        EXPECT_NE(p.complaint(1).find("0 tetrahedra in dimension 3"), std::string::npos);
    }
    {
        Patient p = make();
        p.mesh().vertices.clear();
        EXPECT_NE(p.complaint(1).find("infinity is missing"), std::string::npos);
    }
}

}  // namespace
}  // namespace mgdt
