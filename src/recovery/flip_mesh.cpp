// SPDX-License-Identifier: MIT
#include "recovery/flip_mesh.hpp"

#include <algorithm>

#include "mesh/tetrahedron.hpp"
#include "platform/hash.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

std::uint32_t FlipMesh::add_point(const double (&x)[3]) {
    const auto number = static_cast<std::uint32_t>(point_count());
    note(Step::add_point, number);
    points_.grow(points_.size() + 3);
    hints.grow(hints.size() + 1);
    for (const double c : x) points_.push_back(c);
    hints.push_back(no_tetrahedron);
    return number;
}

FlipMesh::Face FlipMesh::make_face(const std::uint32_t (&v)[4], unsigned position) noexcept {
    const unsigned char* const f = outer_face[position];
    Face face = {{v[f[0]], v[f[1]], v[f[2]]}, no_index, false, false};
    for (const int i : {0, 1, 0})
        if (face.v[i] > face.v[i + 1]) {
            std::swap(face.v[i], face.v[i + 1]);
            face.is_odd = !face.is_odd;
        }
    return face;
}

// The entry of the table for a face: that of an equal one, or a free one.
std::uint32_t& FlipMesh::place_of(const Face& face) noexcept {
    const std::size_t mask = table_.size() - 1;
    std::size_t at =
        hash_of_words(std::uint64_t{face.v[0]} << 32 | face.v[1], std::uint64_t{face.v[2]}) & mask;
    for (;; at = (at + 1) & mask) {
        std::uint32_t& entry = table_[at];
        if (entry == 0 || std::equal(face.v, face.v + 3, faces_[entry - 1].v)) return entry;
    }
}

std::uint32_t FlipMesh::new_slot() {
    if (!free_slots.empty()) {
        note(Step::take, free_slots.back());
    } else {
        note(Step::append, static_cast<std::uint32_t>(tetrahedra.size()));
        tetrahedra.grow(tetrahedra.size() + 1);
    }
    return take_slot();
}

// Finds the faces with which those of the new tetrahedra are joined. Returns false if the new
// tetrahedra have other outer faces than those that leave.
bool FlipMesh::pair_faces(const Buffer<std::uint32_t>& removed, const Buffer<Corners>& added) {
    leaves_.grow(tetrahedra.size());
    leaves_.resize(tetrahedra.size(), 0);
    faces_.clear();
    std::size_t size = 16;
    while (size < 8 * (removed.size() + added.size())) size *= 2;
    table_.clear();
    table_.resize(size, 0u);
    for (const std::uint32_t t : removed) leaves_[t] = 1;
    for (const std::uint32_t t : removed)
        for (unsigned i = 0; i < 4; ++i) {
            const std::uint32_t behind = tetrahedra[t].n[i];
            if (behind != no_index && leaves_[behind / 4] != 0) continue;
            Face face = make_face(tetrahedra[t].v, i);
            face.code = behind;
            face.is_odd = !face.is_odd;
            faces_.push_back(face);
            place_of(face) = static_cast<std::uint32_t>(faces_.size());
        }
    for (const std::uint32_t t : removed) leaves_[t] = 0;
    outer_faces_ = faces_.size();
    links_.clear();
    std::size_t open = faces_.size();
    for (std::size_t k = 0; k < added.size(); ++k)
        for (unsigned i = 0; i < 4; ++i) {
            const Face face = make_face(added[k].v, i);
            std::uint32_t& place = place_of(face);
            if (place == 0) {
                faces_.push_back(face);
                faces_.back().code = static_cast<std::uint32_t>(4 * k + i);
                place = static_cast<std::uint32_t>(faces_.size());
                links_.push_back(no_index);
                ++open;
                continue;
            }
            links_.push_back(place - 1);
            if (faces_[place - 1].is_paired || faces_[place - 1].is_odd == face.is_odd)
                return false;
            faces_[place - 1].is_paired = true;
            --open;
        }
    return open == 0;
}

