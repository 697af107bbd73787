// SPDX-License-Identifier: MIT
// The handle of a domain behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "domain/domain.hpp"
#include "mgdt/mgdt_domain.h"

struct mgdt_domain : mgdt::Handle<mgdt::Domain> {
    using Handle::Handle;
};
