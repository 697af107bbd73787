// SPDX-License-Identifier: MIT
#include "interpolation/place_star.hpp"

#include <algorithm>

#include "kernel/adjacency.hpp"
#include "kernel/local_numbers.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// Sorts the corners. Returns whether that takes an odd number of exchanges.
template <int n>
MGDT_ALWAYS_INLINE bool sort_corners(PlaceStar::Number (&corner)[n]) {
    bool is_odd = false;
    const auto order = [&](int i, int j) {
        const PlaceStar::Number a = corner[i], b = corner[j];
        const bool swaps = b < a;
        corner[i] = swaps ? b : a;
        corner[j] = swaps ? a : b;
        is_odd ^= swaps;
    };
    if constexpr (n == 2) {
        order(0, 1);
    } else if constexpr (n == 3) {
        order(0, 1), order(1, 2), order(0, 1);
    } else {
        order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    }
    return is_odd;
}

// The tetrahedra of a mesh, by the codes of their facets.
struct Tetrahedra {
    const Tetrahedron& of(FacetCode code) const { return mesh.tetrahedra[tetrahedron_of(code)]; }
    const Mesh& mesh;
};

template <class T>
MGDT_ALWAYS_INLINE T& add(Buffer<T>& to) {
    const std::size_t size = to.size();
    to.grow(size + 1);
    to.resize_within_capacity(size + 1);
    return to[size];
}

}  // namespace

PlaceStar::PlaceStar(Allocator& allocator)
    : workspace_(allocator),
      marks_(allocator),
      members_(allocator),
      vertices_(allocator),
      keys_(allocator),
      ranks_(allocator),
      cycles_(allocator),
      removed_(allocator),
      created_(allocator),
      old_facets_(allocator),
      new_facets_(allocator),
      removed_triangles_(allocator),
      created_triangles_(allocator),
      old_edges_(allocator),
      new_edges_(allocator),
      from_(allocator) {}

void PlaceStar::find(const Mesh& mesh, const KernelCalls& kernel, const double* q, TetId t) {
    Workspace& w = workspace_;
    kernel.find_cavity(mesh, w, marks_, q, t);
    if (w.cavity_size > w.star_removed || w.boundary_size > w.star_created)
        w.grow_star(w.cavity_size, w.boundary_size);
    {
        DirectNumbers numbers(w);
        if (numbers.add_cavity(w, Tetrahedra{mesh})) return build(mesh, numbers);
    }
    ProbedNumbers numbers(w);
    numbers.add_cavity(w, Tetrahedra{mesh});
    build(mesh, numbers);
}

// Numbers the vertices in the order of the caller's indices, with the vertex at infinity last.
void PlaceStar::number_vertices(const Mesh& mesh, std::size_t count) {
    const VertexId* const ids = workspace_.ids.data;
    keys_.clear();
    keys_.resize(count);
    std::uint64_t* const keys = keys_.data();
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint64_t index =
            ids[k] == infinite_vertex ? no_index : mesh.vertices[ids[k]].index;
        keys[k] = index << 32 | k;
    }
    constexpr std::size_t few = 32;
    if (count > few)
        std::sort(keys, keys + count);
    else
        for (std::size_t k = 1; k < count; ++k) {
            const std::uint64_t key = keys[k];
            std::size_t to = k;
            for (; to > 0 && keys[to - 1] > key; --to) keys[to] = keys[to - 1];
            keys[to] = key;
        }
    ranks_.clear();
    ranks_.resize(count);
    vertices_.clear();
    vertices_.resize(count);
    for (Number rank = 0; rank < count; ++rank) {
        const auto k = static_cast<std::uint32_t>(keys[rank]);
        ranks_[k] = rank;
        vertices_[rank] = ids[k];
    }
}

