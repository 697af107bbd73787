// SPDX-License-Identifier: MIT
// The handle of a Voronoi diagram behind the C interface.
#pragma once

#include "capi/handle.hpp"
#include "mgdt/mgdt_voronoi.h"
#include "voronoi/voronoi.hpp"

struct mgdt_voronoi : mgdt::Handle<mgdt::Result<mgdt::VoronoiDiagram>> {
    using Handle::Handle;
};
