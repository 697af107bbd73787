// SPDX-License-Identifier: MIT
// A triangulation in parts has the tetrahedra of one of all points, for every number of parts.
#include "parts/parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "../support/aligned.h"
#include "../support/points.hpp"
#include "../support/small.h"
#include "parts/in_process.hpp"
#include "predicates/predicates.hpp"
#include "thread_transport.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

using mgdt_tests::Points;
using mgdt_tests::uniform;
using Tetrahedra = std::vector<std::array<std::int64_t, 4>>;  // sorted, by the caller's numbers

Tetrahedra of_one(const Points& xyz) {
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
    Tetrahedra all;
    for (TetId i = 0; i < t.mesh().tetrahedra.size(); ++i) {
        const Tetrahedron& tetrahedron = t.mesh().tetrahedra[i];
        if (tetrahedron.is_dead() || tetrahedron.is_ghost()) continue;
        std::array<std::int64_t, 4> v;
        for (unsigned k = 0; k < 4; ++k) v[k] = t.mesh().vertices[tetrahedron.v[k]].index;
        std::sort(v.begin(), v.end());
        all.push_back(v);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// The points dealt out in runs, by shares of 1 to 16 of them, so that some parts are given few.
struct Dealt {
    Dealt(const Points& xyz, PartId parts, bool to_one) {
        std::mt19937 random(parts);
        std::vector<double> share(parts + std::size_t{1}, 0);
        for (PartId p = 0; p < parts; ++p)
            share[p + 1] = share[p] + (to_one ? p + 1 == parts : random() % 16 + 1);
        const double n = static_cast<double>(xyz.size()) / 3;
        for (PartId p = 0; p < parts; ++p) {
            const auto at = [&](PartId i) {
                return static_cast<std::size_t>(n * share[i] / share[parts]);
            };
            given.push_back({xyz.data() + 3 * at(p), at(p + 1) - at(p)});
        }
    }
    std::vector<GivenPoints> given;
};

// Parts in this process.
struct Built {
    Built(const Points& xyz, PartId parts, bool to_one = false)
        : transport(parts),
          collective(transport),
          all(collective, nullptr, nullptr, nullptr),
          dealt(xyz, parts, to_one),
          progress(CallSettings(), cancelled) {
        collective.run([&] { all.build(dealt.given.data(), nullptr, progress); });
    }
    void check() {
        collective.run([&] { all.check(MGDT_CHECK_CANONICAL, Unwatched()); });
    }

    InProcess transport;
    Collective collective;
    Parts all;
    Dealt dealt;
    StopFlag cancelled;
    StageProgress progress;
};

void expect_defect(Built& built) {
    try {
        built.check();
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.status, MGDT_ERR_CHECK_FAILED) << e.message;
    }
}

struct Outcome {
    Tetrahedra owned;
    std::size_t received = 0, most = 0, least = 0;
};

Outcome in_parts(const Points& xyz, PartId parts, bool to_one = false) {
    Built built(xyz, parts, to_one);
    if (parts <= 8 && xyz.size() < 3 * 2000) built.check();
    const Parts& all = built.all;
    Outcome outcome;
    outcome.least = xyz.size();
    std::vector<std::int64_t> ghosts;
    for (PartId p = 0; p < parts; ++p) {
        const Part& part = all.local(p);
        outcome.received += part.point_count() - part.own_count();
        outcome.most = std::max(outcome.most, part.own_count());
        outcome.least = std::min(outcome.least, part.own_count());
        part.each_tetrahedron([&](TetId, const std::uint32_t(&v)[4], unsigned, bool is_owned) {
            if (!is_owned) return;
            std::array<std::int64_t, 4> ids;
            for (unsigned k = 0; k < 4; ++k) ids[k] = part.point(v[k]).id;
            std::sort(ids.begin(), ids.end());
            outcome.owned.push_back(ids);
        });
        // Where the points went.
        for (std::size_t i = 0; i < built.dealt.given[p].n; ++i) {
            const std::int64_t vertex = all.vertices_of_given(p)[i];
            const PartId home = all.homes().of(built.dealt.given[p].xyz + 3 * i);
            EXPECT_GE(vertex, all.first_vertex(home));
            EXPECT_LT(vertex, all.first_vertex(home + 1));
            const PartPoint& x =
                all.local(home).point(static_cast<std::uint32_t>(vertex - all.first_vertex(home)));
            EXPECT_EQ(x.number, vertex);
            EXPECT_TRUE(std::equal(x.x, x.x + 3, built.dealt.given[p].xyz + 3 * i));
        }
    }
    std::sort(outcome.owned.begin(), outcome.owned.end());
    return outcome;
}

// Numbers, owners and neighbours of the tetrahedra of all parts agree with each other, and with
// those of one triangulation.
void expect_consistent(const Points& xyz, PartId parts) {
    Built built(xyz, parts);
    if (parts <= 8 && xyz.size() < 3 * 2000) built.check();
    const Parts& all = built.all;
    std::vector<std::array<std::int64_t, 4>> vertices, neighbors;
    std::vector<PartId> owner;
    for (PartId p = 0; p < parts; ++p) {
        const PartTetrahedra& t = all.tetrahedra(p);
        std::vector<std::int64_t> v(4 * t.size()), n(4 * t.owned());
        t.get_vertices(all.local(p), v.data());
        t.get_neighbors(all.local(p), n.data());
        for (std::size_t i = 0; i < t.owned(); ++i) {
            EXPECT_EQ(t.number(i), static_cast<std::int64_t>(vertices.size()));
            EXPECT_EQ(t.owner(i), p);
            vertices.push_back({v[4 * i], v[4 * i + 1], v[4 * i + 2], v[4 * i + 3]});
            neighbors.push_back({n[4 * i], n[4 * i + 1], n[4 * i + 2], n[4 * i + 3]});
            owner.push_back(p);
        }
    }
    const auto sorted = [](auto v) {
        std::sort(v.begin(), v.end());
        return v;
    };
    for (PartId p = 0; p < parts; ++p) {
        const PartTetrahedra& t = all.tetrahedra(p);
        std::vector<std::int64_t> of_part(4 * t.size());
        t.get_vertices(all.local(p), of_part.data());
        for (std::size_t i = 0; i < t.size(); ++i) {
            const auto number = static_cast<std::size_t>(t.number(i));
            ASSERT_LT(number, vertices.size());
            EXPECT_EQ(t.owner(i), owner[number]);
            const std::array<std::int64_t, 4> v = {of_part[4 * i], of_part[4 * i + 1],
                                                   of_part[4 * i + 2], of_part[4 * i + 3]};
            EXPECT_EQ(sorted(v), sorted(vertices[number]));
        }
    }
    std::size_t hull = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t face = 0; face < 4; ++face) {
            const std::int64_t beyond = neighbors[i][face];
            if (beyond < 0) {
                ++hull;
                continue;
            }
            ASSERT_LT(beyond, static_cast<std::int64_t>(vertices.size()));
            const auto other = static_cast<std::size_t>(beyond);
            EXPECT_NE(other, i);
            int shared = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                if (k == face) continue;
                const auto& theirs = vertices[other];
                shared += std::find(theirs.begin(), theirs.end(), vertices[i][k]) != theirs.end();
            }
            EXPECT_EQ(shared, 3);
            EXPECT_EQ(std::count(neighbors[other].begin(), neighbors[other].end(),
                                 static_cast<std::int64_t>(i)),
                      1);
        }
    Triangulation one(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    one.insert(xyz.size() / 3, axis, 3);
    EXPECT_EQ(hull, one.mesh().ghost_count);
    EXPECT_EQ(vertices.size(), one.mesh().finite_count());
}

