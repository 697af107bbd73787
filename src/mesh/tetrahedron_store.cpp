// SPDX-License-Identifier: MIT
#include "mesh/tetrahedron_store.hpp"

#include <cstring>

namespace mgdt {

void TetrahedronStore::drop_spheres() noexcept {
    if (!has_spheres()) return;
    const auto from = view<true>();
    const auto to = view<false>();
    for (std::size_t t = 0; t < size_; ++t) std::memmove(&to[t], &from[t], sizeof(Tetrahedron));
    sphere_ = 0;
    resize_within_capacity(size_);
    try {
        pieces_.set_capacity(capacity_ * stride());
    } catch (const std::bad_alloc&) {
        // A smaller block was refused: keep the larger one.
    }
}

void TetrahedronStore::make_room_for_spheres() {
    if (has_spheres()) return;
    pieces_.reserve(capacity_ * (stride() + 1));
    sphere_ = 1;
    resize_within_capacity(size_);
    const auto from = view<false>();
    const auto to = view<true>();
    for (std::size_t t = size_; t-- > 0;) std::memmove(&to[t], &from[t], sizeof(Tetrahedron));
}

}  // namespace mgdt
