// SPDX-License-Identifier: MIT
#include "solid/mesh_locator.hpp"

#include <algorithm>

#include "mesh/tetrahedron.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

Buffer<BoundingBox> boxes_of(Allocator& allocator, const SolidMesh& mesh) {
    Buffer<BoundingBox> boxes(allocator, mesh.tetrahedron_count());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        const auto corner = [&](std::size_t i) {
            return mesh.points.begin() + 3 * std::size_t{mesh.tetrahedra[4 * t + i]};
        };
        boxes[t] = BoundingBox(corner(0));
        for (std::size_t i = 1; i < 4; ++i) boxes[t].include(corner(i));
    }
    return boxes;
}

}  // namespace

MeshLocator::MeshLocator(Allocator& allocator, const SolidMesh& mesh, const StopRequest& stop)
    : mesh_(mesh), boxes_(boxes_of(allocator, mesh)), tree_(allocator, boxes_, stop) {}

// Walks some steps towards a place. Returns the tetrahedron that has it inside, if the walk ends
// there: no other one contains the place then.
std::uint32_t MeshLocator::walk(const double* place, std::uint32_t from) const {
    constexpr int most_steps = 16;
    std::uint32_t t = from, last = no_index;
    for (int step = 0; step < most_steps && t != no_index; ++step) {
        const auto corner = [&](unsigned i) {
            return mesh_.points.begin() + 3 * std::size_t{mesh_.tetrahedra[4 * std::size_t{t} + i]};
        };
        bool is_inside = true;
        std::uint32_t next = no_index;
        for (unsigned i = 0; i < 4 && next == no_index; ++i) {
            const std::uint32_t behind = mesh_.neighbors[4 * std::size_t{t} + i];
            if (behind == last && behind != no_index) continue;
            const unsigned char* const f = outer_face[i];
            const int sign = orientation(place, corner(f[0]), corner(f[1]), corner(f[2]));
            if (sign >= 0) is_inside = false;
            if (sign > 0) {
                if (behind == no_index) return no_index;
                next = behind;
            }
        }
        if (next == no_index)
            return is_inside && mesh_.side(mesh_.points, t, place) > 0 ? t : no_index;
        last = t;
        t = next;
    }
    return no_index;
}

std::uint32_t MeshLocator::locate(const double* place, std::uint32_t near) const {
    if (const std::uint32_t t = walk(place, near); t != no_index) return t;
    std::uint32_t first = no_index;
    tree_.for_each_at(BoundingBox(place), [&](std::uint32_t t) {
        if (t < first && mesh_.side(mesh_.points, t, place) >= 0) first = t;
    });
    return first;
}

}  // namespace mgdt
