// SPDX-License-Identifier: MIT
// The handle of a mesh behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "domain/domain_mesh.hpp"
#include "mgdt/mgdt_mesh.h"

struct mgdt_mesh : mgdt::Handle<mgdt::Result<mgdt::DomainMesh>> {
    using Handle::Handle;
};
