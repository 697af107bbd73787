// SPDX-License-Identifier: MIT
#include "cli/program_triangulation.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>

#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {

std::vector<std::string> scheme_names() {
    std::vector<std::string> names;
    // Enumerators have gaps, and a newer library may know more of them than this program.
    std::int32_t scheme = 0;
    for (std::int32_t i = 0; mgdt_order_scheme_at(i, &scheme) == MGDT_OK; ++i) {
        names.emplace_back(mgdt_order_scheme_name(scheme));
    }
    return names;
}

void throw_status(mgdt_status status, const std::string& what) {
    switch (status) {
        case MGDT_ERR_CANCELLED:
            check_interrupt();
            break;
        case MGDT_ERR_NOT_FINITE:
            throw Error(exit_input, what + "; take the point out");
        case MGDT_ERR_OUT_OF_MEMORY:
            throw Error(exit_memory, what + "; triangulate fewer points or give it more memory");
        case MGDT_ERR_TOO_LARGE:
        case MGDT_ERR_INDEX_RANGE:
            throw Error(exit_memory, what + "; triangulate fewer points");
        default:
            break;
    }
    throw Error(exit_internal, what);
}

Triangulation::Triangulation(const TriangulationOptions& options) : quiet_(options.quiet) {
    std::int32_t scheme = MGDT_ORDER_AUTO;
    if (mgdt_order_scheme_from_name(options.scheme.c_str(), &scheme) != MGDT_OK) {
        throw Error(exit_usage,
                    fmt::format("--scheme: unknown order scheme {}; it is one of {}",
                                quote(options.scheme), fmt::join(scheme_names(), ", ")));
    }
    const mgdt_status status = mgdt_create(&handle_);
    if (status != MGDT_OK) throw std::bad_alloc();
    try {
        const auto set = [this](mgdt_status s, const char* option) {
            if (s == MGDT_ERR_INVALID_ARGUMENT) {
                throw Error(exit_usage, fmt::format("{}: {}", option, message(s)));
            }
            require(s, option);
        };
        const auto parameter = [&](const std::optional<double>& value, std::int32_t key,
                                   const char* option) {
            if (value) set(mgdt_set_order_parameter(handle_, key, *value), option);
        };
        set(mgdt_set_order_scheme(handle_, scheme), "--scheme");
        set(mgdt_set_threads(handle_, options.threads), "--threads");
        set(mgdt_set_seed(handle_, options.seed), "--seed");
        set(mgdt_set_canonical_output(handle_, options.canonical ? 1 : 0), "--canonical");
        set(mgdt_set_memory_limit(handle_, static_cast<std::int64_t>(options.memory_limit)),
            "--memory-limit");
        set(mgdt_set_compact(handle_, options.compact ? 1 : 0), "--compact");
        parameter(options.points_per_cell, MGDT_PARAMETER_POINTS_PER_CELL, "--points-per-cell");
        parameter(options.threshold, MGDT_PARAMETER_THRESHOLD, "--threshold");
        parameter(options.separation, MGDT_PARAMETER_SEPARATION, "--separation");
        parameter(options.round_ratio, MGDT_PARAMETER_ROUND_RATIO, "--round-ratio");
    } catch (...) {
        mgdt_destroy(handle_);
        throw;
    }
    set_cancellable(handle_);
}

Triangulation::~Triangulation() {
    set_cancellable(nullptr);
    mgdt_destroy(handle_);
}

std::string Triangulation::message(mgdt_status status) const {
    char text[256] = "";
    mgdt_get_error(handle_, sizeof text, text);
    return text[0] != '\0' ? text : mgdt_status_string(status);
}

void Triangulation::require(mgdt_status status, const std::string& doing) const {
    if (status != MGDT_OK) throw_status(status, fmt::format("{}: {}", doing, message(status)));
}

void Triangulation::insert(const std::vector<double>& points, const std::string& name) {
    Progress progress("triangulating", quiet_);
    insert(points, name, Progress::callback, &progress);
}

void Triangulation::insert(const std::vector<double>& points, const std::string& name,
                           mgdt_progress_fn progress, void* user) {
    check_interrupt();
    mgdt_set_progress(handle_, progress, user);
    const mgdt_status status =
        mgdt_insert_points(handle_, static_cast<std::int64_t>(points.size() / 3), points.data());
    mgdt_set_progress(handle_, nullptr, nullptr);
    require(status, name);
}

const char* Triangulation::shape() const {
    switch (mgdt_dimension(handle_)) {
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

namespace {

std::vector<MeshIndex> array(std::int64_t size) {
    return std::vector<MeshIndex>(static_cast<std::size_t>(size));
}

}  // namespace

std::vector<MeshIndex> Triangulation::tetrahedra() const {
    auto v = array(4 * mgdt_tetrahedron_count(handle_));
    require(mgdt_get_tetrahedra_i32(handle_, static_cast<std::int64_t>(v.size()), v.data()),
            "tetrahedra");
    return v;
}

std::vector<MeshIndex> Triangulation::neighbors() const {
    auto v = array(4 * mgdt_tetrahedron_count(handle_));
    require(mgdt_get_neighbors_i32(handle_, static_cast<std::int64_t>(v.size()), v.data()),
            "neighbours");
    return v;
}

std::vector<MeshIndex> Triangulation::point_map() const {
    auto v = array(mgdt_point_count(handle_));
    require(mgdt_get_point_map_i32(handle_, static_cast<std::int64_t>(v.size()), v.data()),
            "point map");
    return v;
}

std::string Triangulation::check(int level) const {
    const mgdt_status status = mgdt_check(handle_, level);
    if (status != MGDT_ERR_CHECK_FAILED) {
        require(status, "check");
        return "";
    }
    return message(status);
}

std::vector<MeshIndex> Triangulation::locate(const std::vector<double>& places) const {
    const auto n = static_cast<std::int64_t>(places.size() / 3);
    auto tetrahedra = array(n);
    require(mgdt_locate_points_i32(handle_, n, places.data(), tetrahedra.data(), nullptr),
            "location");
    return tetrahedra;
}

void Triangulation::interpolate(std::int32_t method, std::int32_t outside, std::size_t n_fields,
                                const std::vector<double>& values,
                                const std::vector<double>& places, std::vector<double>& out) const {
    const std::size_t n = places.size() / 3;
    out.resize(n * n_fields);
    // A call cannot be cancelled. Some methods have work for each point before the first place.
    const std::size_t most =
        std::max<std::size_t>(65536, static_cast<std::size_t>(mgdt_point_count(handle_)));
    Progress progress("interpolating", quiet_);
    for (std::size_t begin = 0; begin < n; begin += most) {
        check_interrupt();
        progress.update(static_cast<double>(begin) / static_cast<double>(n));
        const std::size_t count = std::min(most, n - begin);
        require(mgdt_interpolate(handle_, method, outside, static_cast<std::int64_t>(n_fields),
                                 values.data(), static_cast<std::int64_t>(count),
                                 places.data() + 3 * begin, out.data() + n_fields * begin),
                "interpolation");
    }
}

}  // namespace mgdt::cli
