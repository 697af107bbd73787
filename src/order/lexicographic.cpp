// SPDX-License-Identifier: MIT
// The order scheme by x, then y, then z.
#include <cstring>

#include "order/equal_runs.hpp"
#include "order/radix.hpp"
#include "order/schemes.hpp"

namespace mgdt {
namespace {

// An integer with the same order as the double: in positive numbers the sign bit is flipped, in
// negative numbers all bits are flipped. Adding 0 turns -0 into 0.
std::uint64_t ordered_image(double x) noexcept {
    x += 0.0;
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits >> 63 ? ~bits : bits | std::uint64_t{1} << 63;
}

// Sorts records by the coordinate of an axis, and records with the same coordinate by the following
// axes. Equal points keep their order.
void sort_by_axis(const PointSet& points, KeyedIndex* a, KeyedIndex* scratch, std::size_t n,
                  int axis) noexcept {
    for (std::size_t k = 0; k < n; ++k) {
        const double x = points.axis[axis][static_cast<std::ptrdiff_t>(a[k].index) * points.stride];
        a[k].key = ordered_image(x);
    }
    radix_sort(a, scratch, n, 0, 64);
    if (axis == 2) return;
    for_each_run(
        0, n, [&](std::size_t i, std::size_t j) { return a[i].key == a[j].key; },
        [&](std::size_t begin, std::size_t end) {
            if (end - begin > 1)
                sort_by_axis(points, a + begin, scratch + begin, end - begin, axis + 1);
        });
}

}  // namespace

void order_lexicographic(Team&, const PointSet& points, const OrderParameters&, Schedule& out) {
    const std::size_t n = points.size;
    Allocator& allocator = out.scratch;
    Buffer<KeyedIndex> records(allocator, n), scratch(allocator, n);
    for (std::size_t i = 0; i < n; ++i) records[i].index = static_cast<std::uint32_t>(i);
    sort_by_axis(points, records.data(), scratch.data(), n, 0);
    for (std::size_t k = 0; k < n; ++k) out.order[k] = records[k].index;
}

}  // namespace mgdt
