// SPDX-License-Identifier: MIT
// Where walks start: at the last insertion, or where a tree of locations says.
#pragma once

#include <cstdint>

#include "platform/cached.hpp"
#include "query/location_tree.hpp"

namespace mgdt {

class WalkStarts {
  public:
    explicit WalkStarts(Allocator& allocator) noexcept : tree_(allocator) {}

    // Nothing was inserted yet.
    void clear() noexcept;

    // The tree over the vertices before `end`, made if there is none. nullptr for a small mesh, or
    // if memory lacks: walks are longer then.
    const LocationTree* tree(const Mesh& mesh, std::size_t end) const noexcept;
    // The tree for the first point of a batch. It is made once walks without it have taken as many
    // steps as making it would; until then nullptr.
    const LocationTree* tree_for_insertion(const Mesh& mesh, std::size_t end) noexcept;
    // The tree if it is there, else nullptr.
    const LocationTree* tree_if_made() const noexcept { return tree_.peek(); }
    // The first walk of a batch took this many steps.
    void count_lone_steps(std::uint64_t steps) noexcept { lone_steps_ += steps; }

    // Vertices from `begin` on have come in.
    void take_new_vertices(const Mesh& mesh, std::size_t begin) noexcept;
    // This many vertices are about to leave or to move.
    void expect_changes(std::size_t vertices) noexcept;
    void forget_tree() noexcept { tree_.forget(); }

    TetId last = no_tetrahedron;  // of the last insertion

  private:
    mutable Cached<LocationTree> tree_;
    std::uint64_t lone_steps_ = 0;  // of the first walks of batches since there was no tree
};

}  // namespace mgdt
