// SPDX-License-Identifier: MIT
#include "cli/unused_points.hpp"

#include <algorithm>

namespace mgdt::cli {

std::vector<MeshIndex> take_out_unused_points(Mesh& mesh) {
    std::vector<MeshIndex> numbers(mesh.point_count(), mesh.tetrahedra.empty() ? 0 : -1);
    for (const MeshIndex v : mesh.tetrahedra) numbers[static_cast<std::size_t>(v)] = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < 0) continue;
        std::copy_n(mesh.points.data() + 3 * i, 3, mesh.points.data() + 3 * kept);
        numbers[i] = static_cast<MeshIndex>(kept++);
    }
    mesh.points.resize(3 * kept);
    for (std::vector<MeshIndex>* const corners : {&mesh.tetrahedra, &mesh.faces.corners})
        for (MeshIndex& v : *corners) v = numbers[static_cast<std::size_t>(v)];
    return numbers;
}

}  // namespace mgdt::cli
