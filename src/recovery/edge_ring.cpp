// SPDX-License-Identifier: MIT
#include "recovery/edge_ring.hpp"

#include <utility>

namespace mgdt {

bool EdgeRing::collect(FlipMesh& mesh, std::uint32_t from, std::uint32_t to, std::size_t most) {
    p = from;
    q = to;
    v.clear();
    tetrahedra.clear();
    const std::uint32_t first = mesh.tetrahedron_towards(p, q);
    if (first == no_tetrahedron || !mesh.tetrahedra[first].has(q)) return false;
    const FlipMesh::Tetrahedron& start = mesh.tetrahedra[first];
    unsigned k = 0;
    while (start.v[k] == p || start.v[k] == q) ++k;
    unsigned l = k + 1;
    while (start.v[l] == p || start.v[l] == q) ++l;
    // (p, q, v[k], v[l]) is positive if that order of the corners is even.
    const unsigned i = start.position(p), j = start.position(q);
    if (((i > j) + (i > k) + (i > l) + (j > k) + (j > l)) % 2 == 1) std::swap(k, l);
    std::uint32_t t = first, here = start.v[k], next = start.v[l];
    do {
        if (v.size() == most) return false;
        v.push_back(here);
        tetrahedra.push_back(t);
        const FlipMesh::Tetrahedron& tet = mesh.tetrahedra[t];
        const std::uint32_t code = tet.n[tet.position(here)];
        if (code == no_index) return false;
        here = next;
        next = mesh.apex(code);
        t = code / 4;
    } while (t != first);
    return true;
}

bool EdgeRing::join(FlipMesh& mesh, std::uint32_t point) {
    added_.clear();
    for (std::size_t i = 0; i < v.size(); ++i) {
        const std::uint32_t here = v[i], next = v[(i + 1) % v.size()];
        added_.push_back({{p, point, here, next}});
        added_.push_back({{point, q, here, next}});
    }
    return mesh.are_positive(added_) && mesh.replace(tetrahedra, added_);
}

}  // namespace mgdt
