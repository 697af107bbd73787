// SPDX-License-Identifier: MIT
// Measures of Voronoi cells.
#include "capi/cell_view.hpp"
#include "capi/measure.hpp"
#include "dual/measures.hpp"

using namespace mgdt;

extern "C" mgdt_status mgdt_get_cell_measures(const mgdt_triangulation* t, int32_t measure,
                                              int64_t n_planes, const double* planes,
                                              int64_t capacity, double* x) {
    return guard_long(t, [&](StageProgress& progress) {
        const Measure m = measure_of(measure);
        const std::size_t n = require_planes(n_planes, planes);
        if (n == 0) require_space(t, "cells");
        const auto points = static_cast<std::size_t>(point_count(t->object));
        const std::size_t count = width_of(m) * points;
        if (count > 0) require_pointer(x, "the output array");
        require_capacity(capacity, count, "the output array");
        if (t->object.vertex_count() == 0) return std::fill_n(x, count, 0.0), void();
        with_cell_view(t, t->object.allocator(), n, planes,
                       [&](const MeshView& view, const Region& region, std::size_t) {
                           export_measures(view, region, m, points, progress, x);
                       });
    });
}
