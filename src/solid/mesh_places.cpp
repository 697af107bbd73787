// SPDX-License-Identifier: MIT
#include "solid/mesh_places.hpp"

#include <algorithm>
#include <limits>

#include "order/curve_split.hpp"
#include "predicates/barycentric.hpp"

namespace mgdt {
namespace {

// Calls found(i, tetrahedron, weights) for each place.
template <class Found>
void find_each(const PlaceFinder& finder, Team& team, const PointSet& places, Allocator& allocator,
               const StageProgress& progress, const Found& found) {
    constexpr std::size_t places_per_thread = 1024;
    const auto visit = [&](std::size_t i, std::uint32_t near) {
        double weights[4] = {};
        const std::uint32_t t = finder.find(places.axis[0] + 3 * i, near, weights);
        found(i, t, weights);
        return t;
    };
    if (places.size == 1) {
        visit(0, no_index);
        return;
    }
    split_along_curve(
        team, places, allocator, places_per_thread, progress,
        [&](std::size_t count, const auto& index, StageProgress& of_block, unsigned member) {
            std::uint32_t near = no_index;
            for (std::size_t k = 0; k < count; ++k) {
                of_block.step(k, 0, count, member);
                near = visit(index(k), near);
            }
        });
}

}  // namespace

std::uint32_t PlaceFinder::find(const double* place, std::uint32_t near,
                                double (&weights)[4]) const {
    if (const std::uint32_t t = inside.locate(place, near); t != no_index) {
        const std::uint32_t* const v = mesh.tetrahedra.begin() + 4 * std::size_t{t};
        const double* const p[4] = {mesh.points.begin() + 3 * std::size_t{v[0]},
                                    mesh.points.begin() + 3 * std::size_t{v[1]},
                                    mesh.points.begin() + 3 * std::size_t{v[2]},
                                    mesh.points.begin() + 3 * std::size_t{v[3]}};
        barycentric_weights(p, place, weights);
        return t;
    }
    if (!outside) return no_index;
    const BoundaryPlaces::Place nearest = outside->nearest(place);
    std::copy_n(nearest.weights, 4, weights);
    return nearest.tetrahedron;
}

template <class Int>
void locate_places(const PlaceFinder& finder, Team& team, const PointSet& places,
                   Allocator& allocator, const StageProgress& progress, Int base, Int* tetrahedra,
                   double* weights) {
    find_each(finder, team, places, allocator, progress,
              [&](std::size_t i, std::uint32_t t, const double(&w)[4]) {
                  tetrahedra[i] = (t == no_index ? Int{-1} : static_cast<Int>(t)) + base;
                  if (weights) std::copy_n(w, 4, weights + 4 * i);
              });
}
template void locate_places(const PlaceFinder&, Team&, const PointSet&, Allocator&,
                            const StageProgress&, std::int64_t, std::int64_t*, double*);
template void locate_places(const PlaceFinder&, Team&, const PointSet&, Allocator&,
                            const StageProgress&, std::int32_t, std::int32_t*, double*);

void interpolate_places(const PlaceFinder& finder, Team& team, const PointSet& places,
                        Allocator& allocator, const StageProgress& progress, std::size_t fields,
                        const double* values, double* out) {
    find_each(finder, team, places, allocator, progress,
              [&](std::size_t i, std::uint32_t t, const double(&w)[4]) {
                  double* const to = out + fields * i;
                  if (t == no_index) {
                      std::fill_n(to, fields, std::numeric_limits<double>::quiet_NaN());
                      return;
                  }
                  const std::uint32_t* const v =
                      finder.mesh.tetrahedra.begin() + 4 * std::size_t{t};
                  for (std::size_t f = 0; f < fields; ++f) {
                      double sum = 0;
                      // A corner without weight has no say, even if its value is not finite.
                      for (int k = 0; k < 4; ++k)
                          if (w[k] != 0) sum += w[k] * values[fields * v[k] + f];
                      to[f] = sum;
                  }
              });
}

}  // namespace mgdt
