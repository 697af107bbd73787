// SPDX-License-Identifier: MIT
// The handle of a periodic box behind the C interface.
#pragma once

#include "capi/guard.hpp"
#include "mgdt/mgdt_periodic.h"
#include "periodic/periodic.hpp"

struct mgdt_periodic : mgdt::HandleBase {
    mgdt_periodic(unsigned dimensions, const double* vectors, mgdt_alloc_fn alloc,
                  mgdt_free_fn release, void* user)
        : box(dimensions, vectors, alloc, release, user) {}

    bool has_callbacks() const noexcept { return box.allocator().release_function() != nullptr; }

    mgdt::Periodic box;
};

namespace mgdt {

inline void require_triangulation(const Periodic& p) {
    if (!p.has_triangulation())
        fail(MGDT_ERR_NOT_BUILT, "there is no triangulation; mgdt_periodic_build() makes one");
}

}  // namespace mgdt