template <class Numbered>
void PlaceStar::build(const Mesh& mesh, const Numbered& numbers) {
    const Workspace& w = workspace_;
    number_vertices(mesh, numbers.count());
    const auto number = [lookup = numbers.lookup(), rank = ranks_.data()](VertexId v) {
        return rank[lookup(v)];
    };
    members_.clear();
    for (std::size_t m = 0; m < w.cavity_size; ++m)
        members_.number(tetrahedron_of(w.cavity.data[m]));
    removed_.clear();
    created_.clear();
    old_facets_.clear();
    new_facets_.clear();
    removed_triangles_.clear();
    created_triangles_.clear();
    old_edges_.clear();
    new_edges_.clear();
    is_on_hull_ = vertices_.back() == infinite_vertex;
    is_on_ridge_ = false;
    if (is_on_hull_) {
        vertices_.pop_back();
        build_on_hull(mesh, number);
    } else if (numbers.count() <= Workspace::medium_vertices) {
        build_in_space(mesh, number, EdgeMatrix<6>(workspace_.edge_codes.data));
    } else if (numbers.count() <= Workspace::matrix_vertices) {
        build_in_space(mesh, number, EdgeMatrix<8>(workspace_.edge_codes.data));
    } else {
        build_in_space(mesh, number, EdgeTable(workspace_));
    }
}

template <class Lookup, class Edges>
void PlaceStar::build_in_space(const Mesh& mesh, Lookup number, Edges edges) {
    const Workspace& w = workspace_;
    const auto members = static_cast<std::uint32_t>(w.cavity_size),
               facets = static_cast<std::uint32_t>(w.boundary_size);
    const auto member = members_.lookup();
    removed_.grow(members);
    removed_.resize_within_capacity(members);
    created_.grow(facets);
    created_.resize_within_capacity(facets);
    cycles_.grow(facets);
    cycles_.resize_within_capacity(facets);
    // Each facet of a removed tetrahedron is on the boundary or between two removed tetrahedra.
    // Each facet at the place is between two created tetrahedra. The loops below write one entry
    // more, which is discarded.
    old_facets_.grow(2 * members + facets + 1);
    new_facets_.grow(3 * facets / 2 + 1);
    Removed* const removed = removed_.data();
    Created* const created = created_.data();
    Cycle* const cycles = cycles_.data();
    Meeting<3>* old_facet = old_facets_.data();
    Meeting<2>* new_facet = new_facets_.data();
    for (std::uint32_t m = 0; m < members; ++m) {
        const Tetrahedron& t = mesh.tetrahedra[tetrahedron_of(w.cavity.data[m])];
        Number corner[4];
        for (unsigned i = 0; i < 4; ++i) corner[i] = number(t.v[i]);
        for (unsigned face = 0; face < 4; ++face) {
            const std::uint32_t other = member(tetrahedron_of(t.n[face]));
            // An entry is written for each face, but kept only if `other` is a member with a larger
            // number. So a facet between two members is kept once, and the loop has no branch.
            Meeting<3>& f = *old_facet;
            old_facet += static_cast<int>(other + 1 > m + 1);
            f.near = m;
            f.beyond = other;
            for (unsigned k = 0; k < 3; ++k) f.corner[k] = corner[outer_face[face][k]];
            f.is_odd = sort_corners(f.corner);
        }
        Removed& r = removed[m];
        std::copy(corner, corner + 4, r.corner);
        r.is_odd = sort_corners(r.corner);
    }
    for (std::uint32_t i = 0; i < facets; ++i) {
        const FacetCode outside = w.boundary.data[i];
        const Tetrahedron& t = mesh.tetrahedra[tetrahedron_of(outside)];
        const FacetCode inside = t.n[face_of(outside)];
        Created& c = created[i];
        // The corners in the order that is positively oriented together with the place.
        Number* const cycle = cycles[i].corner;
        for (unsigned k = 0; k < 3; ++k)
            cycle[k] = c.corner[k] = number(t.v[outer_face[face_of(outside)][k]]);
        edges.put(cycle[0], cycle[1], i);
        edges.put(cycle[1], cycle[2], i);
        edges.put(cycle[2], cycle[0], i);
        c.is_odd = sort_corners(c.corner);
        Meeting<3>& f = *old_facet++;
        f.near = members + i;
        f.beyond = member(tetrahedron_of(inside));
        std::copy(c.corner, c.corner + 3, f.corner);
        f.is_odd = c.is_odd;
    }
    for (std::uint32_t i = 0; i < facets; ++i) {
        const Number* const cycle = cycles[i].corner;
        for (unsigned k = 0; k < 3; ++k) {
            const Number a = cycle[k], b = cycle[k == 2 ? 0 : k + 1];
            // Each edge between two boundary facets is kept once, in the direction with a < b.
            *new_facet = {members + i, members + edges.get(b, a), {a, b}, false};
            new_facet += static_cast<int>(a < b);
        }
    }
    old_facets_.resize_within_capacity(static_cast<std::size_t>(old_facet - old_facets_.data()));
    new_facets_.resize_within_capacity(static_cast<std::size_t>(new_facet - new_facets_.data()));
}

