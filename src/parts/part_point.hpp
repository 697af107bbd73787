// SPDX-License-Identifier: MIT
// A point on its way between parts.
#pragma once

#include <cstdint>

namespace mgdt {

struct PartPoint {
    double x[3];
    std::int64_t id;      // the least that the caller gave to a point of these coordinates
    std::int64_t number;  // of the vertex, among those of all parts

    friend bool operator<(const PartPoint& a, const PartPoint& b) { return a.number < b.number; }
    friend bool operator==(const PartPoint& a, const PartPoint& b) { return a.number == b.number; }
};

}  // namespace mgdt
