// SPDX-License-Identifier: MIT
#include "hole/vertex_removal.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The vertices of a facet, as a key that does not depend on their order.
struct FacetKey {
    explicit FacetKey(const std::uint32_t (&v)[3])
        : least(std::min({v[0], v[1], v[2]})),
          most(std::max({v[0], v[1], v[2]})),
          middle(v[0] ^ v[1] ^ v[2] ^ least ^ most) {}
    std::uint32_t hash() const noexcept {
        const std::uint64_t key = (std::uint64_t{least} * 0x10001u + middle) * 0x1000003u + most;
        return static_cast<std::uint32_t>(key * 0x9E3779B97F4A7C15u >> 32);
    }
    bool operator==(const FacetKey& other) const noexcept {
        return ((least ^ other.least) | (middle ^ other.middle) | (most ^ other.most)) == 0;
    }
    std::uint32_t least, most, middle;
};

}  // namespace

VertexRemoval::VertexRemoval(Allocator& allocator) noexcept
    : star_(allocator),
      link_(allocator),
      columns_(allocator),
      numbers_(allocator),
      facets_(allocator),
      numbers_of_facets_(allocator),
      filling_(allocator),
      slots_(allocator),
      kept_(allocator) {}

void VertexRemoval::find(Mesh& mesh, VertexId v, TetId t) {
    vertex_ = v;
    find_star(mesh, v, t);
    number_link(mesh, v);
}

void VertexRemoval::fill(const Kernel& kernel, Mesh& mesh) {
    begin_filling(mesh);
    const LinkColumns columns = columns_of_link(mesh);
    // Starting at finite facets suffices: each ghost is reached through one.
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        const Facet& f = facets_[i];
        if (f.is_closed || f.v[0] == infinite_ || f.v[1] == infinite_ || f.v[2] == infinite_)
            continue;
        ApexResult apex = {no_apex, {}};
        if (!mesh.has_extremes) apex = kernel.find_apex(columns, f.v);
        close(mesh, i, apex.number == no_apex ? apex_of(mesh, f) : apex);
    }
    end_filling(mesh);
}

void VertexRemoval::begin_filling(const Mesh& mesh) {
    facets_.clear();
    filling_.clear();
    numbers_of_facets_.clear(4 * star_.size());
    ghosts_made_ = 0;
    add_boundary(mesh);
}

void VertexRemoval::end_filling(Mesh& mesh) {
    for (const Facet& f : facets_)
        if (!f.is_closed) fail(MGDT_ERR_INTERNAL, "a hole is not filled; please report it");

    const std::size_t stays = mesh.finite_count() - (star_.size() - ghosts_gone_);
    leaves_space_ = stays + (filling_.size() - ghosts_made_) > 0;
    const std::size_t removed = star_.size(), created = filling_.size();
    slots_.clear();
    slots_.resize(std::max(removed, created) + 16);
    const std::size_t more = created > removed ? created - removed : 0;
    // Undoing the removal frees the slots that it takes, so the free list must have room for them.
    mesh.reserve_slots(more, removed > created ? removed - created : more);
}

// Adds the tetrahedra of the link's triangulation that are inside the hole: the tetrahedra at the
// inner side of the boundary, and all that are reached from these without crossing the boundary.
void VertexRemoval::fill_from(const Mesh& triangulated_link, Mesh& mesh) {
    begin_filling(mesh);
    const Mesh& link = triangulated_link;
    const Buffer<FacetCode> outside = boundary_in(link);
    Buffer<TetId> inside(star_.allocator());
    Buffer<std::uint32_t> number(star_.allocator());
    inside.reserve(link.live_count());
    number.resize(link.tetrahedra.size(), no_index);
    const auto enter = [&](TetId t) {
        if (number[t] != no_index) return;
        number[t] = static_cast<std::uint32_t>(inside.size());
        inside.push_back(t);
    };
    for (FacetCode f = 0; f < outside.size(); ++f)
        if (outside[f] != no_index) enter(tetrahedron_of(f));
    for (std::size_t i = 0; i < inside.size(); ++i)
        for (unsigned face = 0; face < 4; ++face)
            if (outside[facet_code(inside[i], face)] == no_index)
                enter(tetrahedron_of(link.tetrahedra[inside[i]].n[face]));

    filling_.reserve(inside.size());
    for (const TetId t : inside) {
        Tetrahedron record = link.tetrahedra[t];
        Filling filling = {};
        for (unsigned face = 0; face < 4; ++face) {
            filling.v[face] = number_in(link, record.v[face]);
            if (filling.v[face] == no_index)
                fail(MGDT_ERR_INTERNAL, "a hole leads out of the hull; please report it");
            record.v[face] = link_[filling.v[face]];
            const FacetCode n = outside[facet_code(t, face)];
            filling.is_outside[face] = n != no_index;
            filling.n[face] =
                filling.is_outside[face]
                    ? n
                    : facet_code(number[tetrahedron_of(record.n[face])], face_of(record.n[face]));
        }
        filling.sphere = circumsphere(record, mesh.vertices.data());
        ghosts_made_ += record.is_ghost();
        filling_.push_back(filling);
    }
    end_filling(mesh);
}

