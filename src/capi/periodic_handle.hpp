// SPDX-License-Identifier: MIT
// The handle of a periodic box behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "mgdt/mgdt_periodic.h"
#include "periodic/periodic.hpp"

struct mgdt_periodic : mgdt::Handle<mgdt::Periodic> {
    using Handle::Handle;
};

namespace mgdt {

inline void require_triangulation(const Periodic& p) {
    if (!p.has_triangulation())
        fail(MGDT_ERR_NOT_BUILT, "there is no triangulation; mgdt_periodic_build() makes one");
}

}  // namespace mgdt