Points integers(std::size_t n, unsigned end, unsigned seed = 1) {
    std::mt19937_64 random(seed);
    Points xyz(3 * n);
    for (double& x : xyz) x = static_cast<double>(random() % end);
    return xyz;
}

// On a sphere, a spiral, two lines, in a cluster.
Points special(const std::string& kind, std::size_t n) {
    Points xyz = uniform(n, 5);
    for (std::size_t i = 0; i < n; ++i) {
        double* const x = xyz.data() + 3 * i;
        if (kind == "sphere") {
            double length = 0;
            for (int k = 0; k < 3; ++k) x[k] -= 0.5, length += x[k] * x[k];
            for (int k = 0; k < 3; ++k) x[k] /= std::sqrt(length);
        } else if (kind == "spiral") {
            const double a = 25 * x[0], noise = 1e-4 * x[1];
            x[1] = x[0] * std::cos(a) + noise;
            x[2] = x[0] * std::sin(a) - noise;
        } else if (kind == "cluster") {
            for (int k = 0; k < 3; ++k) x[k] = std::pow(x[k], 5);
        } else if (kind == "two lines") {
            x[1] = i % 2 == 0 ? 0 : 1;
            x[2] = i % 2 == 0 ? x[0] : 0;
            if (i % 2) std::swap(x[0], x[2]);
        } else if (kind == "extremes") {
            const double sizes[] = {1e-300, 1e-100, 1, 1e100, 1e300};
            for (int k = 0; k < 3; ++k)
                x[k] = (x[k] - 0.5) * sizes[(i + static_cast<std::size_t>(k)) % 5];
        }
    }
    return xyz;
}

