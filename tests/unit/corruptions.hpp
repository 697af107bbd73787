// SPDX-License-Identifier: MIT
// Ways to spoil a sound triangulation: every field of every record, at random places, and what the
// check must say of it.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "surgery.hpp"

namespace mgdt::surgery {

struct Corruption {
    const char* name;
    int level;              // the least that must find it
    const char* complaint;  // what it must say, among others
    // False where there is nothing of the kind to spoil.
    std::function<bool(Patient&, Random&)> act;
};

inline std::uint32_t other_than(std::uint32_t value, Random& random) {
    std::uint32_t v;
    do {
        v = static_cast<std::uint32_t>(random());
    } while (v == value);
    return v;
}

// A value of any magnitude, or none.
inline double any_double(Random& random) {
    switch (below(random, 4)) {
        case 0:
            return std::numeric_limits<double>::quiet_NaN();
        case 1:
            return std::numeric_limits<double>::infinity();
        default:
            return std::ldexp(uniform(random) - 0.5, static_cast<int>(below(random, 2000)) - 1000);
    }
}

// A tetrahedron whose sphere or normal decides something.
inline bool pick_trusted(Patient& p, Random& random, bool ghost, TetId& found) {
    for (int tries = 0; tries < 100; ++tries) {
        found = p.any(random, ghost);
        if (std::isfinite(p.sphere(found).e)) return true;
    }
    return false;
}

// Live slots other than one's neighbours.
inline bool pick_stranger(Patient& p, Random& random, TetId t, TetId& found) {
    for (int tries = 0; tries < 100; ++tries) {
        found = p.any_live(random);
        const FacetCode* n = p.mesh().tetrahedra[t].n;
        if (found != t && std::none_of(n, n + 4, [&](FacetCode c) { return c >> 2 == found; }))
            return true;
    }
    return false;
}

inline const std::vector<Corruption>& corruptions() {
    static const std::vector<Corruption> all = {
        // Vertices of tetrahedra.
        {"any vertex number", 1, "",
         [](Patient& p, Random& r) {
             VertexId& v = p.mesh().tetrahedra[p.any_live(r)].v[below(r, 4)];
             v = other_than(v, r);
             return true;
         }},
        {"another vertex", 1, "",
         [](Patient& p, Random& r) {
             VertexId& v = p.mesh().tetrahedra[p.any_live(r)].v[below(r, 4)];
             const VertexId w = static_cast<VertexId>(below(r, p.mesh().vertices.size()));
             return std::exchange(v, w) != w;
         }},
        {"vertices swapped", 1, "facet",
         [](Patient& p, Random& r) {
             const std::size_t i = below(r, 4), j = (i + 1 + below(r, 3)) % 4;
             Tetrahedron& t = p.mesh().tetrahedra[p.any_live(r)];
             // An infinite base would be a dead record.
             if (t.v[i] == infinite_vertex || t.v[j] == infinite_vertex) return false;
             std::swap(t.v[i], t.v[j]);
             return true;
         }},
        {"a vertex twice", 1, "vertex is there twice",
         [](Patient& p, Random& r) {
             Tetrahedron& t = p.mesh().tetrahedra[p.any(r, false)];
             const std::size_t i = below(r, 4);
             t.v[i] = t.v[(i + 1) % 4];
             return true;
         }},
        {"a mark left from digging", 1, "vertex does not exist",
         [](Patient& p, Random& r) {
             p.mesh().tetrahedra[p.any_live(r)].v[1] |= in_cavity;
             return true;
         }},
        {"a ghost without infinity", 1, "of them ghosts",
         [](Patient& p, Random& r) {
             if (p.mesh().vertices.size() < 6) return false;
             Tetrahedron& t = p.mesh().tetrahedra[p.any(r, true)];
             VertexId v = 1;
             while (std::find(t.v, t.v + 4, v) != t.v + 4) ++v;
             t.v[t.infinite_slot()] = v;
             return true;
         }},
        // Neighbours.
        {"any facet code", 1, "neighbour",
         [](Patient& p, Random& r) {
             FacetCode& n = p.mesh().tetrahedra[p.any_live(r)].n[below(r, 4)];
             n = other_than(n, r);
             return true;
         }},
        {"another facet of the neighbour", 1, "does not return the adjacency",
         [](Patient& p, Random& r) {
             p.mesh().tetrahedra[p.any_live(r)].n[below(r, 4)] ^=
                 1 + static_cast<FacetCode>(below(r, 3));
             return true;
         }},
        {"neighbours swapped", 1, "does not return the adjacency",
         [](Patient& p, Random& r) {
             const std::size_t i = below(r, 4), j = (i + 1 + below(r, 3)) % 4;
             Tetrahedron& t = p.mesh().tetrahedra[p.any_live(r)];
             std::swap(t.n[i], t.n[j]);
             return true;
         }},
        {"neighbours swapped, both told", 1, "facet",
         [](Patient& p, Random& r) {
             const unsigned i = static_cast<unsigned>(below(r, 4)),
                            j = (i + 1 + static_cast<unsigned>(below(r, 3))) % 4;
             const TetId id = p.any_live(r);
             Tetrahedron& t = p.mesh().tetrahedra[id];
             std::swap(t.n[i], t.n[j]);
             for (const unsigned f : {i, j})
                 p.mesh().tetrahedra[t.n[f] >> 2].n[t.n[f] & 3] = 4 * id + f;
             return true;
         }},
        {"two pairs of neighbours exchanged, all told", 1, "facet",
         [](Patient& p, Random& r) {
             const TetId a = p.any_live(r);
             TetId b;
             if (!pick_stranger(p, r, a, b)) return false;
             const unsigned f = static_cast<unsigned>(below(r, 4)),
                            g = static_cast<unsigned>(below(r, 4));
             std::swap(p.mesh().tetrahedra[a].n[f], p.mesh().tetrahedra[b].n[g]);
             for (const auto& [t, i] : {std::pair(a, f), std::pair(b, g)}) {
                 const FacetCode n = p.mesh().tetrahedra[t].n[i];
                 p.mesh().tetrahedra[n >> 2].n[n & 3] = 4 * t + i;
             }
             return true;
         }},
        {"another base, all told", 1, "newest",
         [](Patient& p, Random& r) {
             // Three vertices turned, and with them their neighbours: only their age is wrong.
             const TetId id = p.any(r, false);
             Tetrahedron& t = p.mesh().tetrahedra[id];
             std::rotate(t.v, t.v + 1, t.v + 3);
             std::rotate(t.n, t.n + 1, t.n + 3);
             for (unsigned f = 0; f < 4; ++f)
                 p.mesh().tetrahedra[t.n[f] >> 2].n[t.n[f] & 3] = 4 * id + f;
             p.set_sphere(id);
             return true;
         }},
        // Spheres, normals, bounds.
        {"sign of a finite bound", 1, "wrongly marked as ghost or finite",
         [](Patient& p, Random& r) {
             p.change_sphere(p.any(r, false), [](Sphere& s) { s.e = -s.e; });
             return true;
         }},
        {"sign of a ghost's bound", 1, "wrongly marked as ghost or finite",
         [](Patient& p, Random& r) {
             p.change_sphere(p.any(r, true), [](Sphere& s) { s.e = -s.e; });
             return true;
         }},
        {"signs of bounds exchanged", 1, "wrongly marked as ghost or finite",
         [](Patient& p, Random& r) {
             for (const bool ghost : {true, false})
                 p.change_sphere(p.any(r, ghost), [](Sphere& s) { s.e = -s.e; });
             return true;
         }},
        {"a sphere's coefficient anything", 2, "circumsphere is off",
         [](Patient& p, Random& r) {
             TetId t;
             if (!pick_trusted(p, r, false, t)) return false;
             const Sphere before = p.sphere(t);
             const std::size_t i = below(r, 3);
             p.change_sphere(t, [&](Sphere& s) { s.w[i] = any_double(r); });
             return !(std::fabs(p.sphere(t).w[i] - before.w[i]) <= 4 * before.e);
         }},
        {"a sphere's coefficient off by four times its bound", 2, "circumsphere is off",
         [](Patient& p, Random& r) {
             TetId id;
             if (!pick_trusted(p, r, false, id)) return false;
             p.change_sphere(id,
                             [&](Sphere& s) { s.w[below(r, 3)] += (below(r, 2) ? 4 : -4) * s.e; });
             return true;
         }},
        {"a normal's coefficient off by four times its bound", 2, "normal is off",
         [](Patient& p, Random& r) {
             TetId id;
             if (!pick_trusted(p, r, true, id)) return false;
             p.change_sphere(id,
                             [&](Sphere& s) { s.w[below(r, 3)] += (below(r, 2) ? 4 : -4) * s.e; });
             return true;
         }},
        {"a bound too small", 2, "circumsphere is off",
         [](Patient& p, Random& r) {
             TetId id;
             if (!pick_trusted(p, r, false, id)) return false;
             // That of a sphere which is not rounded is nearly used up.
             p.change_sphere(id, [&](Sphere& s) {
                 s.e = std::ldexp(p.exact_sphere(id).e, -3 - static_cast<int>(below(r, 60)));
             });
             return true;
         }},
        {"a normal's bound too small", 2, "normal is off",
         [](Patient& p, Random& r) {
             TetId id;
             if (!pick_trusted(p, r, true, id)) return false;
             p.change_sphere(id, [&](Sphere& s) {
                 s.e = std::ldexp(p.exact_sphere(id).e, -1 - static_cast<int>(below(r, 60)));
             });
             return true;
         }},
        {"no bound", 2, "is off by more than its bound",
         [](Patient& p, Random& r) {
             TetId id;
             const bool ghost = below(r, 2) == 0;
             if (!pick_trusted(p, r, ghost, id)) return false;
             p.change_sphere(id, [&](Sphere& s) { s.e = ghost ? -0.0 : 0.0; });
             return true;
         }},
        {"a bound that is no number", 2, "is off by more than its bound",
         [](Patient& p, Random& r) {
             TetId id;
             if (!pick_trusted(p, r, false, id)) return false;
             p.change_sphere(
                 id, [&](Sphere& s) { s.e = std::fabs(std::numeric_limits<double>::quiet_NaN()); });
             return true;
         }},
        {"extreme coordinates trusted", 2, "circumsphere is off",
         [](Patient& p, Random&) {
             bool found = false;
             p.for_each_live([&](TetId t) {
                 const double e = p.sphere(t).e;
                 if (found || std::signbit(e) || !std::isinf(e)) return;
                 p.change_sphere(t, [&](Sphere& s) { s.e = 1e-17; });
                 found = true;
             });
             return found;
         }},
        // Dead and free slots, counts.
        {"a tetrahedron dead", 1, "tetrahedra",
         [](Patient& p, Random& r) {
             p.mesh().tetrahedra[p.any_live(r)].kill();
             return true;
         }},
        {"a tetrahedron dead and free", 1, "",
         [](Patient& p, Random& r) {
             const TetId t = p.any(r, false);
             p.mesh().tetrahedra[t].kill();
             p.mesh().free_slots.push_back(t);
             return true;
         }},
        {"a dead one come to life", 1, "free",
         [](Patient& p, Random& r) {
             if (p.mesh().free_slots.empty()) return false;
             p.mesh().tetrahedra[p.mesh().free_slots[below(r, p.mesh().free_slots.size())]].v[0] =
                 1;
             return true;
         }},
        {"a free slot forgotten", 1, "tetrahedra",
         [](Patient& p, Random&) {
             if (p.mesh().free_slots.empty()) return false;
             p.mesh().free_slots.pop_back();
             return true;
         }},
        {"a free slot twice", 1, "free",
         [](Patient& p, Random&) {
             Buffer<TetId>& free = p.mesh().free_slots;
             if (free.size() < 2) return false;
             free[0] = free[1];
             return true;
         }},
        {"any free slot", 1, "free",
         [](Patient& p, Random& r) {
             Buffer<TetId>& free = p.mesh().free_slots;
             if (free.empty()) return false;
             TetId& t = free[below(r, free.size())];
             t = other_than(t, r);
             return true;
         }},
        {"a live slot free", 1, "slot",
         [](Patient& p, Random& r) {
             p.mesh().free_slots.push_back(p.any_live(r));
             return true;
         }},
        {"count of ghosts", 1, "ghosts",
         [](Patient& p, Random& r) {
             p.mesh().ghost_count += 1 + below(r, 1000);
             return true;
         }},
        {"room for more than there is", 1, "room",
         [](Patient& p, Random& r) {
             p.mesh().prefaulted_slots = p.mesh().tetrahedra.capacity() + 1 + below(r, 1000);
             return true;
         }},
        {"limit of slots", 1, "room",
         [](Patient& p, Random& r) {
             p.mesh().slot_limit = max_tetrahedra + 1 + static_cast<std::uint32_t>(below(r, 1000));
             return true;
         }},
        // Where walks start.
        {"a ghost that is none", 1, "ghost",
         [](Patient& p, Random& r) {
             p.mesh().a_ghost = p.any(r, false);
             return true;
         }},
        {"a ghost beyond the store", 1, "ghost",
         [](Patient& p, Random& r) {
             p.mesh().a_ghost = static_cast<TetId>(p.mesh().tetrahedra.size() + below(r, 1u << 31));
             return true;
         }},
        {"next walk from nowhere", 1, "walk",
         [](Patient& p, Random& r) {
             p.input.last = static_cast<TetId>(p.mesh().tetrahedra.size() + below(r, 1u << 31));
             return true;
         }},
        {"next walk from a dead one", 1, "walk",
         [](Patient& p, Random&) {
             if (p.mesh().free_slots.empty()) return false;
             p.input.last = p.mesh().free_slots[0];
             return true;
         }},
        {"slot near a vertex", 1, "near point",
         [](Patient& p, Random& r) {
             p.mesh().vertex_hint[p.any_vertex(r)] =
                 static_cast<TetId>(p.mesh().tetrahedra.size() + below(r, 1u << 31));
             return true;
         }},
        {"slots near vertices lost", 1, "near",
         [](Patient& p, Random&) {
             p.mesh().vertex_hint.pop_back();
             return true;
         }},
        // Points.
        {"a vertex's index", 1, "vertex",
         [](Patient& p, Random& r) {
             std::uint32_t& i = p.mesh().vertices[p.any_vertex(r)].index;
             i = other_than(i, r);
             return true;
         }},
        {"indices of two vertices swapped", 1, "vertex",
         [](Patient& p, Random& r) {
             const VertexId v = p.any_vertex(r), w = p.any_vertex(r);
             std::swap(p.mesh().vertices[v].index, p.mesh().vertices[w].index);
             return v != w;
         }},
        {"infinity with an index", 1, "vertex",
         [](Patient& p, Random&) {
             p.mesh().vertices[0].index = 0;
             return true;
         }},
        {"a point mapped nowhere", 1, "point",
         [](Patient& p, Random& r) {
             p.map()[below(r, p.map().size())] =
                 static_cast<VertexId>(p.mesh().vertices.size() + below(r, 1u << 31));
             return true;
         }},
        {"a vertex's point mapped to another", 1, "vertex",
         [](Patient& p, Random& r) {
             const VertexId v = p.any_vertex(r), w = p.any_vertex(r);
             p.map()[p.mesh().vertices[v].index] = w;
             return v != w;
         }},
        {"a vertex's point left out", 1, "vertex",
         [](Patient& p, Random& r) {
             p.map()[p.mesh().vertices[p.any_vertex(r)].index] = infinite_vertex;
             return true;
         }},
        {"a repeat left out", 1, "counted",
         [](Patient& p, Random&) {
             for (std::size_t i = 0; i < p.map().size(); ++i)
                 if (p.mesh().vertices[p.map()[i]].index != i) {
                     p.map()[i] = infinite_vertex;
                     return true;
                 }
             return false;
         }},
        {"points forgotten", 1, "",
         [](Patient& p, Random&) {
             p.map().pop_back();
             return true;
         }},
        {"count of points", 1, "counted",
         [](Patient& p, Random& r) {
             p.input.points_inserted += 1 + below(r, 1000);
             return true;
         }},
        {"count of repeats", 1, "counted",
         [](Patient& p, Random& r) {
             p.input.duplicates -= 1 + below(r, 1000);
             return true;
         }},
        {"a vertex in no tetrahedron", 1, "in no tetrahedron",
         [](Patient& p, Random&) {
             Mesh& m = p.mesh();
             const VertexId v = static_cast<VertexId>(m.vertices.size());
             m.vertices.push_back(
                 Vertex{{0.5, 0.5, 0.5}, static_cast<std::uint32_t>(p.map().size()), 0});
             m.vertex_hint.push_back(0);
             p.map().push_back(v);
             ++p.input.points_inserted;
             return true;
         }},
        {"dimension", 1, "dimension",
         [](Patient& p, Random& r) {
             p.input.dimension =
                 static_cast<int>(below(r, 3)) - 1 + 4 * static_cast<int>(below(r, 2));
             return p.input.dimension != 3;
         }},
        {"another's location tree", 1, "location tree",
         [](Patient& p, Random& r) {
             static const Patient larger = triangulate(uniform_points(1000, r));
             p.input.tree = larger.t->location_tree();
             return p.mesh().vertices.size() < 900;
         }},
        // Coordinates.
        {"a coordinate that is no number", 2, "not finite",
         [](Patient& p, Random& r) {
             p.mesh().vertices[p.any_vertex(r)].x[below(r, 3)] =
                 below(r, 2) ? std::numeric_limits<double>::quiet_NaN()
                             : -std::numeric_limits<double>::infinity();
             return true;
         }},
        {"a coordinate of another size", 2, "coordinates",
         [](Patient& p, Random& r) {
             p.mesh().vertices[p.any_vertex(r)].x[below(r, 3)] = 0x1p60;
             return true;
         }},
        {"extreme coordinates unnoticed", 2, "range",
         [](Patient& p, Random&) { return std::exchange(p.mesh().has_extremes, false); }},
        {"scale", 2, "coordinate",
         [](Patient& p, Random& r) {
             const int k = static_cast<int>(static_cast<std::uint32_t>(r()));
             return std::exchange(p.mesh().scale, k) != k;
         }},
        {"scale far off", 2, "coordinate",
         [](Patient& p, Random& r) {
             p.mesh().scale = below(r, 2) ? 2000 : -2000;
             return true;
         }},
        {"scale by one", 2, "coordinate",
         [](Patient& p, Random&) {
             ++p.mesh().scale;
             return true;
         }},
        {"two vertices at one place", 2, "",
         [](Patient& p, Random& r) {
             const VertexId v = p.any_vertex(r), w = p.any_vertex(r);
             std::copy_n(p.mesh().vertices[v].x, 3, p.mesh().vertices[w].x);
             p.set_spheres();
             return v != w;
         }},
        {"the mirror image", 2, "",
         [](Patient& p, Random&) {
             for (Vertex& v : p.mesh().vertices) v.x[0] = -v.x[0];
             p.set_spheres();
             return true;
         }},
    };
    return all;
}

}  // namespace mgdt::surgery