bool FlipMesh::replace(const Buffer<std::uint32_t>& removed, const Buffer<Corners>& added) {
    if (!pair_faces(removed, added)) return false;
    for (std::size_t f = 0; f < outer_faces_; ++f)
        if (faces_[f].code != no_index) note(Step::write, faces_[f].code / 4);
    for (const std::uint32_t t : removed) note(Step::write, t);
    slots_.clear();
    for (std::size_t k = 0; k < added.size(); ++k)
        slots_.push_back(k < removed.size() ? removed[k] : new_slot());
    for (std::size_t k = added.size(); k < removed.size(); ++k) {
        remove(removed[k]);
        note(Step::give, removed[k]);
    }
    for (std::size_t k = 0; k < added.size(); ++k) {
        Tetrahedron& t = tetrahedra[slots_[k]];
        t = {{added[k].v[0], added[k].v[1], added[k].v[2], added[k].v[3]},
             {no_index, no_index, no_index, no_index},
             {no_index, no_index, no_index, no_index}};
        for (const std::uint32_t v : t.v) hints[v] = slots_[k];
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
        if (links_[i] == no_index) continue;
        const Face& face = faces_[links_[i]];
        const auto code = [&](std::size_t of) {
            return 4 * slots_[of / 4] + static_cast<std::uint32_t>(of % 4);
        };
        join(code(i), links_[i] < outer_faces_ ? face.code : code(face.code));
    }
    return true;
}

bool FlipMesh::is_positive(const Corners& t) const noexcept {
    return orientation(point(t.v[0]), point(t.v[1]), point(t.v[2]), point(t.v[3])) > 0;
}

bool FlipMesh::are_positive(const Buffer<Corners>& list, std::size_t first) const noexcept {
    return std::all_of(list.begin() + first, list.end(),
                       [&](const Corners& t) { return is_positive(t); });
}

std::uint32_t FlipMesh::split(std::uint32_t t, const double (&x)[3]) {
    const Tetrahedron whole = tetrahedra[t];
    const std::size_t before = state();
    const std::uint32_t z = add_point(x);
    removed_.clear();
    added_.clear();
    removed_.push_back(t);
    for (unsigned i = 0; i < 4; ++i) {
        Corners c = {{whole.v[0], whole.v[1], whole.v[2], whole.v[3]}};
        c.v[i] = z;
        if (!is_positive(c)) {
            undo(before);
            return no_index;
        }
        added_.push_back(c);
    }
    replace(removed_, added_);
    return z;
}

// Whether a ray from a, which is a corner of tetrahedron t, to b begins inside of t. If not, `next`
// becomes the neighbour behind a face at a that has the ray on its outer side.
bool FlipMesh::contains_direction(std::uint32_t t, std::uint32_t a, std::uint32_t b,
                                  std::uint32_t& next) const noexcept {
    const Tetrahedron& tet = tetrahedra[t];
    const unsigned char* const f = outer_face[tet.position(a)];
    // (a, v0, v1, v2) is positive.
    const unsigned v[3] = {f[0], f[2], f[1]};
    for (int k = 0; k < 3; ++k) {
        if (orientation(point(a), point(b), point(tet.v[v[k]]), point(tet.v[v[(k + 1) % 3]])) >= 0)
            continue;
        next = tet.n[v[(k + 2) % 3]];
        return false;
    }
    return true;
}

std::uint32_t FlipMesh::tetrahedron_towards(std::uint32_t a, std::uint32_t b) {
    // The walk may run in circles.
    constexpr int most_steps = 60;
    std::uint32_t t = hints[a], next = no_index;
    for (int i = 0; i < most_steps; ++i) {
        if (tetrahedra[t].has(b) || contains_direction(t, a, b, next)) return t;
        if (next == no_index) break;
        t = next / 4;
    }
    return find_at(a, [&](std::uint32_t at) {
        return tetrahedra[at].has(b) || contains_direction(at, a, b, next);
    });
}

void FlipMesh::collect_star(std::uint32_t v, Buffer<std::uint32_t>& star) {
    star.clear();
    find_at(v, [&](std::uint32_t t) { return star.push_back(t), false; });
}

void FlipMesh::undo(std::size_t state) noexcept {
    while (journal_.size() > state) {
        const Entry& entry = journal_.back();
        switch (entry.step) {
            case Step::write:
                tetrahedra[entry.slot] = entry.before;
                for (const std::uint32_t v : entry.before.v) hints[v] = entry.slot;
                break;
            case Step::take:
                tetrahedra[entry.slot] = entry.before;
                free_slots.push_back(entry.slot);
                break;
            case Step::give:
                free_slots.resize(free_slots.size() - 1);
                break;
            case Step::append:
                tetrahedra.resize(entry.slot);
                break;
            case Step::add_point:
                points_.resize(3 * std::size_t{entry.slot});
                hints.resize(entry.slot);
                break;
        }
        journal_.resize(journal_.size() - 1);
    }
}

}  // namespace mgdt
