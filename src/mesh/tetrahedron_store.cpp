// SPDX-License-Identifier: MIT
#include "mesh/tetrahedron_store.hpp"

namespace mgdt {

void TetrahedronStore::drop_spheres() noexcept {
    if (shift_ == 0) return;
    for (std::size_t t = 0; t < size_; ++t) lines_[t].tetrahedron = lines_[2 * t].tetrahedron;
    shift_ = 0;
    lines_.resize_within_capacity(size_);
    try {
        lines_.set_capacity(capacity_);
    } catch (const std::bad_alloc&) {
        // A smaller block was refused: keep the larger one.
    }
}

void TetrahedronStore::make_room_for_spheres() {
    if (shift_ == 1) return;
    lines_.reserve(2 * capacity_);
    shift_ = 1;
    resize_within_capacity(size_);
    for (std::size_t t = size_; t-- > 1;) lines_[2 * t].tetrahedron = lines_[t].tetrahedron;
}

}  // namespace mgdt