void expect_equal(const Points& xyz, std::initializer_list<PartId> numbers, bool to_one = false) {
    const Tetrahedra expected = of_one(xyz);
    for (const PartId parts : numbers) {
        SCOPED_TRACE(parts);
        EXPECT_EQ(in_parts(xyz, parts, to_one).owned, expected);
    }
}

TEST(Parts, HaveTheTetrahedraOfOne) {
    const std::size_t n = is_small() ? 500 : 5000;
    expect_equal(uniform(n), {1, 2, 3, 4, 7, 8, 16, 64});
    for (const char* kind : {"sphere", "spiral", "cluster", "two lines", "extremes"}) {
        SCOPED_TRACE(kind);
        expect_equal(special(kind, is_small() ? 100 : 1500), {2, 3, 7, 16});
    }
}

TEST(Parts, BreakTiesAlike) {
    for (const unsigned end : {2u, 3u, 8u, 20u}) {
        SCOPED_TRACE(end);
        expect_equal(integers(is_small() ? 300 : 3000, end), {1, 2, 5, 8, 33});
    }
}

TEST(Parts, MayBeEmptyOrFlat) {
    expect_equal(uniform(10), {2, 4, 16, 100});
    expect_equal(uniform(2), {1, 3});
    expect_equal({}, {1, 3});
    Points flat = uniform(300);
    for (std::size_t i = 0; i < flat.size(); i += 3) flat[i] = 0.25;
    expect_equal(flat, {1, 4});
    const double apex[] = {2, 0.5, 0.5};
    flat.insert(flat.end(), apex, apex + 3);
    expect_equal(flat, {1, 4, 9});
    Points same(3 * 50, 0.5);
    expect_equal(same, {1, 4});
    const Points more = uniform(200);
    same.insert(same.end(), more.begin(), more.end());
    expect_equal(same, {1, 4, 9});
}

TEST(Parts, MayAllBeGivenToOne) {
    expect_equal(uniform(is_small() ? 300 : 3000), {2, 8}, true);
}

// A point whose products with the ball's coefficients are below the least double.
TEST(Parts, SeeThroughUnderflow) {
    const double v = 6.26302612502804e-294, third = 1.878907837508412e-293;
    const double corner[4][3] = {{0, 0, 0},
                                 {6.0e-31, -6.0e-31, -2.9e-31},
                                 {-7.8e-32, -3.7e-31, 7.2e-31},
                                 {-4.2e-31, -5.9e-31, 4.8e-31}};
    const auto relative = [&](int i) { return relative_to(corner[i], corner[0]); };
    // Any orientation: the sphere of either order is the same.
    Sphere s;
    set_sphere(relative(1), relative(2), relative(3), s);
    if (!(s.e < infinity)) set_sphere(relative(1), relative(3), relative(2), s);
    ASSERT_LT(s.e, infinity);
    for (const double sign : {1.0, -1.0}) {
        const double at[3] = {sign * v, sign * v, sign * third};
        const BoundingBox box(at);
        EXPECT_TRUE(Boxes::meets_ball(box, s, corner[0], 0)) << sign;
    }
}

// Planes through boxes of one place and of several, which rounding puts on either side.
TEST(Parts, SeeCornersBeyondAFacet) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> real(-1, 1);
    std::uniform_int_distribution<int> integer(-2, 2);
    int beyond = 0, inside = 0;
    const int n = is_small() ? 2000 : 100000;
    for (int i = 0; i < n; ++i) {
        const double size = i % 5 == 0 ? std::ldexp(1, -355) : i % 7 == 0 ? 1e-3 : 1;
        double p[4][3];
        for (auto& x : p)
            for (double& c : x) c = i % 3 == 0 ? integer(random) : size * real(random);
        if (orientation(p[0], p[1], p[2], p[3]) == 0) continue;
        const double s = real(random), t = i % 4 == 0 ? 10 * real(random) : real(random);
        BoundingBox box;
        for (int k = 0; k < 3; ++k) {
            const double at = p[0][k] + s * (p[1][k] - p[0][k]) + t * (p[2][k] - p[0][k]),
                         extent = i % 2 == 0 ? 0 : std::fabs(size * real(random)) * 1e-9;
            box.low[k] = at - extent;
            box.high[k] = at + extent;
        }
        bool expected = false;
        for (int corner = 0; corner < 8; ++corner) {
            const double y[3] = {(corner & 1 ? box.high : box.low)[0],
                                 (corner & 2 ? box.high : box.low)[1],
                                 (corner & 4 ? box.high : box.low)[2]};
            expected |= orientation(p[0], p[1], p[2], y) == -orientation(p[0], p[1], p[2], p[3]);
        }
        EXPECT_EQ(Boxes::is_beyond(box, Boxes::Facet(p[0], p[1], p[2], p[3])), expected) << i;
        (expected ? beyond : inside) += 1;
    }
    EXPECT_GT(beyond, n / 8);
    EXPECT_GT(inside, n / 8);
}

