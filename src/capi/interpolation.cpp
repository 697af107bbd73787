// SPDX-License-Identifier: MIT
// Interpolation, its weights, and gradients.
#include "interpolation/interpolation.hpp"

#include "capi/counts.hpp"
#include "capi/places.hpp"
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

namespace {

Method method_of(std::int32_t method) {
    switch (method) {
        case MGDT_INTERPOLATE_LINEAR:
            return Method::linear;
        case MGDT_INTERPOLATE_NEAREST:
            return Method::nearest;
        case MGDT_INTERPOLATE_SIBSON:
            return Method::sibson;
        case MGDT_INTERPOLATE_LAPLACE:
            return Method::laplace;
        case MGDT_INTERPOLATE_SIBSON_C1:
            return Method::sibson_c1;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no method %d", static_cast<int>(method));
    }
}

Outside outside_of(std::int32_t outside) {
    switch (outside) {
        case MGDT_OUTSIDE_NONE:
            return Outside::none;
        case MGDT_OUTSIDE_NEAREST:
            return Outside::nearest;
        case MGDT_OUTSIDE_BOUNDARY:
            return Outside::boundary;
        case MGDT_OUTSIDE_LINEAR:
            return Outside::linear;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no value %d for what is outside",
                 static_cast<int>(outside));
    }
}

// Checks the method. Only Method::nearest works for points that do not span space.
Manner require_manner(const mgdt_triangulation* t, std::int32_t method, std::int32_t outside) {
    const Manner manner = {method_of(method), outside_of(outside)};
    if (manner.method != Method::nearest) require_space(t, "values between points");
    return manner;
}

template <class Int>
void weights(const mgdt_triangulation* t, std::int32_t method, std::int32_t outside, std::int64_t n,
             const double* xyz, std::int64_t offset_capacity, Int* offsets, std::int64_t capacity,
             Int* points, double* to, const StageProgress& progress) {
    const Manner manner = require_manner(t, method, outside);
    const std::size_t count = require_places(n);
    require_pointer(offsets, "the array of offsets");
    require_capacity(offset_capacity, count + 1, "the array of offsets");
    require_capacity(capacity, 0, "the output array");
    if (count > 0) require_pointer(xyz, "xyz");
    const bool counts_alone = !points && !to;
    if (!counts_alone && capacity > 0) {
        require_pointer(points, "the array of points");
        require_pointer(to, "the array of weights");
    }
    require_range<Int>(static_cast<std::uint64_t>(point_count(t->object)), t);
    Team team(t->object.threads_for(count, places_per_thread));
    const MeshView view = view_of(team, t, false);
    const std::size_t room = counts_alone ? 0 : static_cast<std::size_t>(capacity);
    std::size_t needed = 0;
    if (count == 0)
        offsets[0] = static_cast<Int>(view.base);
    else
        needed = interpolation_weights<Int>(
            view, locator(t), manner,
            finite_places(team, count, xyz, t->object.settings().index_base), progress,
            {offsets, room, points, to});
    if (!counts_alone) require_capacity(capacity, needed, "the output array");
}

}  // namespace

extern "C" mgdt_status mgdt_interpolate(const mgdt_triangulation* t, int32_t method,
                                        int32_t outside, int64_t n_fields, const double* values,
                                        int64_t n, const double* xyz, double* out) {
    return guard_long(t, [&](StageProgress& progress) {
        const Manner manner = require_manner(t, method, outside);
        const std::size_t count = require_places(n);
        const auto points = static_cast<std::size_t>(point_count(t->object));
        const std::size_t fields = require_fields(n_fields, std::max(count, points));
        if (count == 0 || fields == 0) return;
        if (points > 0) require_pointer(values, "the array of values");
        require_pointer(xyz, "xyz");
        require_pointer(out, "the output array");
        Team team(t->object.threads_for(count, places_per_thread));
        interpolate(view_of(team, t, false), locator(t), manner, {fields, values},
                    finite_places(team, count, xyz, t->object.settings().index_base), progress,
                    out);
    });
}

extern "C" mgdt_status mgdt_get_interpolation_weights(const mgdt_triangulation* t, int32_t method,
                                                      int32_t outside, int64_t n, const double* xyz,
                                                      int64_t offset_capacity, int64_t* offsets,
                                                      int64_t capacity, int64_t* points,
                                                      double* weights_out) {
    return guard_long(t, [&](StageProgress& progress) {
        weights(t, method, outside, n, xyz, offset_capacity, offsets, capacity, points, weights_out,
                progress);
    });
}

extern "C" mgdt_status mgdt_get_interpolation_weights_i32(const mgdt_triangulation* t,
                                                          int32_t method, int32_t outside,
                                                          int64_t n, const double* xyz,
                                                          int64_t offset_capacity, int32_t* offsets,
                                                          int64_t capacity, int32_t* points,
                                                          double* weights_out) {
    return guard_long(t, [&](StageProgress& progress) {
        weights(t, method, outside, n, xyz, offset_capacity, offsets, capacity, points, weights_out,
                progress);
    });
}

extern "C" mgdt_status mgdt_get_gradients(const mgdt_triangulation* t, int64_t n_fields,
                                          const double* values, double* out) {
    return guard_long(t, [&](StageProgress& progress) {
        require_space(t, "gradients");
        const auto points = static_cast<std::size_t>(point_count(t->object));
        const std::size_t fields = require_fields(n_fields, points);
        if (points == 0 || fields == 0) return;
        require_pointer(values, "the array of values");
        require_pointer(out, "the output array");
        constexpr std::size_t points_per_thread = 4096;
        Team team(t->object.threads_for(points, points_per_thread));
        gradients(view_of(team, t, false), locator(t), t->object.point_map(), {fields, values},
                  progress, out);
    });
}
