// SPDX-License-Identifier: MIT
// Triangulations to be damaged: sets of points of several kinds, and meshes put together from any
// tetrahedra, with ghosts, neighbours, spheres and counts as the library would have them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "core/triangulation.hpp"
#include "kernel/circumsphere.hpp"
#include "platform/error.hpp"
#include "query/check.hpp"
#include "unwatched.hpp"

namespace mgdt::surgery {

using Random = std::mt19937_64;
using mgdt_tests::lattice;
using mgdt_tests::Points;
using Quad = std::array<VertexId, 4>;

inline double uniform(Random& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

inline std::size_t below(Random& random, std::size_t n) {
    return static_cast<std::size_t>(random() % n);
}

inline Points uniform_points(std::size_t n, Random& random) {
    Points xyz(3 * n);
    for (double& x : xyz) x = uniform(random);
    return xyz;
}

struct Patient {
    std::unique_ptr<Triangulation> t;
    CheckInput input;  // may be falsified, and the mesh too

    explicit Patient(std::unique_ptr<Triangulation> made)
        : t(std::move(made)), input(t->check_input()) {}
    Mesh& mesh() { return const_cast<Mesh&>(t->mesh()); }
    Buffer<VertexId>& map() { return const_cast<Buffer<VertexId>&>(t->point_map()); }

    // What the check says; empty if nothing.
    std::string complaint(int level, unsigned threads = 1) const {
        Team team(threads);
        try {
            check_triangulation(team, input, t->allocator(), level, 0, Unwatched());
            return {};
        } catch (const Error& error) {
            EXPECT_EQ(error.status, MGDT_ERR_CHECK_FAILED);
            EXPECT_LT(std::string(error.message).size(), std::size_t{255}) << error.message;
            return error.message;
        }
    }
    TetId any_live(Random& random) {
        for (;;) {
            const TetId t0 = static_cast<TetId>(below(random, mesh().tetrahedra.size()));
            if (!mesh().tetrahedra[t0].is_dead()) return t0;
        }
    }
    TetId any(Random& random, bool ghost) {
        for (;;) {
            const TetId t0 = any_live(random);
            if (mesh().tetrahedra[t0].is_ghost() == ghost) return t0;
        }
    }
    VertexId any_vertex(Random& random) {
        return static_cast<VertexId>(1 + below(random, mesh().vertices.size() - 1));
    }
    std::vector<Quad> finite() {
        std::vector<Quad> quads;
        for_each_live([&](TetId id) {
            const Tetrahedron& t0 = mesh().tetrahedra[id];
            if (!t0.is_ghost()) quads.push_back({t0.v[0], t0.v[1], t0.v[2], t0.v[3]});
        });
        return quads;
    }
    template <class F>
    void for_each_live(F f) {
        for (TetId t0 = 0; t0 < mesh().tetrahedra.size(); ++t0)
            if (!mesh().tetrahedra[t0].is_dead()) f(t0);
    }
    // The vertices of ghosts, infinity among them.
    std::set<VertexId> hull() {
        std::set<VertexId> all;
        for_each_live([&](TetId t0) {
            const Tetrahedron& t = mesh().tetrahedra[t0];
            if (t.is_ghost()) all.insert(t.v, t.v + 4);
        });
        return all;
    }
    Sphere sphere(TetId t0) { return mesh().tetrahedra.sphere(t0).in_doubles(); }
    // And keeps it with the bound as it is.
    template <class Change>
    void change_sphere(TetId t0, Change change) {
        Sphere s = sphere(t0);
        change(s);
        KeptSphere& kept = mesh().tetrahedra.sphere(t0);
        for (int i = 0; i < 3; ++i) kept.w[i] = upper_half(to_upper_half(s.w[i]));
        kept.e = upper_half(s.e);
    }
    // As it is before it is rounded.
    Sphere exact_sphere(TetId t0) {
        return circumsphere(mesh().tetrahedra[t0], mesh().vertices.data());
    }
    void set_sphere(TetId t0) { mesh().tetrahedra.sphere(t0) = rounded(exact_sphere(t0)); }
    void set_spheres() {
        for_each_live([&](TetId t0) { set_sphere(t0); });
    }
    // As if the vertices had been given where they are.
    void set_exponents() {
        input.exponents = ExponentRange();
        for (VertexId v = 1; v < mesh().vertices.size(); ++v)
            for (const double x : mesh().vertices[v].x)
                input.exponents.add(scaled(x, -mesh().scale));
    }
    void assemble(std::vector<Quad> quads);
};

inline void insert(Triangulation& t, const Points& xyz) {
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
}

inline Patient triangulate(const Points& xyz) {
    auto t = std::make_unique<Triangulation>(nullptr, nullptr, nullptr);
    insert(*t, xyz);
    return Patient(std::move(t));
}

// The two newest vertices first, turned so that the orientation stays.
inline Quad ordered(Quad q) {
    bool odd = false;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 3; j > i; --j)
            if (q[j] > q[j - 1]) {
                std::swap(q[j], q[j - 1]);
                odd = !odd;
            }
    if (odd) std::swap(q[2], q[3]);
    return q;
}

// Replaces all tetrahedra by these. Facets that only one has get ghosts; of several that might be
// neighbours the first two are.
inline void Patient::assemble(std::vector<Quad> quads) {
    using Key = std::pair<std::array<VertexId, 3>, bool>;  // vertices, and which way it turns
    const auto key = [](const Quad& q, unsigned f) {
        std::array<VertexId, 3> v;
        for (unsigned i = 0; i < 3; ++i) v[i] = q[outer_face[f][i]];
        bool odd = false;
        for (const auto& [i, j] : {std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 1u)})
            if (v[i] > v[j]) {
                std::swap(v[i], v[j]);
                odd = !odd;
            }
        return Key(v, odd);
    };
    std::map<Key, std::vector<FacetCode>> open;
    std::vector<std::array<FacetCode, 4>> neighbors;
    const auto join = [&](std::size_t from) {
        neighbors.resize(quads.size(), {no_index, no_index, no_index, no_index});
        for (std::size_t t0 = from; t0 < quads.size(); ++t0)
            for (unsigned f = 0; f < 4; ++f) {
                const FacetCode code = static_cast<FacetCode>(4 * t0 + f);
                const Key mine = key(quads[t0], f);
                std::vector<FacetCode>& others = open[{mine.first, !mine.second}];
                if (others.empty()) {
                    open[mine].push_back(code);
                } else {
                    neighbors[t0][f] = others.back();
                    neighbors[others.back() >> 2][others.back() & 3] = code;
                    others.pop_back();
                }
            }
    };
    for (Quad& q : quads) q = ordered(q);
    join(0);
    const std::size_t finite_count = quads.size();
    for (std::size_t t0 = 0; t0 < finite_count; ++t0)
        for (unsigned f = 0; f < 4; ++f)
            if (neighbors[t0][f] == no_index) {
                const unsigned char* face = outer_face[f];
                quads.push_back(ordered(
                    {infinite_vertex, quads[t0][face[0]], quads[t0][face[1]], quads[t0][face[2]]}));
            }
    join(finite_count);