TEST(Parts, NumberTheirTetrahedra) {
    for (const PartId parts : {1u, 2u, 5u, 16u}) {
        SCOPED_TRACE(parts);
        expect_consistent(uniform(is_small() ? 300 : 2000), parts);
        expect_consistent(integers(is_small() ? 200 : 1000, 6), parts);
        expect_consistent(special("sphere", is_small() ? 100 : 500), parts);
        expect_consistent(special("two lines", 60), parts);
        expect_consistent(uniform(3), parts);
    }
}

TEST(Parts, OfManyProcesses) {
    expect_equal(uniform(is_small() ? 1000 : 20000), {is_small() ? PartId{100} : PartId{1000}});
}

TEST(Parts, ShareEvenly) {
    const std::size_t n = is_small() ? 600 : 60000;
    for (const Points& xyz : {uniform(n), special("cluster", n), special("spiral", n)}) {
        const PartId parts = 8;
        const Outcome outcome = in_parts(xyz, parts);
        EXPECT_LT(static_cast<double>(outcome.most), 1.01 * static_cast<double>(n) / parts + 1);
    }
}

// As in processes: what each of the threads has in the end.
struct OfProcess {
    Tetrahedra owned;
    std::size_t own_points = 0;
    mgdt_status status = MGDT_OK;
    std::string message;
};

// Memory that ends after some bytes.
struct Memory {
    std::size_t left;

    static void* take(std::size_t size, std::size_t align, void* user) {
        auto& left = static_cast<Memory*>(user)->left;
        if (size > left) return nullptr;
        left -= size;
        return allocate_aligned(size, align);
    }
    static void give_back(void* block, std::size_t, std::size_t, void*) { free_aligned(block); }
};

struct Shortage {
    PartId part;
    std::size_t memory;
};

std::vector<OfProcess> in_processes(const Points& xyz, PartId parts, bool to_one = false,
                                    Shortage shortage = {0, SIZE_MAX}) {
    MeetingPlace place(parts);
    const Dealt dealt(xyz, parts, to_one);
    std::vector<OfProcess> all(parts);
    std::vector<std::thread> threads;
    for (PartId p = 0; p < parts; ++p)
        threads.emplace_back([&, p] {
            ThreadTransport transport(place, p);
            Collective collective(transport);
            Memory memory{p == shortage.part ? shortage.memory : SIZE_MAX};
            try {
                collective.run([&] {
                    Parts mine(collective, Memory::take, Memory::give_back, &memory);
                    StopFlag cancelled;
                    StageProgress progress(CallSettings(), cancelled);
                    mine.build(&dealt.given[p], nullptr, progress);
                    const Part& part = mine.local(0);
                    all[p].own_points = part.own_count();
                    part.each_tetrahedron(
                        [&](TetId, const std::uint32_t(&v)[4], unsigned, bool is_owned) {
                            if (!is_owned) return;
                            std::array<std::int64_t, 4> ids;
                            for (unsigned k = 0; k < 4; ++k) ids[k] = part.point(v[k]).id;
                            std::sort(ids.begin(), ids.end());
                            all[p].owned.push_back(ids);
                        });
                });
            } catch (const Error& e) {
                all[p].status = e.status;
                all[p].message = e.message;
            }
        });
    for (std::thread& t : threads) t.join();
    return all;
}

TEST(Parts, InProcesses) {
    const Points xyz = uniform(is_small() ? 500 : 5000);
    const Tetrahedra expected = of_one(xyz);
    for (const PartId parts : {1u, 2u, 5u, 8u}) {
        Tetrahedra owned;
        for (const OfProcess& p : in_processes(xyz, parts)) {
            EXPECT_EQ(p.status, MGDT_OK) << p.message;
            owned.insert(owned.end(), p.owned.begin(), p.owned.end());
        }
        std::sort(owned.begin(), owned.end());
        EXPECT_EQ(owned, expected);
    }
}

