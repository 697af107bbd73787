// SPDX-License-Identifier: MIT
// Decides where walks start: at the last insertion, or near a vertex that a location tree finds.
#pragma once

#include <cstdint>

#include "platform/cached.hpp"
#include "query/location_tree.hpp"

namespace mgdt {

class WalkStarts {
  public:
    explicit WalkStarts(Allocator& allocator) noexcept : tree_(allocator) {}

    // Forgets the tree and the last insertion.
    void clear() noexcept;

    // The tree over the vertices before `end`, which is made if there is none. Returns nullptr for
    // a small mesh, or if memory does not suffice; walks are longer then.
    const LocationTree* tree(const Mesh& mesh, std::size_t end) const noexcept;
    // The tree for the first point of a batch. The tree is made once walks without it have cost as
    // much as making it would; until then the function returns nullptr.
    const LocationTree* tree_for_insertion(const Mesh& mesh, std::size_t end) noexcept;
    // The tree if it is there, else nullptr.
    const LocationTree* tree_if_made() const noexcept { return tree_.peek(); }
    // Counts the steps of the first walk of a batch.
    void count_lone_steps(std::uint64_t steps) noexcept { lone_steps_ += steps; }

    // Adds the new vertices from `begin` on to the tree, or forgets the tree if they are many.
    void take_new_vertices(const Mesh& mesh, std::size_t begin) noexcept;
    // Counts vertices that are about to be removed or moved. Forgets the tree if they are many.
    void expect_changes(std::size_t vertices) noexcept;
    void forget_tree() noexcept { tree_.forget(); }

    TetId last = no_tetrahedron;  // a tetrahedron of the last insertion

  private:
    mutable Cached<LocationTree> tree_;
    std::uint64_t lone_steps_ = 0;  // the steps of the first walks of batches without a tree
};

}  // namespace mgdt
