// SPDX-License-Identifier: MIT
// The handle of a domain behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "domain/domain.hpp"
#include "mgdt/mgdt_domain.h"

struct mgdt_domain : mgdt::Handle<mgdt::Domain> {
    using Handle::Handle;
};

namespace mgdt {

inline void require_mesh(const Domain& d) {
    if (!d.has_mesh()) fail(MGDT_ERR_NOT_BUILT, "there is no mesh; mgdt_domain_build() makes one");
}

}  // namespace mgdt
