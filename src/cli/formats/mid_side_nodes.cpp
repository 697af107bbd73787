// SPDX-License-Identifier: MIT
#include "cli/formats/mid_side_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mgdt::cli {

void leave_out_mid_side_nodes(Mesh& mesh) {
    if (mesh.mid_side.empty()) return;
    constexpr MeshIndex left_out = -1;
    std::vector<MeshIndex> number(mesh.point_count(), 0);
    for (const MeshIndex v : mesh.mid_side) number[static_cast<std::size_t>(v)] = left_out;
    for (const MeshIndex v : mesh.tetrahedra) number[static_cast<std::size_t>(v)] = 0;
    mesh.mid_side = {};

    std::size_t kept = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == left_out) continue;
        std::copy_n(mesh.points.data() + 3 * i, 3, mesh.points.data() + 3 * kept);
        for (Field& f : mesh.fields) {
            std::copy_n(f.values.data() + f.components * i, f.components,
                        f.values.data() + f.components * kept);
        }
        number[i] = static_cast<MeshIndex>(kept++);
    }
    mesh.mid_side_nodes = number.size() - kept;
    mesh.points.resize(3 * kept);
    for (Field& f : mesh.fields) f.values.resize(f.components * kept);
    for (MeshIndex& v : mesh.tetrahedra) v = number[static_cast<std::size_t>(v)];
}

std::string describe_mid_side_nodes(std::size_t n) {
    return n == 0 ? "" : fmt::format("{} mid-side node{} left out", n, n == 1 ? "" : "s");
}

}  // namespace mgdt::cli
