// SPDX-License-Identifier: MIT
// The handle of a domain behind the C interface.
#pragma once

#include "capi/guard.hpp"
#include "domain/domain.hpp"
#include "mgdt/mgdt_domain.h"

struct mgdt_domain : mgdt::HandleBase {
    mgdt_domain(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : domain(alloc, release, user) {}

    bool has_callbacks() const noexcept { return domain.allocator().release_function() != nullptr; }

    mgdt::Domain domain;
};

namespace mgdt {

inline void require_mesh(const Domain& d) {
    if (!d.has_mesh()) fail(MGDT_ERR_NOT_BUILT, "there is no mesh; mgdt_domain_build() makes one");
}

}  // namespace mgdt