// Returns, for each facet of the link's triangulation, the facet code of the remaining tetrahedron
// behind the facet if the facet is on the boundary of the hole, seen from inside; else no_index.
Buffer<FacetCode> VertexRemoval::boundary_in(const Mesh& triangulated_link) {
    const Mesh& link = triangulated_link;
    Buffer<FacetCode> outside(star_.allocator());
    outside.resize(4 * link.tetrahedra.size(), no_index);
    for (TetId t = 0; t < link.tetrahedra.size(); ++t) {
        const Tetrahedron& record = link.tetrahedra[t];
        if (record.is_dead()) continue;
        for (unsigned face = 0; face < 4; ++face) {
            const unsigned char* const corner = outer_face[face];
            // Seen from inside, the vertices of a facet are in reverse order.
            const Number v[3] = {number_in(link, record.v[corner[0]]),
                                 number_in(link, record.v[corner[2]]),
                                 number_in(link, record.v[corner[1]])};
            const FacetKey key(v);
            const std::uint32_t found = numbers_of_facets_.find(
                key.hash(), [&](std::uint32_t i) { return FacetKey(facets_[i].v) == key; });
            if (found == NumberTable::none) continue;
            Facet& f = facets_[found];
            const std::size_t first = static_cast<std::size_t>(std::find(f.v, f.v + 3, v[0]) - f.v);
            if (f.v[(first + 1) % 3] != v[1]) continue;
            f.is_closed = true;
            outside[facet_code(t, face)] = f.behind;
        }
    }
    return outside;
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

void VertexRemoval::number_link(const Mesh& mesh, VertexId v) {
    link_.clear();
    // By Euler's formula, a link of F facets has F / 2 + 2 vertices.
    const std::size_t most = star_.size() / 2 + 2;
    link_.reserve(most);
    numbers_.clear(2 * most);
    infinite_ = no_index;
    for (const TetId t : star_)
        for (const VertexId u : mesh.tetrahedra[t].v) {
            if (u == v) continue;
            const Number number = numbers_.number(u, [](Number) { return true; });
            if (number < link_.size()) continue;
            if (u == infinite_vertex) infinite_ = number;
            link_.push_back(u);
            prefetch(mesh.point(u));
        }
}

LinkColumns VertexRemoval::columns_of_link(const Mesh& mesh) {
    const std::size_t size = (link_.size() + 3) / 4 * 4;
    columns_.clear();
    columns_.resize(4 * size);
    double* const x = columns_.data();
    double *const y = x + size, *const z = y + size, *const skipped = z + size;
    for (std::size_t k = 0; k < size; ++k) {
        const bool is_vertex = k < link_.size() && k != infinite_;
        const double* const p = mesh.point(is_vertex ? link_[k] : infinite_vertex);
        x[k] = p[0];
        y[k] = p[1];
        z[k] = p[2];
        skipped[k] = is_vertex ? 0.0 : -0.0;
    }
    return {x, y, z, skipped, size};
}

VertexRemoval::Number VertexRemoval::number_of(VertexId v) const noexcept {
    return numbers_.lookup()(v);
}

void VertexRemoval::add_boundary(const Mesh& mesh) {
    for (const TetId t : star_) {
        const Tetrahedron& record = mesh.tetrahedra[t];
        const auto face =
            static_cast<unsigned>(std::find(record.v, record.v + 4, vertex_) - record.v);
        const FacetCode code = record.n[face];
        const Tetrahedron& outside = mesh.tetrahedra[tetrahedron_of(code)];
        const unsigned char* const corner = outer_face[face_of(code)];
        join({number_of(outside.v[corner[0]]), number_of(outside.v[corner[1]]),
              number_of(outside.v[corner[2]])},
             code, true);
    }
}

void VertexRemoval::join(const Number (&v)[3], FacetCode behind, bool is_outside) {
    const FacetKey key(v);
    numbers_of_facets_.reserve(facets_.size() + 1);
    const std::uint32_t number = numbers_of_facets_.number(
        key.hash(), [&](std::uint32_t i) { return FacetKey(facets_[i].v) == key; });
    if (number == facets_.size()) {
        facets_.push_back({{v[0], v[1], v[2]}, behind, is_outside, false});
        return;
    }
    Facet& f = facets_[number];
    if (f.is_closed) fail(MGDT_ERR_INTERNAL, "a facet is met three times; please report it");
    f.is_closed = true;
    const auto link = [&](FacetCode from, bool from_outside, FacetCode to, bool to_outside) {
        if (from_outside) return;
        Filling& t = filling_[tetrahedron_of(from)];
        t.n[face_of(from)] = to;
        t.is_outside[face_of(from)] = to_outside;
    };
    link(behind, is_outside, f.behind, f.is_outside);
    link(f.behind, f.is_outside, behind, is_outside);
}

// The apex of a finite facet: the vertex of the link that forms the tetrahedron on its inner side.
// fill() calls this function for a facet that the kernel's find_apex() leaves undecided.
ApexResult VertexRemoval::apex_of(const Mesh& mesh, const Facet& facet) const {
    const double* const a = point(mesh, facet.v[0]);
    const double* const b = point(mesh, facet.v[1]);
    const double* const c = point(mesh, facet.v[2]);
    const bool has_extremes = mesh.has_extremes;
    const bool is_normal =
        !has_extremes || (in_normal_range(a) && in_normal_range(b) && in_normal_range(c));
    // (a, c, b, e) is positively oriented for e beyond the facet: n . (e - a) > 0.
    const LocalVertex rb = relative_to(b, a), rc = relative_to(c, a);
    const double n[3] = {rc.y * rb.z - rc.z * rb.y, rc.z * rb.x - rc.x * rb.z,
                         rc.x * rb.y - rc.y * rb.x};
    const double side_bound = proved_bounds.sphere_det * unit_roundoff * (rb.largest * rc.largest);
    Number best = no_index;
    const double* d = nullptr;
    Sphere sphere;
    for (Number k = 0; k < link_.size(); ++k) {
        if (k == infinite_ || k == facet.v[0] || k == facet.v[1] || k == facet.v[2]) continue;
        const double* const e = point(mesh, k);
        const LocalVertex re = relative_to(e, a);
        const bool is_trusted = is_normal && (!has_extremes || in_normal_range(e));
        // The same condition for a positive determinant as in set_sphere().
        const double side = n[0] * re.x + n[1] * re.y + n[2] * re.z;
        const double least = side_bound * re.largest;
        if (is_trusted && side < -least) continue;
        if (best != no_index) {
            const Power p = power(sphere, a, Query(e, is_trusted));
            if (p.is_decided() ? p.value > 0 : side_of_sphere_perturbed(a, c, b, d, e) < 0)
                continue;
        }
        if (!(is_trusted && side > least) && orientation(a, c, b, e) <= 0) continue;
        best = k;
        d = e;
        set_sphere(rc, rb, re, sphere);
        if (!is_trusted) sphere.e = infinity;
    }
    return {best == no_index ? infinite_apex : best, sphere};
}

Sphere VertexRemoval::ghost_sphere(const Mesh& mesh, const Facet& facet) const {
    const double* const a = point(mesh, facet.v[0]);
    const double* const b = point(mesh, facet.v[1]);
    const double* const c = point(mesh, facet.v[2]);
    Sphere sphere;
    set_normal(relative_to(c, a), relative_to(b, a), sphere);
    if (!in_normal_range(a) || !in_normal_range(b) || !in_normal_range(c)) sphere.e = -infinity;
    return sphere;
}

// Adds the tetrahedron of an open facet and its apex to the filling.
void VertexRemoval::close(const Mesh& mesh, std::size_t facet, ApexResult apex) {
    const Facet f = facets_[facet];
    const bool is_ghost = apex.number == infinite_apex;
    if (is_ghost) apex = {infinite_, ghost_sphere(mesh, f)};
    if (apex.number == no_index || filling_.size() >= max_tetrahedra)
        fail(MGDT_ERR_INTERNAL, "a hole cannot be filled; please report it");
    ghosts_made_ += is_ghost;
    const auto t = static_cast<TetId>(filling_.size());
    const Number v[4] = {f.v[0], f.v[2], f.v[1], apex.number};
    filling_.push_back({{v[0], v[1], v[2], v[3]}, {}, {}, apex.sphere});
    for (unsigned face = 4; face-- > 0;) {
        const unsigned char* const corner = outer_face[face];
        join({v[corner[0]], v[corner[1]], v[corner[2]]}, facet_code(t, face), false);
    }
}

TetId VertexRemoval::replace(Mesh& mesh) noexcept {
    const std::size_t removed = star_.size(), created = filling_.size();
    for (std::size_t i = 0; i < std::min(removed, created); ++i) slots_[i] = first_facet(star_[i]);
    for (std::size_t i = created; i < removed; ++i) mesh.free_slot(star_[i]);
    if (created > removed) mesh.take_slots(slots_.data() + removed, created - removed);

    const bool has_spheres = mesh.tetrahedra.has_spheres();
    for (std::size_t i = 0; i < created; ++i) {
        const Filling& t = filling_[i];
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
    mesh.ghost_count = mesh.ghost_count + ghosts_made_ - ghosts_gone_;
    return tetrahedron_of(slots_[0]);
}

void VertexRemoval::keep_star(const Mesh& mesh) {
    kept_.clear();
    kept_.reserve(star_.size());
    for (const TetId t : star_) kept_.push_back(mesh.tetrahedra[t]);
    a_ghost_ = mesh.a_ghost;
}

TetId VertexRemoval::undo(Mesh& mesh) noexcept {
    const std::size_t removed = star_.size(), created = filling_.size();
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
    mesh.ghost_count = mesh.ghost_count + ghosts_gone_ - ghosts_made_;
    mesh.a_ghost = a_ghost_;
    return star_[0];
}

void VertexRemoval::reset() noexcept {
    kept_.reset();
    star_.reset();
    link_.reset();
    columns_.reset();
    numbers_.reset();
    facets_.reset();
    numbers_of_facets_.reset();
    filling_.reset();
    slots_.reset();
}

}  // namespace mgdt
