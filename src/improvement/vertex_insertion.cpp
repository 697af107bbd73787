// SPDX-License-Identifier: MIT
#include "improvement/vertex_insertion.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {

// Collects the faces around the first tetrahedra of the cavity.
void VertexInsertion::collect_faces(std::size_t size) {
    faces_.clear();
    const std::uint32_t* const begin = cavity_.begin();
    const std::uint32_t* const end = begin + size;
    for (std::size_t k = 0; k < size; ++k) {
        const FlexibleMesh::Tetrahedron& t = mesh_.tetrahedra[cavity_[k]];
        for (unsigned i = 0; i < 4; ++i) {
            if (t.n[i] != no_index && std::find(begin, end, t.n[i] / 4) != end) continue;
            const unsigned char* const f = outer_face[i];
            // (q, f0, f1, f2) is positive for q beyond the face, so (f0, f1, f2, inside) is.
            faces_.push_back({{t.v[f[0]], t.v[f[1]], t.v[f[2]]}, 4 * cavity_[k] + i, 0});
        }
    }
}

// Adds the tetrahedron behind the worst face. Returns false if that face has to stay.
bool VertexInsertion::grow() {
    const Face* worst = nullptr;
    for (Face& face : faces_) {
        face.quality = quality_of(mesh_.point(face.v[0]), mesh_.point(face.v[1]),
                                  mesh_.point(face.v[2]), place_);
        if (worst == nullptr || face.quality < worst->quality) worst = &face;
    }
    const FlexibleMesh::Tetrahedron& t = mesh_.of(worst->code);
    const std::uint32_t behind = t.n[worst->code % 4];
    if (behind == no_index || t.facets[worst->code % 4] != no_index) return false;
    cavity_.push_back(behind / 4);
    collect_faces(cavity_.size());
    return true;
}

// Whether all corners of the first tetrahedra of the cavity, and all edges that the mesh keeps, are
// on its faces.
bool VertexInsertion::keeps_vertices_and_edges(std::size_t size) const {
    const auto is_on_face = [&](std::uint32_t a, std::uint32_t b) {
        return std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
            return std::find(face.v, face.v + 3, a) != face.v + 3 &&
                   std::find(face.v, face.v + 3, b) != face.v + 3;
        });
    };
    for (std::size_t k = 0; k < size; ++k) {
        const std::uint32_t(&v)[4] = mesh_.tetrahedra[cavity_[k]].v;
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
    constexpr int moves_per_size = 2;
    change.clear();
    cavity_.clear();
    cavity_.push_back(t);
    collect_faces(1);
    for (int k = 0; k < 3; ++k) {
        place_[k] = 0;
        for (const std::uint32_t v : mesh_.tetrahedra[t].v) place_[k] += mesh_.point(v)[k] / 4;
    }
    double before = mesh_.qualities[t], best = before;
    std::size_t best_size = 0;
    double best_place[3];
    while (grow()) {
        const std::size_t size = cavity_.size();
        before = std::min(before, mesh_.qualities[cavity_[size - 1]]);
        search_.clear();
        for (const Face& face : faces_)
            search_.add(mesh_.point(face.v[0]), mesh_.point(face.v[2]), mesh_.point(face.v[1]));
        const double moved =
            search_.improve(free_vertex, {moves_per_size, best_quality, goal, false}, place_);
        const double worst = moved > 0 ? moved : search_.worst_at(place_);
        if (worst > best) {
            best = worst;
            best_size = size;
            std::copy_n(place_, 3, best_place);
        }
        if (size == most_tetrahedra) break;
    }
    if (best_size == 0) return false;
    collect_faces(best_size);
    if (!keeps_vertices_and_edges(best_size)) return false;
    std::copy_n(best_place, 3, change.more.place);
    change.before = change.after = above_all;
    for (std::size_t k = 0; k < best_size; ++k) {
        change.removed.push_back(cavity_[k]);
        change.before = std::min(change.before, mesh_.qualities[cavity_[k]]);
    }
    for (const Face& face : faces_) {
        const double quality = quality_of(mesh_.point(face.v[0]), mesh_.point(face.v[1]),
                                          mesh_.point(face.v[2]), best_place);
        change.added.push_back(
            {{face.v[0], face.v[1], face.v[2], Change::new_vertex}, mesh_.regions[t], quality});
        change.after = std::min(change.after, quality);
    }
    double missing = 0;
    for (const std::uint32_t r : change.removed) missing += missing_to(goal, mesh_.qualities[r]);
    for (const Change::Tetrahedron& a : change.added) missing -= missing_to(goal, a.quality);
    return change.after > change.before && missing > 0;
}

}  // namespace mgdt
