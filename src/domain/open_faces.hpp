// SPDX-License-Identifier: MIT
// The faces around the part of a cavity that is not filled yet.
#pragma once

#include "boundary/box_tree.hpp"
#include "mesh/facet_turns.hpp"
#include "platform/hash.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class OpenFaces {
  public:
    // A face, oriented so that (v[0], v[1], v[2], p) is positive for a point p inside of the part
    // that is not filled. The least corner comes first.
    struct Face {
        std::uint32_t v[3];
        std::uint32_t behind;  // the code of the face on the other side, or what the caller chooses
        std::uint32_t facet;   // the facet that the face is a part of, or no_index
        BoundingBox box;
        bool is_open;
    };

    explicit OpenFaces(Allocator& allocator) : faces_(allocator), table_(allocator) {}

    void clear() {
        faces_.clear();
        table_.clear(0);
    }
    // The number of faces that were added, closed ones included.
    std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(faces_.size()); }
    const Face& operator[](std::uint32_t i) const noexcept { return faces_[i]; }

    // Adds an open face. No face with the same corners in this orientation was added before.
    std::uint32_t add(Face face) {
        turn_to_least(face.v);
        face.is_open = true;
        table_.reserve(faces_.size() + 1);
        faces_.push_back(face);
        return table_.number(hash_of_words(face.v[0], face.v[1], face.v[2]),
                             [](std::uint32_t) { return false; });
    }
    void close(std::uint32_t i) noexcept { faces_[i].is_open = false; }
    // The open face with these corners, seen from its other side; or `no_index`.
    std::uint32_t find_opposite(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
        std::uint32_t v[3] = {a, c, b};
        turn_to_least(v);
        return table_.find(hash_of_words(v[0], v[1], v[2]), [&](std::uint32_t i) {
            const Face& f = faces_[i];
            return f.is_open && f.v[0] == v[0] && f.v[1] == v[1] && f.v[2] == v[2];
        });
    }

  private:
    Buffer<Face> faces_;
    NumberTable table_;
};

}  // namespace mgdt
