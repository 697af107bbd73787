// SPDX-License-Identifier: MIT
#include "core/walk_starts.hpp"

#include <new>

namespace mgdt {

void WalkStarts::clear() noexcept {
    forget_tree();
    last = no_tetrahedron;
}

const LocationTree* WalkStarts::tree(const Mesh& mesh, std::size_t end) const noexcept {
    if (end < LocationTree::smallest || mesh.live_count() == 0) return nullptr;
    try {
        return &tree_.get(mesh, end);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

const LocationTree* WalkStarts::tree_for_insertion(const Mesh& mesh, std::size_t end) noexcept {
    if (!tree_.peek() && lone_steps_ < end / 8) return nullptr;
    lone_steps_ = 0;
    return tree(mesh, end);
}

void WalkStarts::take_new_vertices(const Mesh& mesh, std::size_t begin) noexcept {
    LocationTree* const tree_now = tree_.peek();
    if (!tree_now) return;
    const std::size_t end = mesh.vertices.size();
    // A new tree of all vertices is cheaper than many additions. tree() makes it when it is needed.
    if (end - begin >= begin / 16) {
        forget_tree();
        return;
    }
    tree_now->add(mesh, begin, end);
    if (tree_now->is_outgrown()) {
        forget_tree();
        tree(mesh, end);
    }
}

void WalkStarts::expect_changes(std::size_t vertices) noexcept {
    LocationTree* const tree_now = tree_.peek();
    if (!tree_now) return;
    tree_now->count_changes(vertices);
    if (tree_now->is_stale()) forget_tree();
}

}  // namespace mgdt
