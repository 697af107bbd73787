// SPDX-License-Identifier: MIT
#include "hole/vertex_removal.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"

namespace mgdt {

VertexRemoval::VertexRemoval(Allocator& allocator) noexcept
    : star_(allocator),
      link_(allocator),
      numbers_(allocator),
      boundary_(allocator),
      filling_(allocator),
      slots_(allocator),
      kept_(allocator) {}

void VertexRemoval::find(Mesh& mesh, VertexId v, TetId t) {
    vertex_ = v;
    find_star(mesh, v, t);
    number_link(mesh, v);
}

void VertexRemoval::fill(const Kernel& kernel, Mesh& mesh) {
    begin_filling();
    filling_.fill(kernel, mesh);
    make_room(mesh);
}

void VertexRemoval::fill_from(const Mesh& triangulated_link, Mesh& mesh) {
    begin_filling();
    filling_.fill_from(triangulated_link, mesh);
    make_room(mesh);
}

void VertexRemoval::begin_filling() {
    filling_.begin(link_, infinite_);
    for (const BoundaryFacet& f : boundary_) filling_.add_boundary(f.v, f.behind);
}

// Makes sure that replace() and undo() need no memory.
void VertexRemoval::make_room(Mesh& mesh) {
    const std::size_t removed = star_.size(), created = filling_.elements().size();
    const std::size_t stays = mesh.finite_count() - (removed - ghosts_gone_);
    leaves_space_ = stays + (created - filling_.ghosts()) > 0;
    slots_.clear();
    slots_.resize(std::max(removed, created) + 16);
    const std::size_t more = created > removed ? created - removed : 0;
    // Undoing the removal frees the slots that it takes, so the free list must have room for them.
    mesh.reserve_slots(more, removed > created ? removed - created : more);
}

// Gathers the star of v. The tetrahedra of the star are marked meanwhile.
void VertexRemoval::find_star(Mesh& mesh, VertexId v, TetId first) {
    star_.clear();
    ghosts_gone_ = 0;
    const auto take_marks_off = [&] {
        for (const TetId t : star_) mesh.tetrahedra[t].v[1] = unmarked(mesh.tetrahedra[t].v[1]);
    };
    const auto enter = [&](TetId t) {
        Tetrahedron& record = mesh.tetrahedra[t];
        if (record.is_in_cavity()) return;
        star_.push_back(t);
        record.v[1] |= in_cavity;
        // The neighbours are needed soon, in the star or beyond its boundary.
        for (const FacetCode n : record.n) mesh.tetrahedra.prefetch(tetrahedron_of(n));
        ghosts_gone_ += record.is_ghost();
    };
    try {
        enter(first);
        for (std::size_t i = 0; i < star_.size(); ++i) {
            const Tetrahedron t = mesh.tetrahedra[star_[i]];
            for (unsigned face = 0; face < 4; ++face)
                if (unmarked(t.v[face]) != v) enter(tetrahedron_of(t.n[face]));
        }
    } catch (...) {
        take_marks_off();
        throw;
    }
    take_marks_off();
}

// Numbers the vertices of the link, and finds the boundary of the star.
void VertexRemoval::number_link(const Mesh& mesh, VertexId v) {
    link_.clear();
    boundary_.clear();
    // By Euler's formula, a link of F facets has F / 2 + 2 vertices.
    const std::size_t most = star_.size() / 2 + 2;
    link_.reserve(most);
    boundary_.reserve(star_.size());
    numbers_.clear(2 * most);
    infinite_ = no_index;
    for (const TetId t : star_) {
        const Tetrahedron& record = mesh.tetrahedra[t];
        const auto face = static_cast<unsigned>(std::find(record.v, record.v + 3, v) - record.v);
        // Seen from inside, the vertices are in reverse order.
        const unsigned char* const corner = outer_face[face];
        const VertexId facet[3] = {record.v[corner[0]], record.v[corner[2]], record.v[corner[1]]};
        BoundaryFacet f;
        for (int k = 0; k < 3; ++k) {
            const VertexId u = facet[k];
            f.v[k] = numbers_.number(u, [](Filling::Number) { return true; });
            if (f.v[k] < link_.size()) continue;
            if (u == infinite_vertex) infinite_ = f.v[k];
            link_.push_back(u);
            prefetch(mesh.point(u));
        }
        f.behind = record.n[face];
        boundary_.push_back(f);
    }
}

TetId VertexRemoval::replace(Mesh& mesh) noexcept {
    const std::size_t removed = star_.size(), created = filling_.elements().size();
    for (std::size_t i = 0; i < std::min(removed, created); ++i) slots_[i] = first_facet(star_[i]);
    for (std::size_t i = created; i < removed; ++i) mesh.free_slot(star_[i]);
    if (created > removed) mesh.take_slots(slots_.data() + removed, created - removed);

    const bool has_spheres = mesh.tetrahedra.has_spheres();
    for (std::size_t i = 0; i < created; ++i) {
        const Filling::Element& t = filling_.elements()[i];
        const TetId id = tetrahedron_of(slots_[i]);
        Tetrahedron& record = mesh.tetrahedra[id];
        for (unsigned face = 0; face < 4; ++face) {
            const VertexId v = link_[t.v[face]];
            FacetCode n = t.n[face];
            if (t.is_outside[face])
                mesh.tetrahedra[tetrahedron_of(n)].n[face_of(n)] = facet_code(id, face);
            else
                n = facet_code(tetrahedron_of(slots_[tetrahedron_of(n)]), face_of(n));
            record.v[face] = v;
            record.n[face] = n;
            if (v != infinite_vertex) mesh.vertex_hint[v] = id;
        }
        if (has_spheres) mesh.tetrahedra.sphere(id) = rounded(t.sphere);
        if (record.is_ghost()) mesh.a_ghost = id;
    }
    mesh.ghost_count = mesh.ghost_count + filling_.ghosts() - ghosts_gone_;
    return tetrahedron_of(slots_[0]);
}

void VertexRemoval::keep_star(const Mesh& mesh) {
    kept_.clear();
    kept_.reserve(star_.size());
    for (const TetId t : star_) kept_.push_back(mesh.tetrahedra[t]);
    a_ghost_ = mesh.a_ghost;
}

TetId VertexRemoval::undo(Mesh& mesh) noexcept {
    const std::size_t removed = star_.size(), created = filling_.elements().size();
    for (std::size_t i = removed; i < created; ++i) mesh.free_slot(tetrahedron_of(slots_[i]));
    if (removed > created)
        mesh.free_slots.resize_within_capacity(mesh.free_slots.size() - (removed - created));
    for (std::size_t i = 0; i < removed; ++i) {
        const TetId id = star_[i];
        Tetrahedron& record = mesh.tetrahedra[id];
        record = kept_[i];
        for (unsigned face = 0; face < 4; ++face) {
            const FacetCode n = record.n[face];
            if (record.v[face] == vertex_)
                mesh.tetrahedra[tetrahedron_of(n)].n[face_of(n)] = facet_code(id, face);
            if (record.v[face] != infinite_vertex) mesh.vertex_hint[record.v[face]] = id;
        }
        if (mesh.tetrahedra.has_spheres())
            mesh.tetrahedra.sphere(id) = rounded(circumsphere(record, mesh.vertices.data()));
    }
    mesh.ghost_count = mesh.ghost_count + ghosts_gone_ - filling_.ghosts();
    mesh.a_ghost = a_ghost_;
    return star_[0];
}

void VertexRemoval::reset() noexcept {
    kept_.reset();
    star_.reset();
    link_.reset();
    numbers_.reset();
    boundary_.reset();
    filling_.reset();
    slots_.reset();
}

}  // namespace mgdt
