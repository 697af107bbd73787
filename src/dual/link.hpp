// SPDX-License-Identifier: MIT
// The link of a vertex: the faces opposite it of the tetrahedra at it, a sphere of triangles.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

struct LinkTriangle {
    // Numbers of neighbours of the vertex, in the order that makes the vertex and these a
    // positively oriented tetrahedron.
    std::uint32_t corner[3];
    std::uint32_t beyond[3];  // the triangle across the edge opposite corner k
};

// Numbers 0, 1, ... for names in the order in which they come.
class Numbers {
  public:
    explicit Numbers(Allocator& allocator) : names_(allocator), table_(allocator) {}

    // Of a name that may be new: then the number is the size before.
    MGDT_ALWAYS_INLINE std::uint32_t number(std::uint32_t name) {
        std::uint32_t at = name & mask_;
        for (;; at = (at + 1) & mask_) {
            const Entry& entry = table_[at];
            if (entry.number < first_) break;
            if (entry.name == name) return entry.number - first_;
        }
        const std::uint32_t number = size_;
        if (MGDT_UNLIKELY(4 * std::size_t{number} >= table_.size()))
            return insert_into_larger(name);
        table_[at] = {name, first_ + number};
        names_[number] = name;
        ++size_;
        return number;
    }
    void clear();
    std::uint32_t size() const noexcept { return size_; }
    MGDT_ALWAYS_INLINE std::uint32_t name(std::uint32_t number) const noexcept {
        return names_[number];
    }

  private:
    std::uint32_t insert_into_larger(std::uint32_t name);

    // Open-addressed. Those of earlier names have lesser numbers than any that counts.
    struct Entry {
        std::uint32_t name, number;
    };
    Buffer<std::uint32_t> names_;
    Buffer<Entry> table_;
    std::uint32_t first_ = 1, size_ = 0, mask_ = 0;
};

// One link after the other, in the same memory.
class Link {
  public:
    explicit Link(Allocator& allocator)
        : triangles_(allocator), vertices_(allocator), tetrahedra_(allocator) {}

    // Of v, a vertex of the tetrahedron `first`.
    void gather(const Mesh& mesh, VertexId v, TetId first);

    std::size_t neighbor_count() const noexcept { return vertices_.size(); }
    // By number. One may be the vertex at infinity.
    VertexId neighbor(std::size_t number) const noexcept {
        return vertices_.name(static_cast<std::uint32_t>(number));
    }
    const Buffer<LinkTriangle>& triangles() const noexcept { return triangles_; }
    // The tetrahedron of a triangle.
    TetId tetrahedron(std::size_t triangle) const noexcept {
        return tetrahedra_.name(static_cast<std::uint32_t>(triangle));
    }

  private:
    Buffer<LinkTriangle> triangles_;
    Numbers vertices_, tetrahedra_;
};

}  // namespace mgdt
