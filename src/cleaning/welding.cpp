// SPDX-License-Identifier: MIT
#include "cleaning/welding.hpp"

#include <algorithm>
#include <numeric>

#include "platform/hash.hpp"
#include "platform/number_table.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The points that stay, in the cells of a grid. A cell is as wide as the distance, so those within
// the distance of a place are in its cell and the 26 around it.
class StayingPoints {
  public:
    StayingPoints(const Buffer<double>& points, const Nearness& near, Allocator& allocator)
        : points_(points),
          near_(near),
          width_(std::max(near.scaled_distance(), least_width)),
          cells_(allocator),
          table_(allocator),
          next_(allocator) {
        table_.clear(std::max<std::size_t>(points.size() / 3, 1));
        next_.resize(points.size() / 3, no_index);
    }

    // The nearest point within the distance, or `no_index`.
    std::uint32_t nearest(const double* x) const {
        const Cell home = cell_of(x);
        std::uint32_t best = no_index;
        double least = near_.scaled_distance();
        for (int k = 0; k < 27; ++k) {
            const Cell cell = {
                {home.at[0] + k % 3 - 1, home.at[1] + k / 3 % 3 - 1, home.at[2] + k / 9 - 1},
                no_index};
            const std::uint32_t number =
                table_.find(hash(cell), [&](std::uint32_t i) { return is_same(cells_[i], cell); });
            if (number == no_index) continue;
            for (std::uint32_t p = cells_[number].first; p != no_index; p = next_[p]) {
                const double distance = length(near_.scaled(point(p)) - near_.scaled(x));
                if (distance > least || (distance == least && best != no_index &&
                                         compare_lexicographic(point(best), point(p)) < 0))
                    continue;
                best = p;
                least = distance;
            }
        }
        return best;
    }
    void add(std::uint32_t p) {
        const Cell cell = cell_of(point(p));
        const std::uint32_t number =
            table_.number(hash(cell), [&](std::uint32_t i) { return is_same(cells_[i], cell); });
        if (number == cells_.size()) cells_.push_back(cell);
        next_[p] = cells_[number].first;
        cells_[number].first = p;
    }

  private:
    struct Cell {
        std::int64_t at[3];
        std::uint32_t first;  // of the points in it
    };
    static constexpr double least_width = 0x1p-50;  // so that a cell has integers

    static bool is_same(const Cell& a, const Cell& b) { return std::equal(a.at, a.at + 3, b.at); }
    static std::uint32_t hash(const Cell& c) { return hash_of_words(c.at[0], c.at[1], c.at[2]); }
    const double* point(std::uint32_t p) const { return points_.begin() + 3 * std::size_t{p}; }
    Cell cell_of(const double* x) const {
        const Vector<double> p = near_.scaled(x);
        Cell cell = {{}, no_index};
        for (int k = 0; k < 3; ++k)
            cell.at[k] = static_cast<std::int64_t>(std::floor(p.x[k] / width_));
        return cell;
    }

    const Buffer<double>& points_;
    const Nearness& near_;
    double width_;
    Buffer<Cell> cells_;
    NumberTable table_;
    Buffer<std::uint32_t> next_;  // the next point in the cell of each
};

}  // namespace

std::size_t weld_points(Buffer<double>& points, const Nearness& near, Allocator& allocator,
                        const StopRequest& stop) {
    if (near.is_exact()) return 0;
    const auto point = [&](std::uint32_t p) { return points.begin() + 3 * std::size_t{p}; };
    Buffer<std::uint32_t> order(allocator);
    order.resize(points.size() / 3);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const int sign = compare_lexicographic(point(a), point(b));
        return sign != 0 ? sign < 0 : a < b;
    });
    StayingPoints staying(points, near, allocator);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < order.size();) {
        stop.poll_in_step(i);
        std::size_t end = i + 1;
        while (end < order.size() && compare_lexicographic(point(order[i]), point(order[end])) == 0)
            ++end;
        const std::uint32_t to = staying.nearest(point(order[i]));
        if (to == no_index) {
            staying.add(order[i]);
        } else {
            moved += end - i;
            for (std::size_t k = i; k < end; ++k) std::copy_n(point(to), 3, point(order[k]));
        }
        i = end;
    }
    return moved;
}

}  // namespace mgdt
