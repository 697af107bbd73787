// SPDX-License-Identifier: MIT
// A point that parts exchange.
#pragma once

#include <cstdint>

namespace mgdt {

struct PartPoint {
    double x[3];
    std::int64_t id;      // the least id that callers gave to a point with these coordinates
    std::int64_t number;  // the number of the point's vertex among the vertices of all parts

    friend bool operator<(const PartPoint& a, const PartPoint& b) { return a.number < b.number; }
    friend bool operator==(const PartPoint& a, const PartPoint& b) { return a.number == b.number; }
};

}  // namespace mgdt
