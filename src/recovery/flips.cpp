// SPDX-License-Identifier: MIT
#include "recovery/flips.hpp"

#include <algorithm>

#include "mesh/tetrahedron.hpp"
#include "platform/hash.hpp"

namespace mgdt {

int Flips::crossings_of(const EdgeRing& ring, const Crossings& crossings) const {
    return crossings.of_edge(ring.p, ring.q) + crossings.of_faces(ring.p, ring.q, ring.v);
}

// Finds a filling with at most `most` crossings. The same rings come again and again while flips go
// deeper, so those without a filling are remembered.
bool Flips::find_filling(const EdgeRing& ring, const Crossings& crossings, int most) {
    std::uint64_t hash = crossings.hash();
    // A point that is added later may get the number of one that was taken back.
    const auto add = [&](std::uint32_t v) {
        hash = mixed(hash, std::uint64_t{v} << 32 | hash_of_coordinates(mesh_.point(v)));
    };
    add(ring.p);
    add(ring.q);
    for (const std::uint32_t v : ring.v) add(v);
    if (failed_.empty()) failed_.resize(failures, Failure{0, 0});
    Failure& failure = failed_[hash % failures];
    if (failure.ring == hash && most <= failure.most) return false;
    if (filling_.find(ring.p, ring.q, ring.v.begin(), ring.v.size(), crossings, most)) return true;
    failure = {hash, most};
    return false;
}

bool Flips::remove_edge(std::uint32_t p, std::uint32_t q, const Crossings& crossings, int limit,
                        unsigned depth, int& change) {
    if (budget_ == 0 || is_kept(p, q)) return false;
    --budget_;
    EdgeRing& ring = levels_[depth].ring;
    if (!ring.collect(mesh_, p, q, most_ring)) return false;
    const int before = crossings_of(ring, crossings);
    if (find_filling(ring, crossings, before + limit)) {
        added_.clear();
        filling_.append(added_);
        change += filling_.crossings() - before;
        return mesh_.replace(ring.tetrahedra, added_);
    }
    if (depth == 0) return false;
    const std::size_t state = mesh_.state();
    Buffer<std::uint32_t>& spokes = levels_[depth].spokes;
    spokes.clear();
    for (const std::uint32_t v : ring.v) spokes.push_back(v);
    for (const std::uint32_t spoke : spokes)
        for (const std::uint32_t end : {p, q}) {
            int sum = 0;
            if (!remove_edge(end, spoke, crossings, limit + before, depth - 1, sum)) continue;
            if (remove_edge(p, q, crossings, limit - sum, depth - 1, sum)) {
                change += sum;
                return true;
            }
            mesh_.undo(state);
        }
    return false;
}

bool Flips::remove_face(std::uint32_t code, const Crossings& crossings, int limit, int& change) {
    const std::uint32_t other = mesh_.of(code).n[code % 4];
    if (other == no_index) return false;
    const FlipMesh::Tetrahedron& t = mesh_.of(code);
    const std::uint32_t above = mesh_.apex(code), below = mesh_.apex(other);
    const unsigned char* const f = outer_face[code % 4];
    // (below, v0, v1, v2) is positive.
    const std::uint32_t v[3] = {t.v[f[0]], t.v[f[1]], t.v[f[2]]};
    int after = crossings.of_edge(above, below);
    for (int k = 0; k < 3; ++k) {
        if (orientation(mesh_.point(below), mesh_.point(v[k]), mesh_.point(v[(k + 1) % 3]),
                        mesh_.point(above)) <= 0)
            return false;
        after += crossings.of_face(above, below, v[k]);
    }
    const int before = crossings.of_face(v[0], v[1], v[2]);
    if (after - before > limit) return false;
    added_.clear();
    removed_.clear();
    for (int k = 0; k < 3; ++k) added_.push_back({{below, v[k], v[(k + 1) % 3], above}});
    removed_.push_back(code / 4);
    removed_.push_back(other / 4);
    change += after - before;
    return mesh_.replace(removed_, added_);
}

bool Flips::turn_edge(std::uint32_t p, std::uint32_t q, const Crossings& crossings, int limit) {
    if (is_kept(p, q)) return false;
    EdgeRing& ring = levels_[0].ring;
    if (!ring.collect(mesh_, p, q, most_ring)) return false;
    const int before = crossings_of(ring, crossings);
    const std::size_t state = mesh_.state(), n = ring.v.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n && j + 2 <= n + i; ++j) {
            const std::uint32_t r = ring.v[i], s = ring.v[j];
            if (Crossings::of_segment(mesh_, r, s).of_edge(p, q) != 1) continue;
            int count = crossings.of_edge(r, s) - before;
            if (count > limit) continue;
            added_.clear();
            if (fill_side(ring, i, j, crossings, count) &&
                fill_side(ring, j, i + n, crossings, count) && count <= limit) {
                return mesh_.replace(ring.tetrahedra, added_);
            }
            mesh_.undo(state);
        }
    return false;
}

