// SPDX-License-Identifier: MIT
#include "periodic/periodic_cells.hpp"

namespace mgdt {

void export_periodic_measures(const Periodic& periodic, Measure measure, StageProgress& progress,
                              double* out) {
    if (measure == Measure::centroid) measure = Measure::centroid_offset;
    const Halo& halo = periodic.halo();
    const std::size_t width = width_of(measure);
    Team team = team_of_halo(periodic);
    const MeshView view = view_of_halo(periodic, team);
    const Region region(view.allocator, 0, nullptr, view.mesh, view.base);
    Buffer<double> all(view.allocator, width * halo.point_count());
    export_measures(view, region, measure, halo.point_count(), progress, all.begin());
    const unsigned powers = measure == Measure::volume            ? 3
                            : measure == Measure::area            ? 2
                            : measure == Measure::centroid_offset ? 1
                                                                  : 0;
    for (std::size_t i = 0; i < width * halo.own_count(); ++i)
        out[i] = periodic.to_callers(all[i], powers);
}

}  // namespace mgdt
