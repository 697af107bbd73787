// SPDX-License-Identifier: MIT
#include "cli/periodic_box.hpp"

#include <fmt/core.h>

#include <string_view>
#include <vector>

#include "cli/errors.hpp"
#include "cli/formats/number.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

FileBox parse_box(const std::string& text) {
    constexpr std::string_view separators = " \t,;";
    std::vector<double> numbers;
    std::string_view rest = text;
    bool are_numbers = true;
    while (are_numbers) {
        const std::size_t begin = rest.find_first_not_of(separators);
        if (begin == std::string_view::npos) break;
        rest.remove_prefix(begin);
        const std::size_t end = std::min(rest.find_first_of(separators), rest.size());
        are_numbers = parse_number(rest.substr(0, end), numbers.emplace_back()) == NumberStatus::ok;
        rest.remove_prefix(end);
    }
    FileBox box;
    if (are_numbers && numbers.size() == 3) {
        for (std::size_t k = 0; k < 3; ++k) box.vectors[4 * k] = numbers[k];
    } else if (are_numbers && numbers.size() == 9) {
        std::copy(numbers.begin(), numbers.end(), box.vectors.begin());
    } else {
        throw Error(
            exit_usage,
            fmt::format("--box is {}; three lengths or the nine numbers of three vectors are "
                        "needed, or file for the box in the file; bounds of cells that do "
                        "not repeat are --bounds",
                        quote(text)));
    }
    return box;
}

std::array<bool, 3> parse_directions(const std::string& text) {
    std::array<bool, 3> repeats = {};
    for (const char c : text) {
        if (c < 'x' || c > 'z' || repeats[static_cast<std::size_t>(c - 'x')])
            throw Error(exit_usage, fmt::format("--periodic is {}; it has to be some of x, y and z",
                                                quote(text)));
        repeats[static_cast<std::size_t>(c - 'x')] = true;
    }
    return repeats;
}

// The vectors that repeat.
std::vector<Point> vectors_of(const PeriodicOptions& options, const Mesh& mesh,
                              const std::string& name) {
    if (options.box == "file" && !mesh.box)
        throw Error(exit_input, fmt::format("{}: the file has no box; give it with --box", name));
    FileBox box = options.box == "file" ? *mesh.box : parse_box(options.box);
    if (!options.directions.empty()) box.repeats = parse_directions(options.directions);
    std::vector<Point> vectors;
    for (std::size_t k = 0; k < 3; ++k)
        if (box.repeats[k])
            vectors.push_back({box.vectors[3 * k], box.vectors[3 * k + 1], box.vectors[3 * k + 2]});
    if (vectors.empty())
        throw Error(exit_input,
                    fmt::format("{}: the box of the file repeats in no direction; choose "
                                "directions with --periodic",
                                name));
    return vectors;
}

}  // namespace

Periodic make_periodic(const PeriodicOptions& options, const TriangulationOptions& settings,
                       const Mesh& mesh, const std::string& name) {
    const std::vector<Point> vectors = vectors_of(options, mesh, name);
    Periodic box(nullptr);
    try {
        box = Periodic(vectors);
    } catch (const mgdt::Error& e) {
        const bool is_bad =
            e.status() == MGDT_ERR_INVALID_ARGUMENT || e.status() == MGDT_ERR_NOT_FINITE;
        throw Error(is_bad ? exit_input : exit_internal, fmt::format("{}: {}", name, e.what()));
    }
    Progress progress("triangulating", settings.quiet);
    try {
        box.set_option(PeriodicOption::threads, settings.threads);
        box.set_option(PeriodicOption::memory_limit,
                       static_cast<std::int64_t>(settings.memory_limit));
        box.insert(mgdt::Points(mesh.points.data(), mesh.point_count()));
        box.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
        box.build();
        box.clear_progress();
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_INVALID_ARGUMENT)
            throw Error(exit_input, fmt::format("{}: {}", name, e.what()));
        rethrow_failure(name, box.last_error());
    } catch (...) {
        rethrow_failure(name, box.last_error());
    }
    return box;
}

}  // namespace mgdt::cli
