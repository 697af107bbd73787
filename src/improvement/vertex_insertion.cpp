// SPDX-License-Identifier: MIT
#include "improvement/vertex_insertion.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {

// The cavity of one tetrahedron.
void VertexInsertion::begin(std::uint32_t t) {
    cavity_.clear();
    faces_.clear();
    add(t);
}

// Adds a tetrahedron to the cavity. Faces between it and the others leave the list.
void VertexInsertion::add(std::uint32_t t) {
    cavity_.push_back(t);
    const FlexibleMesh::Tetrahedron& one = mesh_.tetrahedra[t];
    std::size_t kept = 0;
    for (const Face& face : faces_)
        if (mesh_.of(face.code).n[face.code % 4] / 4 != t) faces_[kept++] = face;
    faces_.resize_within_capacity(kept);
    for (unsigned i = 0; i < 4; ++i) {
        if (one.n[i] != no_index && has(one.n[i] / 4)) continue;
        // (q, f0, f1, f2) is positive for q beyond the face, so (inside, f0, f2, f1) is.
        const unsigned char* const f = outer_face[i];
        Face face = {{one.v[f[0]], one.v[f[2]], one.v[f[1]]}, 4 * t + i, 0};
        face.quality = quality_of(place_, mesh_.point(face.v[0]), mesh_.point(face.v[1]),
                                  mesh_.point(face.v[2]));
        faces_.push_back(face);
    }
}

// Adds the tetrahedron behind the worst face. Returns false if that face has to stay.
bool VertexInsertion::grow() {
    const Face* const worst = std::min_element(
        faces_.begin(), faces_.end(),
        [](const Face& one, const Face& other) { return one.quality < other.quality; });
    const FlexibleMesh::Tetrahedron& t = mesh_.of(worst->code);
    const std::uint32_t behind = t.n[worst->code % 4];
    if (behind == no_index || t.facets[worst->code % 4] != no_index) return false;
    // A cavity around the rim of a facet would lose a face of it.
    const FlexibleMesh::Tetrahedron& next = mesh_.of(behind);
    for (unsigned i = 0; i < 4; ++i)
        if (next.facets[i] != no_index && next.n[i] != no_index && has(next.n[i] / 4)) return false;
    add(behind / 4);
    return true;
}

// Moves the new vertex to a better place in the cavity. Returns the worst quality there.
double VertexInsertion::move(double goal) {
    constexpr int most_moves = 2;
    search_.clear();
    for (const Face& face : faces_)
        search_.add(mesh_.point(face.v[0]), mesh_.point(face.v[1]), mesh_.point(face.v[2]),
                    face.quality);
    if (search_.improve(free_vertex, {most_moves, best_quality, goal, false}, place_))
        for (std::size_t f = 0; f < faces_.size(); ++f) faces_[f].quality = search_.quality(f);
    return search_.worst();
}

// Whether all corners of the cavity, and all edges that the mesh keeps, are on its faces.
bool VertexInsertion::keeps_vertices_and_edges() const {
    const auto is_on_face = [&](std::uint32_t a, std::uint32_t b) {
        return std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
            return std::find(face.v, face.v + 3, a) != face.v + 3 &&
                   std::find(face.v, face.v + 3, b) != face.v + 3;
        });
    };
    for (const std::uint32_t t : cavity_) {
        const std::uint32_t(&v)[4] = mesh_.tetrahedra[t].v;
        for (unsigned i = 0; i < 4; ++i) {
            if (!is_on_face(v[i], v[i])) return false;
            for (unsigned j = i + 1; j < 4; ++j)
                if (mesh_.edges.has(v[i], v[j]) && !is_on_face(v[i], v[j])) return false;
        }
    }
    return true;
}

bool VertexInsertion::find(std::uint32_t t, double goal, Change& change) {
    constexpr std::size_t most_tetrahedra = 24;
    change.clear();
    for (int k = 0; k < 3; ++k) {
        place_[k] = 0;
        for (const std::uint32_t v : mesh_.tetrahedra[t].v) place_[k] += mesh_.point(v)[k] / 4;
    }
    begin(t);
    double best = mesh_.qualities[t];
    std::size_t best_size = 0;
    double best_place[3];
    while (cavity_.size() < most_tetrahedra && grow()) {
        const double worst = move(goal);
        if (worst > best) {
            best = worst;
            best_size = cavity_.size();
            std::copy_n(place_, 3, best_place);
        }
    }
    if (best_size == 0) return false;
    std::copy_n(best_place, 3, place_);
    for (std::size_t k = 0; k < best_size; ++k) change.removed.push_back(cavity_[k]);
    begin(t);
    for (std::size_t k = 1; k < best_size; ++k) add(change.removed[k]);
    if (!keeps_vertices_and_edges()) return false;
    std::copy_n(best_place, 3, change.more.place);
    change.before = change.after = above_all;
    double missing = 0;
    for (const std::uint32_t r : cavity_) {
        change.before = std::min(change.before, mesh_.qualities[r]);
        missing += missing_to(goal, mesh_.qualities[r]);
    }
    for (const Face& face : faces_) {
        const std::uint32_t(&v)[3] = face.v;
        change.added.push_back(
            {{Change::new_vertex, v[0], v[1], v[2]}, mesh_.regions[t], face.quality});
        change.after = std::min(change.after, face.quality);
        missing -= missing_to(goal, face.quality);
    }
    return change.after > change.before && missing > 0;
}

}  // namespace mgdt
