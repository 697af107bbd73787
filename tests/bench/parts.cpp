// SPDX-License-Identifier: MIT
// Measures a triangulation in parts, all of them in one process one after another: the points that
// a part has of others, the balance, and the processor time beside one triangulation of all points.
//
//   parts [points of a part [parts,... [distribution...]]]
//
// White-box: it calls the library's own objects. "received" is the points of others, "needed" those
// among them that are neighbours of own ones, in percent of all points; "from" how many parts a
// part received some from, in the mean; "worst" the most that a part received over their mean,
// "own" the same of own points; "time" the processor time of all parts, over that of one
// triangulation.
#include "parts/parts.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "parts/in_process.hpp"

namespace {

void run(const std::string& name, std::size_t each, mgdt::PartId parts) {
    const std::vector<double> xyz = mgdt::cli::generate(name, each * parts, {});
    const std::size_t n = xyz.size() / 3;
    std::vector<mgdt::GivenPoints> given;
    for (mgdt::PartId p = 0; p < parts; ++p) {
        const std::size_t begin = n * p / parts, end = n * (p + std::size_t{1}) / parts;
        given.push_back({xyz.data() + 3 * begin, end - begin});
    }
    const double of_one = bench::processor_seconds([&] {
        mgdt::Triangulation t(nullptr, nullptr, nullptr);
        const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
        t.insert(n, axis, 3);
    });
    mgdt::InProcess transport(parts);
    mgdt::Collective collective(transport);
    mgdt::StopFlag cancelled;
    mgdt::StageProgress progress(mgdt::CallSettings(), cancelled);
    mgdt::Parts all(collective, nullptr, nullptr, nullptr);
    const double of_parts = bench::processor_seconds(
        [&] { collective.run([&] { all.build(given.data(), nullptr, progress); }); });
    std::size_t received = 0, needed = 0, senders = 0, most_received = 0, most_own = 0;
    for (mgdt::PartId p = 0; p < parts; ++p) {
        const mgdt::Part& part = all.local(p);
        const std::size_t own = part.own_count(), others = part.point_count() - own;
        std::vector<bool> is_needed(part.point_count(), false);
        part.each_tetrahedron([&](mgdt::TetId, const std::uint32_t(&v)[4], unsigned, bool) {
            for (const std::uint32_t i : v) is_needed[i] = true;
        });
        needed += static_cast<std::size_t>(std::count(
            is_needed.begin() + static_cast<std::ptrdiff_t>(own), is_needed.end(), true));
        received += others;
        std::vector<bool> is_sender(parts, false);
        for (std::size_t i = own; i < part.point_count(); ++i) {
            const auto& first = all.first_vertices();
            const auto after =
                std::upper_bound(first.begin(), first.end(), part.points()[i].number);
            is_sender[static_cast<std::size_t>(after - first.begin()) - 1] = true;
        }
        senders += static_cast<std::size_t>(std::count(is_sender.begin(), is_sender.end(), true));
        most_received = std::max(most_received, others);
        most_own = std::max(most_own, own);
    }
    const auto all_points = static_cast<double>(n);
    std::printf(
        "%-10s %5u %9zu %8.1f%% %8.1f%% %8.1f %8.2f %8.3f %8.2f\n", name.c_str(), parts, each,
        100 * static_cast<double>(received) / all_points,
        100 * static_cast<double>(needed) / all_points, static_cast<double>(senders) / parts,
        static_cast<double>(most_received) * parts / std::max(1.0, static_cast<double>(received)),
        static_cast<double>(most_own) * parts / all_points, of_parts / of_one);
}

}  // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const auto each = static_cast<std::size_t>(std::strtod(argc > 1 ? argv[1] : "60000", nullptr));
    std::vector<mgdt::PartId> numbers;
    for (const char* at = argc > 2 ? argv[2] : "8"; *at != '\0';) {
        char* end = nullptr;
        numbers.push_back(static_cast<mgdt::PartId>(std::strtoul(at, &end, 10)));
        at = *end == ',' ? end + 1 : end;
    }
    std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
    if (names.empty())
        names = {"uniform", "line",   "diagonal", "ellipse", "spiral",
                 "cluster", "galaxy", "lattice",  "sphere"};
    std::printf("%-10s %5s %9s %9s %9s %8s %8s %8s %8s\n", "", "parts", "points", "received",
                "needed", "from", "worst", "own", "time");
    for (const std::string& name : names)
        for (const mgdt::PartId parts : numbers) run(name, each, parts);
    return 0;
}
