// SPDX-License-Identifier: MIT
#include "bench/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "cli/errors.hpp"

namespace mgdt::cli::bench {
namespace {

struct Column {
    Figure figure;
    const char* title;
    int width, decimals;
};

constexpr Column columns[] = {
    {walked, "NP", 7, 2},
    {removed, "NR", 7, 2},
    {created, "created", 8, 2},
    {order_seconds, "order s", 9, 4},
    {insert_seconds, "insert s", 9, 4},
    {total_seconds, "total s", 9, 4},
    {user_seconds, "user s", 9, 4},
    {alone_percent, "alone %", 8, 2},
    {bytes_per_point, "bytes/pt", 9, 0},
};

constexpr int ratio_width = 12;

std::string heading() {
    std::string line = fmt::format("{:<15} {:>9} {:<24} {:>7} {:>4}", "distribution", "points",
                                   "scheme", "threads", "run");
    for (const Column& c : columns) line += fmt::format(" {:>{}}", c.title, c.width);
    return line;
}

// `run` is the number of the run, or the number of runs.
std::string cells(const Row& row, const std::string& run) {
    std::string line = fmt::format("{:<15} {:>9} {:<24} {:>7} {:>4}", row.distribution, row.points,
                                   row.contender(), row.threads, run);
    if (!row.ok()) return line + "  " + printable(row.status);
    for (const Column& c : columns) {
        const std::optional<double>& value = row.figures[c.figure];
        line += " " + (value ? fmt::format("{:>{}.{}f}", *value, c.width, c.decimals)
                             : fmt::format("{:>{}}", "-", c.width));
    }
    return line;
}

void print_failures(std::FILE* out, const std::vector<Median>& medians) {
    for (const Median& m : medians) {
        if (m.row.run == m.runs) continue;
        fmt::print(out, "failed: {} on {} {}, {} of {} runs{}\n", m.row.contender(),
                   m.row.distribution, m.row.points, m.runs - m.row.run, m.runs,
                   m.row.ok() ? "" : ": " + printable(m.row.status));
    }
}

}  // namespace

void print_heading(std::FILE* out) {
    fmt::print(out, "{}\n", heading());
}

void print_row(std::FILE* out, const Row& row) {
    fmt::print(out, "{}\n", cells(row, fmt::format("{}", row.run)));
    std::fflush(out);
}

void print_summary(std::FILE* out, const std::vector<Median>& medians,
                   const std::vector<std::string>& peers) {
    fmt::print(out, "\nmedians; run is the number of runs\n{}", heading());
    for (const std::string& peer : peers) {
        fmt::print(out, " {:>{}}", peer + "/mgdt", ratio_width);
    }
    fmt::print(out, "\n");
    for (const Median& m : medians) {
        std::string line = cells(m.row, fmt::format("{}", m.row.run));
        if (m.row.ok() && m.row.library == "mgdt") {
            for (const std::string& peer : peers) {
                const auto ratio = m.ratios.find(peer);
                line += ratio == m.ratios.end()
                            ? fmt::format(" {:>{}}", "-", ratio_width)
                            : fmt::format(" {:>{}.2f}", ratio->second, ratio_width);
            }
        }
        fmt::print(out, "{}\n", line);
    }
    for (const Comparison& c : comparisons(medians)) {
        fmt::print(out, "{}/mgdt, {}, {} thread{}: geometric mean {:.2f}, least {:.2f}, {} set{}\n",
                   c.peer, c.scheme, c.threads, c.threads == 1 ? "" : "s", c.geometric_mean,
                   c.least, c.sets, c.sets == 1 ? "" : "s");
    }
    print_failures(out, medians);
    for (const Median& m : medians) {
        if (!m.other_count) continue;
        fmt::print(out, "differs: {} has {} tetrahedra on {} {}, mgdt {}\n", m.row.library,
                   *m.row.figures[tetrahedra], m.row.distribution, m.row.points, *m.other_count);
    }
}

}  // namespace mgdt::cli::bench
