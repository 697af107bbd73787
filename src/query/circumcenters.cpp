// SPDX-License-Identifier: MIT
// Writes circumcentres and the squares of radii for the caller.
#include "parallel/watched_split.hpp"
#include "predicates/circumcenter.hpp"
#include "query/export.hpp"

namespace mgdt {

void export_circumcenters(const MeshView& view, StageProgress& progress, double* xyz,
                          double* radius2) {
    const Mesh& mesh = view.mesh;
    const Numbering& numbering = *view.numbering;
    constexpr std::size_t stretches_per_thread = 64, ahead = 16;
    watched_split(view.team, progress, numbering.stretches(), stretches_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      numbering.for_each(begin, end, [&](TetId id, std::size_t number) {
                          const Tetrahedron& t = mesh.tetrahedra[id];
                          mesh.tetrahedra.prefetch(id + ahead);
                          const Circumcenter c =
                              circumcenter({mesh.point(t.v[0]), mesh.point(t.v[1]),
                                            mesh.point(t.v[2]), mesh.point(t.v[3])},
                                           mesh.scale);
                          for (std::size_t k = 0; k < 3; ++k) xyz[3 * number + k] = c.x[k];
                          if (radius2) radius2[number] = c.radius2;
                      });
                  });
}

}  // namespace mgdt
