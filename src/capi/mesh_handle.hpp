// SPDX-License-Identifier: MIT
// The handle of a mesh behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "mgdt/mgdt_mesh.h"
#include "solid/solid_mesh.hpp"

struct mgdt_mesh : mgdt::Handle<mgdt::Result<mgdt::SolidMesh>> {
    using Handle::Handle;
};