// Fills the part of a ring between two of its vertices, and adds the number of times that the
// filling is crossed to `count`. Returns false if there is no filling.
bool Flips::fill_side(const EdgeRing& ring, std::size_t from, std::size_t to,
                      const Crossings& crossings, int& count) {
    const std::size_t n = ring.v.size();
    part_.clear();
    for (std::size_t k = from; k <= to; ++k) part_.push_back(ring.v[k % n]);
    if (filling_.find(ring.p, ring.q, part_.begin(), part_.size(), crossings, 0)) {
        filling_.append(added_);
        return true;
    }
    return add_point_beside(ring, crossings, count);
}

// Fills the part of a ring with tetrahedra at a new point. The point is near the middle of the
// quadrilateral, from which the whole part is visible.
bool Flips::add_point_beside(const EdgeRing& ring, const Crossings& crossings, int& count) {
    const std::size_t m = part_.size();
    const double *const p = mesh_.point(ring.p), *const q = mesh_.point(ring.q),
                        *const r = mesh_.point(part_[0]), *const s = mesh_.point(part_[m - 1]);
    // The crossing of the diagonals, and the direction from there to the inside of the part.
    double on_plane[3], inside[3] = {0, 0, 0};
    {
        double d[3], e[3], n[3];
        for (int k = 0; k < 3; ++k) {
            d[k] = q[k] - p[k];
            e[k] = s[k] - r[k];
        }
        for (int k = 0; k < 3; ++k)
            n[k] = d[(k + 1) % 3] * e[(k + 2) % 3] - d[(k + 2) % 3] * e[(k + 1) % 3];
        double det = 0, t = 0;
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, o = (k + 2) % 3;
            det += n[k] * n[k];
            t += ((r[l] - p[l]) * e[o] - (r[o] - p[o]) * e[l]) * n[k];
        }
        t = det > 0 ? t / det : 0.5;
        for (int k = 0; k < 3; ++k) on_plane[k] = p[k] + t * d[k];
    }
    // The weights are no simple fractions, so that points avoid planes of a lattice.
    double weight = 0.9137;
    for (std::size_t i = 1; i + 1 < m; ++i, weight *= 1.0713)
        for (int k = 0; k < 3; ++k)
            inside[k] += weight * (mesh_.point(part_[i])[k] - on_plane[k]) / static_cast<double>(m);
    const std::size_t size = added_.size();
    const std::size_t state = mesh_.state();
    for (const double share : {0.3, 0.08, 0.02, 0.004, 0.0005, 3e-5, 2e-6, 1e-7, 5e-9}) {
        double x[3];
        for (int k = 0; k < 3; ++k) x[k] = on_plane[k] + share * inside[k];
        const std::uint32_t z = mesh_.add_point(x);
        int sum = crossings.of_edge(z, ring.p) + crossings.of_edge(z, ring.q);
        for (std::size_t i = 0; i < m; ++i) {
            const std::uint32_t here = part_[i], next = part_[(i + 1) % m];
            added_.push_back({{ring.p, z, here, next}});
            added_.push_back({{z, ring.q, here, next}});
            sum += crossings.of_edge(z, here) + crossings.of_face(z, here, next) +
                   crossings.of_face(z, here, ring.p) + crossings.of_face(z, here, ring.q);
        }
        if (mesh_.are_positive(added_, size)) {
            center_new_point(mesh_, z, added_, size, center_);
            count += sum;
            return true;
        }
        added_.resize(size);
        mesh_.undo(state);
    }
    return false;
}

}  // namespace mgdt
