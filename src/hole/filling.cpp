// SPDX-License-Identifier: MIT
#include "hole/filling.hpp"

#include <algorithm>
#include <limits>

#include "kernel/circumsphere.hpp"
#include "mesh/facet_turns.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

void Filling::begin(const Buffer<VertexId>& vertices, Number infinite) {
    vertices_ = &vertices;
    infinite_ = infinite;
    facets_.clear();
    elements_.clear();
    ghosts_ = 0;
    const std::size_t n = vertices.size();
    constexpr std::size_t most_in_matrix = 64;
    std::size_t heads = n * n;
    stride_ = n;
    mask_ = ~std::size_t{0};
    if (n > most_in_matrix) {
        for (heads = most_in_matrix * most_in_matrix; heads < 8 * n;) heads *= 2;
        stride_ = 0x9E3779B1u;
        mask_ = heads - 1;
    }
    heads_.clear();
    heads_.resize(heads, no_index);
}

void Filling::fill(const Kernel& kernel, const Mesh& mesh) {
    const bool has_columns = vertices_->size() <= HoleColumns::most && !mesh.has_extremes;
    const HoleColumns columns = has_columns ? this->columns(mesh) : HoleColumns();
    // Starting at finite facets suffices: each ghost is reached through one.
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
        const Facet& f = facets_[i];
        if (f.is_closed || f.v[0] == infinite_ || f.v[1] == infinite_ || f.v[2] == infinite_)
            continue;
        ApexResult apex = {no_apex, {}};
        if (has_columns) apex = kernel.find_apex(columns, f.v);
        close(mesh, i, apex.number == no_apex ? apex_of(mesh, f) : apex);
    }
    require_full();
}

void Filling::require_full() const {
    for (const Facet& f : facets_)
        if (!f.is_closed) fail(MGDT_ERR_INTERNAL, "a hole is not filled; please report it");
}

HoleColumns Filling::columns(const Mesh& mesh) {
    const std::size_t n = vertices_->size(), size = (n + 3) / 4 * 4;
    columns_.clear();
    columns_.resize(3 * size);
    double* const x = columns_.data();
    double *const y = x + size, *const z = y + size;
    HoleColumns columns = {x, y, z, size, {}};
    for (std::size_t k = 0; k < size; ++k) {
        if (k < n && k != infinite_) {
            const double* const p = point(mesh, static_cast<Number>(k));
            x[k] = p[0];
            y[k] = p[1];
            z[k] = p[2];
        } else {
            x[k] = y[k] = z[k] = std::numeric_limits<double>::quiet_NaN();
            columns.skipped[k / 64] |= std::uint64_t{1} << (k % 64);
        }
    }
    return columns;
}

void Filling::join(const Number (&v)[3], FacetCode behind, bool is_outside) {
    Number t[3] = {v[0], v[1], v[2]};
    turn_to_least(t);
    // Seen from its other side, the facet has the opposite orientation.
    const std::uint32_t other = facet(t[0], t[2], t[1]);
    if (other != no_index) {
        link(other, behind, is_outside);
        return;
    }
    const std::size_t size = facets_.size();
    std::uint32_t& head = heads_[head_of(t[0], t[1])];
    facets_.grow(size + 1);
    facets_.resize_within_capacity(size + 1);
    facets_[size] = {{t[0], t[1], t[2]}, behind, head, is_outside, false};
    head = static_cast<std::uint32_t>(size);
}

// Links the tetrahedron at `behind` and that behind a facet that is open.
void Filling::link(std::uint32_t facet, FacetCode behind, bool is_outside) noexcept {
    Facet& f = facets_[facet];
    f.is_closed = true;
    const auto set = [&](FacetCode from, bool from_outside, FacetCode to, bool to_outside) {
        if (from_outside) return;
        Element& t = elements_[tetrahedron_of(from)];
        t.n[face_of(from)] = to;
        t.is_outside[face_of(from)] = to_outside;
    };
    set(behind, is_outside, f.behind, f.is_outside);
    set(f.behind, f.is_outside, behind, is_outside);
}

