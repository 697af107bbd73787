// SPDX-License-Identifier: MIT
#include "cli/peeling.hpp"

#include <algorithm>

namespace mgdt::cli {

std::vector<bool> find_what_stays(const std::vector<double>& radius_ratios,
                                  const std::vector<MeshIndex>& neighbors, double tolerance) {
    std::vector<bool> stays(radius_ratios.size(), true);
    std::vector<std::size_t> exposed;
    const auto take_off = [&](std::size_t t) {
        if (!stays[t] || !(radius_ratios[t] < tolerance)) return;
        stays[t] = false;
        exposed.push_back(t);
    };
    for (std::size_t t = 0; t < stays.size(); ++t) {
        const MeshIndex* beside = neighbors.data() + 4 * t;
        if (std::any_of(beside, beside + 4, [](MeshIndex n) { return n < 0; })) take_off(t);
    }
    while (!exposed.empty()) {
        const MeshIndex* beside = neighbors.data() + 4 * exposed.back();
        exposed.pop_back();
        for (int k = 0; k < 4; ++k)
            if (beside[k] >= 0) take_off(static_cast<std::size_t>(beside[k]));
    }
    return stays;
}

void keep_rows(const std::vector<bool>& stays, std::vector<MeshIndex>& rows) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < stays.size(); ++t) {
        if (!stays[t]) continue;
        std::copy_n(rows.data() + 4 * t, 4, rows.data() + 4 * kept);
        ++kept;
    }
    rows.resize(4 * kept);
}

void keep_neighbors(const std::vector<bool>& stays, std::vector<MeshIndex>& neighbors) {
    std::vector<MeshIndex> numbers(stays.size(), -1);
    MeshIndex kept = 0;
    for (std::size_t t = 0; t < stays.size(); ++t)
        if (stays[t]) numbers[t] = kept++;
    keep_rows(stays, neighbors);
    for (MeshIndex& n : neighbors)
        if (n >= 0) n = numbers[static_cast<std::size_t>(n)];
}

}  // namespace mgdt::cli
