// SPDX-License-Identifier: MIT
#include "dual/link.hpp"

namespace mgdt {

void Numbers::clear() {
    constexpr std::size_t least = 256;
    if (table_.empty()) {
        table_.resize(least, Entry{0, 0});
        names_.resize(least / 4);
        mask_ = least - 1;
    }
    // Numbers have 32 bits, and a link has fewer than 2^30 members.
    if (first_ + size_ > 0x80000000u) {
        table_.resize(0);
        table_.resize(std::size_t{mask_} + 1, Entry{0, 0});
        first_ = 1;
    } else {
        first_ += size_;
    }
    size_ = 0;
}

std::uint32_t Numbers::insert_into_larger(std::uint32_t name) {
    const std::size_t size = 2 * table_.size();
    names_.set_capacity(size / 4);
    table_.set_capacity(size);
    names_.resize(size / 4);
    table_.resize(0);
    table_.resize(size, Entry{0, 0});
    mask_ = static_cast<std::uint32_t>(size - 1);
    const std::uint32_t count = size_;
    size_ = 0;
    for (std::uint32_t i = 0; i < count; ++i) number(names_[i]);
    return number(name);
}

void Link::gather(const Mesh& mesh, VertexId v, TetId first) {
    vertices_.clear();
    tetrahedra_.clear();
    triangles_.clear();
    tetrahedra_.number(first);
    // outer_face is negative as seen from inside.
    const auto slots = [](unsigned of_vertex) {
        const unsigned char* const face = outer_face[of_vertex];
        struct {
            unsigned char slot[3];
        } s = {{face[0], face[2], face[1]}};
        return s;
    };
    const auto place_of = [](const Tetrahedron& t, VertexId of) {
        return (t.v[1] == of ? 1u : 0u) | (t.v[2] == of ? 2u : 0u) | (t.v[3] == of ? 3u : 0u);
    };
    for (std::uint32_t i = 0; i < tetrahedra_.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[tetrahedra_.name(i)];
        const auto s = slots(place_of(t, v));
        triangles_.grow(i + 1);
        triangles_.resize_within_capacity(i + 1);
        LinkTriangle& triangle = triangles_[i];
        for (unsigned k = 0; k < 3; ++k) {
            triangle.corner[k] = vertices_.number(t.v[s.slot[k]]);
            triangle.beyond[k] = tetrahedra_.number(tetrahedron_of(t.n[s.slot[k]]));
        }
    }
}

}  // namespace mgdt