// A point that one part has, and its home has not: each triangulation is one of Delaunay.
TEST(Parts, AreFoundOutWhereTheyDoNotFit) {
    const Points xyz = uniform(400);
    Built built(xyz, 4);
    built.check();
    auto& part = const_cast<Part&>(built.all.local(1));
    PartPoint stranger = part.point(0);
    for (double& x : stranger.x) x += 0x1p-20;
    stranger.number = 400;
    part.insert(&stranger, 1, built.progress, 0, 1);
    expect_defect(built);
}

// A ghost with other coordinates than its owner's vertex, an own point that is at home elsewhere, a
// tetrahedron that is listed as another: the numbers alone would agree.
TEST(Parts, AreFoundOutWhereTheyDiffer) {
    const Points xyz = uniform(400);
    for (int damage = 0; damage < 3; ++damage) {
        SCOPED_TRACE(damage);
        Built built(xyz, 4);
        const PartTetrahedra& t = built.all.tetrahedra(1);
        ASSERT_GT(t.ghosts().size(), 0u);
        auto* const points = const_cast<PartPoint*>(built.all.local(1).points());
        if (damage == 0) points[t.ghosts()[0]].x[0] += 0x1p-50;
        if (damage == 1) points[0].x[0] += 10;
        if (damage == 2) const_cast<PartTetrahedra&>(t).forget();
        expect_defect(built);
    }
}

// All points come from one process, and each gets its share.
TEST(Parts, ShareWhatOneWasGiven) {
    const std::size_t n = is_small() ? 500 : 8000;
    const PartId parts = is_small() ? 5 : 40;
    std::size_t most = 0, sum = 0;
    for (const OfProcess& p : in_processes(uniform(n), parts, true)) {
        EXPECT_EQ(p.status, MGDT_OK) << p.message;
        most = std::max(most, p.own_points);
        sum += p.own_points;
    }
    EXPECT_EQ(sum, n);
    EXPECT_LE(most, n / parts + n / parts / 50 + 1);
}

// One fails, from its first allocation on, and all say so with its words; none waits for it.
TEST(Parts, FailTogether) {
    const Points xyz = uniform(2000);
    int failures = 0, successes = 0;
    for (std::size_t memory = 0; memory < std::size_t{1} << 23;
         memory += memory / (is_small() ? 2 : 30) + 16) {
        const std::vector<OfProcess> all = in_processes(xyz, 3, false, {1, memory});
        for (const OfProcess& p : all) EXPECT_EQ(p.status, all[0].status) << memory;
        for (const OfProcess& p : all) EXPECT_EQ(p.message, all[0].message) << memory;
        ++(all[0].status == MGDT_OK ? successes : failures);
        if (all[0].status == MGDT_OK) continue;
        EXPECT_EQ(all[0].status, MGDT_ERR_OUT_OF_MEMORY);
        EXPECT_EQ(all[0].message, "part 1: out of memory");
    }
    EXPECT_GT(failures, 1);
    EXPECT_GT(successes, 1);
}

// A transport that fails at its n-th call is not called again.
TEST(Parts, StopWhereTheTransportFails) {
    class Failing final : public Transport {
      public:
        explicit Failing(int calls) : left_(calls), inner_(2) {}
        PartId parts() const noexcept override { return 2; }
        PartId first_local() const noexcept override { return 0; }
        PartId local_parts() const noexcept override { return 2; }
        bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept override {
            return goes_on() && inner_.gather(mine, begin, all);
        }
        bool sum(std::uint64_t*, std::size_t) noexcept override { return goes_on(); }
        bool least(double*, std::size_t) noexcept override { return goes_on(); }
        bool exchange_counts(const Mail* out, Mail* in) noexcept override {
            return goes_on() && inner_.exchange_counts(out, in);
        }
        bool exchange_records(std::size_t size, const Mail* out, Mail* in) noexcept override {
            return goes_on() && inner_.exchange_records(size, out, in);
        }
        int left() const { return left_; }

      private:
        bool goes_on() {
            EXPECT_GE(left_, 0);
            return --left_ >= 0;
        }
        int left_;
        InProcess inner_;
    };
    const Points xyz = uniform(200);
    const Dealt dealt(xyz, 2, false);
    for (int calls = 0;; ++calls) {
        Failing transport(calls);
        Collective collective(transport);
        try {
            collective.run([&] {
                Parts all(collective, nullptr, nullptr, nullptr);
                StopFlag cancelled;
                StageProgress progress(CallSettings(), cancelled);
                all.build(dealt.given.data(), nullptr, progress);
            });
            EXPECT_GT(calls, 20);
            break;
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_TRANSPORT);
            EXPECT_EQ(transport.left(), -1);
        }
    }
}

}  // namespace
}  // namespace mgdt