// The apex of a finite facet: the vertex that forms the tetrahedron on its inner side. fill() calls
// this function for a facet that the kernel's find_apex() leaves undecided.
ApexResult Filling::apex_of(const Mesh& mesh, const Facet& facet) const {
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
    for (Number k = 0; k < vertices_->size(); ++k) {
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

Sphere Filling::ghost_sphere(const Mesh& mesh, const Facet& facet) const {
    const double* const a = point(mesh, facet.v[0]);
    const double* const b = point(mesh, facet.v[1]);
    const double* const c = point(mesh, facet.v[2]);
    Sphere sphere;
    set_normal(relative_to(c, a), relative_to(b, a), sphere);
    if (!in_normal_range(a) || !in_normal_range(b) || !in_normal_range(c)) sphere.e = -infinity;
    return sphere;
}

// Adds the tetrahedron of an open facet and its apex.
void Filling::close(const Mesh& mesh, std::uint32_t facet, ApexResult apex) {
    const Facet f = facets_[facet];
    const bool is_ghost = apex.number == infinite_apex;
    if (is_ghost) apex = {infinite_, ghost_sphere(mesh, f)};
    // n points have fewer than n^2 / 2 tetrahedra, and fewer than 2 n ghosts.
    const std::size_t n = vertices_->size();
    if (apex.number == no_index || elements_.size() >= n * n)
        fail(MGDT_ERR_INTERNAL, "a hole cannot be filled; please report it");
    ghosts_ += is_ghost;
    const auto t = static_cast<TetId>(elements_.size());
    const Number v[4] = {f.v[0], f.v[2], f.v[1], apex.number};
    elements_.grow(t + std::size_t{1});
    elements_.resize_within_capacity(t + std::size_t{1});
    elements_[t] = {{v[0], v[1], v[2], v[3]}, {}, {}, apex.sphere};
    link(facet, facet_code(t, 3), false);
    for (unsigned face = 3; face-- > 0;) {
        const unsigned char* const corner = outer_face[face];
        join({v[corner[0]], v[corner[1]], v[corner[2]]}, facet_code(t, face), false);
    }
}

// Adds the tetrahedra of the triangulation that are inside the hole: the tetrahedra at the inner
// side of the boundary, and all that are reached from these without crossing the boundary.
void Filling::fill_from(const Mesh& triangulated_vertices, const Mesh& mesh) {
    const Mesh& all = triangulated_vertices;
    const Buffer<FacetCode> outside = boundary_in(all);
    Buffer<TetId> inside(facets_.allocator());
    Buffer<std::uint32_t> number(facets_.allocator());
    inside.reserve(all.live_count());
    number.resize(all.tetrahedra.size(), no_index);
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
                enter(tetrahedron_of(all.tetrahedra[inside[i]].n[face]));

    elements_.reserve(inside.size());
    for (const TetId t : inside) {
        Tetrahedron record = all.tetrahedra[t];
        Element element = {};
        for (unsigned face = 0; face < 4; ++face) {
            element.v[face] = number_in(all, record.v[face]);
            if (element.v[face] == no_index)
                fail(MGDT_ERR_INTERNAL, "a hole leads out of the hull; please report it");
            record.v[face] = (*vertices_)[element.v[face]];
            const FacetCode n = outside[facet_code(t, face)];
            element.is_outside[face] = n != no_index;
            element.n[face] =
                element.is_outside[face]
                    ? n
                    : facet_code(number[tetrahedron_of(record.n[face])], face_of(record.n[face]));
        }
        element.sphere = circumsphere(record, mesh.vertices.data());
        ghosts_ += record.is_ghost();
        elements_.push_back(element);
    }
    require_full();
}

// Returns, for each facet of the triangulation, the facet code of the remaining tetrahedron behind
// the facet if the facet is on the boundary of the hole, seen from inside; else no_index.
Buffer<FacetCode> Filling::boundary_in(const Mesh& triangulated_vertices) {
    const Mesh& all = triangulated_vertices;
    Buffer<FacetCode> outside(facets_.allocator());
    outside.resize(4 * all.tetrahedra.size(), no_index);
    for (TetId t = 0; t < all.tetrahedra.size(); ++t) {
        const Tetrahedron& record = all.tetrahedra[t];
        if (record.is_dead()) continue;
        for (unsigned face = 0; face < 4; ++face) {
            const unsigned char* const corner = outer_face[face];
            // Seen from inside, the vertices of a facet are in reverse order.
            Number v[3] = {number_in(all, record.v[corner[0]]), number_in(all, record.v[corner[2]]),
                           number_in(all, record.v[corner[1]])};
            if (std::find(v, v + 3, no_index) != v + 3) continue;
            turn_to_least(v);
            const std::uint32_t found = facet(v[0], v[1], v[2]);
            if (found == no_index) continue;
            facets_[found].is_closed = true;
            outside[facet_code(t, face)] = facets_[found].behind;
        }
    }
    return outside;
}

void Filling::reset() noexcept {
    columns_.reset();
    facets_.reset();
    heads_.reset();
    elements_.reset();
}

}  // namespace mgdt