    Mesh& m = mesh();
    m.tetrahedra.resize(quads.size());
    m.free_slots.clear();
    m.prefaulted_slots = m.tetrahedra.size();
    m.ghost_count = quads.size() - finite_count;
    m.a_ghost = static_cast<TetId>(quads.size() - 1);
    for (std::size_t t0 = 0; t0 < quads.size(); ++t0) {
        Tetrahedron& to = m.tetrahedra[t0];
        std::copy(quads[t0].begin(), quads[t0].end(), to.v);
        std::copy(neighbors[t0].begin(), neighbors[t0].end(), to.n);
        set_sphere(static_cast<TetId>(t0));
    }
    for (VertexId v = 1; v < m.vertices.size(); ++v) m.vertex_hint[v] = 0;
    input.last = 0;
}

// Sound triangulations of every kind.
struct Family {
    const char* name;
    Patient (*make)(Random&);
};

inline const std::vector<Family>& families() {
    static const std::vector<Family> all = {
        {"one tetrahedron",
         [](Random&) {
             return triangulate({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
         }},
        {"uniform", [](Random& r) { return triangulate(uniform_points(60, r)); }},
        {"lattice", [](Random&) { return triangulate(lattice(4)); }},
        {"lattice with repeats",
         [](Random& r) {
             Points xyz = lattice(3);
             for (int i = 0; i < 20; ++i) xyz.push_back(static_cast<double>(below(r, 3)));
             xyz.resize(xyz.size() / 3 * 3);
             return triangulate(xyz);
         }},
        {"flat",
         [](Random& r) {
             Points xyz = uniform_points(60, r);
             for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] *= 1e-9;
             return triangulate(xyz);
         }},
        {"free slots",
         [](Random& r) {
             // Two skew lines make n^2 tetrahedra; a point between them leaves fewer.
             Points xyz;
             for (int i = 0; i < 8; ++i) {
                 xyz.insert(xyz.end(), {i / 8.0, 0, 0});
                 xyz.insert(xyz.end(), {0.4, i / 8.0 - 0.4, 1});
             }
             auto t = std::make_unique<Triangulation>(nullptr, nullptr, nullptr);
             insert(*t, xyz);
             insert(*t, {0.4 + 0.01 * uniform(r), 0.01 * uniform(r), 0.5});
             Patient p(std::move(t));
             EXPECT_GT(p.mesh().free_slots.size(), 0u);
             return p;
         }},
        {"scaled",
         [](Random& r) {
             Points xyz = uniform_points(40, r);
             for (double& x : xyz) x = std::ldexp(x, -300);
             Patient p = triangulate(xyz);
             EXPECT_NE(p.mesh().scale, 0);
             return p;
         }},
        {"subnormal",
         [](Random& r) {
             Points xyz = lattice(3);
             for (double& x : xyz) x = std::ldexp(x + static_cast<double>(below(r, 2)), -1074);
             return triangulate(xyz);
         }},
        {"extreme",
         [](Random& r) {
             Points xyz = uniform_points(40, r);
             for (std::size_t i = 0; i < 9; ++i) xyz[i] = std::ldexp(xyz[i], -200);
             Patient p = triangulate(xyz);
             EXPECT_TRUE(p.mesh().has_extremes);
             return p;
         }},
        {"by threads",
         [](Random& r) {
             auto t = std::make_unique<Triangulation>(nullptr, nullptr, nullptr);
             t->settings().threads = 3;
             t->hooks().min_points_per_thread = 40;
             insert(*t, uniform_points(is_small() ? 120 : 400, r));
             return Patient(std::move(t));
         }},
        {"with a tree",
         [](Random& r) {
             Patient p = triangulate(uniform_points(LocationTree::smallest + 100, r));
             EXPECT_NE(p.t->location_tree(), nullptr);
             p.input.tree = p.t->location_tree();
             return p;
         }},
    };
    return all;
}

}  // namespace mgdt::surgery
