// SPDX-License-Identifier: MIT
#include "solid/mesh_measures.hpp"

#include "mesh/scale.hpp"
#include "parallel/watched_split.hpp"

namespace mgdt {

void measure_tetrahedra(const SolidMesh& mesh, TetrahedronMeasure measure, Team& team,
                        Allocator& allocator, StageProgress& progress, double* x) {
    ExponentRange range;
    for (const double c : mesh.points) range.add(c);
    const int scale = choose_scale(range, 0);
    Buffer<double> points(allocator);
    points.resize(mesh.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = scaled(mesh.points[i], scale);
    constexpr std::size_t tetrahedra_per_thread = 4096;
    watched_split(team, progress, mesh.tetrahedron_count(), tetrahedra_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for (std::size_t t = begin; t < end; ++t) {
                          const std::uint32_t* const v = mesh.tetrahedra.begin() + 4 * t;
                          const auto point = [&](int k) {
                              return points.begin() + 3 * std::size_t{v[k]};
                          };
                          x[t] = measure_tetrahedron({point(0), point(1), point(2), point(3)},
                                                     scale, measure, allocator);
                      }
                  });
}

}  // namespace mgdt
