// SPDX-License-Identifier: MIT
#include "cli/program_triangulation.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

// Calls `set` to pass an option to the library. Names the option in messages.
template <class Set>
void set_option(const Triangulation& t, const char* option, const Set& set) {
    try {
        set();
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_INVALID_ARGUMENT)
            throw Error(exit_usage, fmt::format("{}: {}", option, e.what()));
        rethrow_failure(option, t.last_error());
    }
}

Order scheme_of(const std::string& name) {
    try {
        return order_from_name(name);
    } catch (const mgdt::Error&) {
        throw Error(exit_usage, fmt::format("--scheme: unknown order scheme {}; it is one of {}",
                                            quote(name), fmt::join(scheme_names(), ", ")));
    }
}

}  // namespace

std::vector<std::string> scheme_names() {
    std::vector<std::string> names;
    for (const Order scheme : order_schemes()) names.emplace_back(name(scheme));
    return names;
}

void rethrow_failure(const std::string& doing, const std::string& last_error) {
    try {
        throw;
    } catch (const Cancelled& e) {
        check_interrupt();
        throw failure_of(e.status(), fmt::format("{}: {}", doing, e.what()));
    } catch (const mgdt::Error& e) {
        throw failure_of(e.status(), fmt::format("{}: {}", doing, e.what()));
    } catch (const OutOfMemory& e) {
        throw failure_of(e.status(), fmt::format("{}: {}", doing, last_error));
    }
}

Triangulation make_triangulation(const TriangulationOptions& options) {
    const Order scheme = scheme_of(options.scheme);
    Triangulation t;
    const auto set = [&](const char* option, const auto& call) { set_option(t, option, call); };
    const auto parameter = [&](const std::optional<double>& value, Parameter key,
                               const char* option) {
        if (value) set(option, [&] { t.set_order_parameter(key, *value); });
    };
    set("--scheme", [&] { t.set_order_scheme(scheme); });
    set("--threads", [&] { t.set_threads(options.threads); });
    set("--seed", [&] { t.set_seed(options.seed); });
    set("--canonical", [&] { t.set_canonical_output(options.canonical); });
    set("--memory-limit",
        [&] { t.set_memory_limit(static_cast<std::int64_t>(options.memory_limit)); });
    set("--compact", [&] { t.set_compact(options.compact); });
    parameter(options.points_per_cell, Parameter::points_per_cell, "--points-per-cell");
    parameter(options.threshold, Parameter::threshold, "--threshold");
    parameter(options.separation, Parameter::separation, "--separation");
    parameter(options.round_ratio, Parameter::round_ratio, "--round-ratio");
    return t;
}

void insert(Triangulation& t, const std::vector<double>& points, const std::string& name,
            bool quiet) {
    check_interrupt();
    Progress progress("triangulating", quiet);
    t.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
    const Cancellable cancelled_by_signals(t.handle());
    try {
        t.insert(points);
    } catch (...) {
        rethrow_failure(name, t.last_error());
    }
    t.clear_progress();
}

const char* shape(const Triangulation& t) {
    switch (t.dimension()) {
        case -1:
            return "there are no points";
        case 0:
            return "all points are equal";
        case 1:
            return "all points are on a line";
        default:
            return "all points are on a plane";
    }
}

std::vector<MeshIndex> tetrahedra(const Triangulation& t) {
    std::vector<MeshIndex> v(4 * static_cast<std::size_t>(t.tetrahedron_count()));
    t.tetrahedra(v);
    return v;
}

std::vector<MeshIndex> neighbors(const Triangulation& t) {
    std::vector<MeshIndex> v(4 * static_cast<std::size_t>(t.tetrahedron_count()));
    t.neighbors(v);
    return v;
}

std::string find_defect(const Triangulation& t, int level) {
    try {
        t.check(static_cast<Check>(level));
        return "";
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_CHECK_FAILED) return e.what();
        rethrow_failure("check", t.last_error());
    }
}

std::vector<double> interpolate(const Triangulation& t, Method method, Outside outside,
                                std::size_t n_fields, const std::vector<double>& values,
                                const std::vector<double>& places, bool quiet) {
    const std::size_t n = places.size() / 3;
    std::vector<double> out;
    out.reserve(n * n_fields);
    // Places are given in blocks, between which the program looks for signals. Blocks are large,
    // because some methods compute something for each point before the first place.
    const std::size_t most =
        std::max<std::size_t>(65536, static_cast<std::size_t>(t.point_count()));
    Progress progress("interpolating", quiet);
    for (std::size_t begin = 0; begin < n; begin += most) {
        check_interrupt();
        progress.update(static_cast<double>(begin) / static_cast<double>(n));
        const mgdt::Points some(places.data() + 3 * begin, std::min(most, n - begin));
        const std::vector<double> found = t.interpolate(method, outside, values, some, n_fields);
        out.insert(out.end(), found.begin(), found.end());
    }
    return out;
}

}  // namespace mgdt::cli
