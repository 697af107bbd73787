// SPDX-License-Identifier: MIT
#include "mesh/tetrahedron_store.hpp"

#include <cstring>

namespace mgdt {

void TetrahedronStore::drop_spheres() noexcept {
    if (!has_spheres()) return;
    const TetrahedronView<TetrahedronAndSphere> from = view<true>();
    sphere_ = 0;
    const TetrahedronView<TetrahedronAlone> to = view<false>();
    for (std::size_t t = 0; t < size_; ++t) std::memmove(&to[t], &from[t], sizeof(Tetrahedron));
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
    const TetrahedronView<TetrahedronAlone> from = view<false>();
    sphere_ = 1;
    resize_within_capacity(size_);
    const TetrahedronView<TetrahedronAndSphere> to = view<true>();
    for (std::size_t t = size_; t-- > 0;) std::memmove(&to[t], &from[t], sizeof(Tetrahedron));
}

}  // namespace mgdt
