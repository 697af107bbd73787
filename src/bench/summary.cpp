// SPDX-License-Identifier: MIT
#include "bench/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace mgdt::cli::bench {
namespace {

using SetKey = std::tuple<std::string, std::size_t, std::uint64_t>;

SetKey set_of(const Row& row) {
    return {row.distribution, row.points, row.seed};
}

bool is_peer(const Row& row) {
    return row.library != "mgdt";
}

Median median_of(const std::vector<const Row*>& runs) {
    Median result;
    result.row = *runs.front();
    result.runs = static_cast<int>(runs.size());
    std::array<std::vector<double>, figure_count> values;
    int good = 0;
    for (const Row* run : runs) {
        if (!run->ok()) continue;
        if (good == 0) result.row = *run;
        ++good;
        for (std::size_t i = 0; i < figure_count; ++i) {
            if (run->figures[i]) values[i].push_back(*run->figures[i]);
        }
    }
    result.row.run = good;
    for (std::size_t i = 0; i < figure_count; ++i) {
        if (!values[i].empty()) result.row.figures[i] = median(values[i]);
    }
    return result;
}

}  // namespace

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<Median> medians(const std::vector<Row>& rows) {
    std::vector<std::vector<const Row*>> groups;
    std::map<std::string, std::size_t> group_of;
    for (const Row& row : rows) {
        const auto [group, is_new] = group_of.emplace(row.subject(), groups.size());
        if (is_new) groups.emplace_back();
        groups[group->second].push_back(&row);
    }
    std::vector<Median> result;
    result.reserve(groups.size());
    for (const std::vector<const Row*>& group : groups) result.push_back(median_of(group));

    std::map<SetKey, std::map<std::string, double>> peers;
    std::map<SetKey, double> counts;
    for (const Median& m : result) {
        if (!m.row.ok()) continue;
        const auto& seconds = m.row.figures[total_seconds];
        const auto& count = m.row.figures[tetrahedra];
        if (is_peer(m.row) && seconds) peers[set_of(m.row)][m.row.library] = *seconds;
        if (!is_peer(m.row) && count) counts.emplace(set_of(m.row), *count);
    }
    for (Median& m : result) {
        if (!m.row.ok()) continue;
        const auto& seconds = m.row.figures[total_seconds];
        const auto& count = m.row.figures[tetrahedra];
        if (is_peer(m.row)) {
            const auto ours = counts.find(set_of(m.row));
            if (ours != counts.end() && count && *count != ours->second) {
                m.other_count = ours->second;
            }
        } else if (seconds && *seconds > 0) {
            for (const auto& [peer, theirs] : peers[set_of(m.row)]) {
                m.ratios[peer] = theirs / *seconds;
            }
        }
    }
    return result;
}

std::vector<Comparison> comparisons(const std::vector<Median>& medians) {
    std::vector<Comparison> result;
    for (const Median& m : medians) {
        for (const auto& [peer, ratio] : m.ratios) {
            const auto same =
                std::find_if(result.begin(), result.end(), [&, name = &peer](const Comparison& c) {
                    return c.scheme == m.row.scheme && c.threads == m.row.threads &&
                           c.peer == *name;
                });
            if (same == result.end()) {
                result.push_back({m.row.scheme, m.row.threads, peer, std::log(ratio), ratio, 1});
            } else {
                same->geometric_mean += std::log(ratio);
                same->least = std::min(same->least, ratio);
                ++same->sets;
            }
        }
    }
    for (Comparison& c : result) {
        c.geometric_mean = std::exp(c.geometric_mean / static_cast<double>(c.sets));
    }
    return result;
}

std::string disagreement(const std::vector<Row>& rows) {
    std::map<SetKey, const Row*> first;
    for (const Row& row : rows) {
        const auto& count = row.figures[tetrahedra];
        if (is_peer(row) || !row.ok() || !count) continue;
        const Row& other = *first.emplace(set_of(row), &row).first->second;
        if (*count != *other.figures[tetrahedra]) {
            return fmt::format("{} {}: {} tetrahedra with {} and {} with {}", row.distribution,
                               row.points, *other.figures[tetrahedra], other.scheme, *count,
                               row.scheme);
        }
    }
    return "";
}

}  // namespace mgdt::cli::bench
