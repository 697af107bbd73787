// SPDX-License-Identifier: MIT
#include "domain/split_place.hpp"

#include <algorithm>
#include <cmath>

namespace mgdt {
namespace {

double distance(const double* a, const double* b) noexcept {
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

}  // namespace

Buffer<std::uint8_t> find_acute_ends(const Buffer<double>& points,
                                     const Buffer<std::uint32_t>& segments, Allocator& allocator) {
    // The ends of segments, sorted by their points.
    const auto n = static_cast<std::uint32_t>(segments.size());
    Buffer<std::uint32_t> ends(allocator, n);
    for (std::uint32_t i = 0; i < n; ++i) ends[i] = i;
    std::sort(ends.begin(), ends.end(), [&](std::uint32_t i, std::uint32_t j) {
        return segments[i] != segments[j] ? segments[i] < segments[j] : i < j;
    });
    const auto meet_acutely = [&](std::uint32_t i, std::uint32_t j) {
        const double* const o = points.begin() + 3 * std::size_t{segments[i]};
        const double* const p = points.begin() + 3 * std::size_t{segments[i ^ 1]};
        const double* const q = points.begin() + 3 * std::size_t{segments[j ^ 1]};
        double dot = 0;
        for (int k = 0; k < 3; ++k) dot += (p[k] - o[k]) * (q[k] - o[k]);
        return dot > 0.5 * distance(o, p) * distance(o, q);
    };
    Buffer<std::uint8_t> acute(allocator, n);
    for (std::size_t i = 0; i < n;) {
        std::size_t end = i + 1;
        while (end < n && segments[ends[end]] == segments[ends[i]]) ++end;
        // Among 13 directions, two form an angle of less than 60 degrees.
        constexpr std::size_t kissing_number = 12;
        bool is_acute = end - i > kissing_number;
        for (std::size_t k = i; k < end && !is_acute; ++k)
            for (std::size_t l = k + 1; l < end && !is_acute; ++l)
                is_acute = meet_acutely(ends[k], ends[l]);
        for (; i < end; ++i) acute[ends[i]] = is_acute ? 1 : 0;
    }
    return acute;
}

std::uint32_t split_place(const double* a, const double* b, bool is_acute_at_a, bool is_acute_at_b,
                          const double* reference, std::uint32_t k0, std::uint32_t k1,
                          std::uint32_t parts, bool avoids_short_parts) noexcept {
    const std::uint32_t half = parts / 2;
    if (is_acute_at_a && is_acute_at_b) {
        if (k0 < half && half < k1) return half;
        is_acute_at_a = k1 <= half;
        is_acute_at_b = !is_acute_at_a;
    }
    const double length = distance(a, b), begin = double(k0) / parts, end = double(k1) / parts;
    constexpr double least_share = 0.2;
    double t;
    if (is_acute_at_a || is_acute_at_b) {
        const double radius = distance(is_acute_at_a ? a : b, reference) / length;
        t = is_acute_at_a ? radius : 1 - radius;
        if (!(t > begin && t < end)) {
            t = begin + (end - begin) / 2;
        } else if (avoids_short_parts) {
            // If the other end is nearer to the new point than the reference point is, the new
            // point is moved away from it: rule 3 of Si and Gaertner.
            const double x[3] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]),
                                 a[2] + t * (b[2] - a[2])};
            const double away = distance(x, reference) / length;
            const double near = is_acute_at_a ? t - begin : end - t,
                         far = is_acute_at_a ? end - t : t - begin;
            const double back = away < near / 2 ? away : near / 2;
            if (far < away) t += is_acute_at_a ? -back : back;
        }
    } else {
        double dot = 0;
        for (int k = 0; k < 3; ++k) dot += (b[k] - a[k]) * (reference[k] - a[k]);
        t = dot / (length * length);
        t = std::max(t, begin + least_share * (end - begin));
        t = std::min(t, end - least_share * (end - begin));
    }
    const double k = std::nearbyint(t * parts);
    return static_cast<std::uint32_t>(std::min(std::max(k, double(k0) + 1), double(k1) - 1));
}

}  // namespace mgdt