template <class Lookup>
void PlaceStar::build_on_hull(const Mesh& mesh, Lookup number) {
    const Workspace& w = workspace_;
    const MarkTable::View marks = marks_.view();
    members_.clear();
    for (std::size_t m = 0; m < w.cavity_size; ++m) {
        const TetId id = tetrahedron_of(w.cavity.data[m]);
        if (mesh.tetrahedra[id].is_ghost()) members_.number(id);
    }
    const std::uint32_t members = members_.size();
    from_.clear();
    from_.resize(vertices_.size(), no_index);
    const VertexId* plane = nullptr;
    const unsigned char* of_plane = nullptr;
    for (std::uint32_t m = 0; m < members; ++m) {
        const Tetrahedron& t = mesh.tetrahedra[members_.name(m)];
        const unsigned char* const facet = outer_face[t.infinite_slot()];
        if (!plane) {
            plane = t.v;
            of_plane = facet;
        }
        Simplex<3>& r = add(removed_triangles_);
        for (unsigned k = 0; k < 3; ++k) {
            r.corner[k] = number(t.v[facet[k]]);
            if (orientation(mesh.point(plane[of_plane[0]]), mesh.point(plane[of_plane[1]]),
                            mesh.point(plane[of_plane[2]]), mesh.point(t.v[facet[k]])) != 0) {
                is_on_ridge_ = true;
                return;
            }
        }
        r.is_odd = sort_corners(r.corner);
        for (unsigned k = 0; k < 3; ++k) {
            const TetId beyond = tetrahedron_of(t.n[facet[k]]);
            const Number from = number(t.v[facet[(k + 1) % 3]]),
                         to = number(t.v[facet[(k + 2) % 3]]);
            Meeting<2>* e = nullptr;
            if (!marks.has(beyond)) {
                from_[from] = static_cast<std::uint32_t>(created_triangles_.size());
                Simplex<2>& c = add(created_triangles_);
                c = {{from, to}, false};
                c.is_odd = sort_corners(c.corner);
                e = &add(old_edges_);
                *e = {m, members + from_[from], {from, to}, false};
            } else {
                const std::uint32_t other = members_.number(beyond);
                if (other < m) continue;
                e = &add(old_edges_);
                *e = {m, other, {from, to}, false};
            }
            e->is_odd = sort_corners(e->corner);
        }
    }
    // A created triangle has two corners besides the place; the next triangle begins at the second
    // one.
    for (std::uint32_t i = 0; i < created_triangles_.size(); ++i) {
        const Simplex<2>& c = created_triangles_[i];
        const Number to = c.is_odd ? c.corner[0] : c.corner[1];
        new_edges_.push_back({members + i, members + from_[to], {to}});
    }
}

}  // namespace mgdt
