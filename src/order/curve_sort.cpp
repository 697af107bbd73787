// SPDX-License-Identifier: MIT
#include "order/curve_sort.hpp"

#include <algorithm>

#include "order/cell_numbers.hpp"
#include "order/hilbert_curve.hpp"
#include "order/team_equal_runs.hpp"
#include "order/team_radix.hpp"

namespace mgdt {
namespace {

// Whether two sorted words have the same key, that is, points in one cell.
struct InOneCell {
    const std::uint64_t* words;
    unsigned index_bits;
    bool operator()(std::size_t i, std::size_t j) const noexcept {
        return (words[i] ^ words[j]) >> index_bits == 0;
    }
};

// A word of 64 bits has a key in its upper bits and an index in its lower bits. The key has room
// for 9 to 15 levels of the curve; sets of up to 16,384 points use fewer. If many points are in one
// cell of the finest level, the curve is continued inside that cell, over the smallest cube that
// contains them. So the resolution adapts to the points, down to the last bit of their coordinates.
//
// A nested curve has at most 2^-9 of the extent, so nesting is at most (1024 + 1074) / 9 deep.
// Cells that are still to be sorted are listed in memory of the handle, so the use of the stack
// does not depend on the points.
class CurveSorter {
  public:
    CurveSorter(const PointSet& points, std::size_t crowd, CurveOrder& order,
                Buffer<std::uint64_t>& scratch) noexcept
        : points_(points),
          crowd_(crowd),
          order_(order),
          allocator_(order.words.allocator()),
          words_(order.words.data()),
          scratch_(scratch.data()) {
        const unsigned room = (64 - order.index_bits) / (3 * HilbertCurve::levels_per_step);
        // At least one cell per four points along each axis, so that few points of a line share a
        // cell.
        const unsigned wanted =
            std::max(least_steps, order.index_bits / HilbertCurve::levels_per_step);
        steps_ = std::min({room, wanted, most_steps});
    }

    // Threads sort crowded cells with few points at the same time, one thread per cell. All threads
    // together sort crowded cells with many points, one cell after another.
    void sort(Team& team) {
        Buffer<Cell> large(allocator_);
        Buffer<Run> runs(allocator_);
        Cell cell{0, points_.size, HilbertCurve::first_state, 1};
        Box box = box_of(points_);
        for (;;) {
            const Lattice lattice = sort_cell(team, cell, box);
            runs.clear();
            for_each_run(
                team, allocator_, cell.begin, cell.end, crowd_ + 1,
                InOneCell{words_, order_.index_bits},
                [&] {
                    return [&, open = Buffer<Level>(allocator_)](std::size_t begin,
                                                                 std::size_t end) mutable {
                        sort_inside(open, lattice, cell, begin, end);
                    };
                },
                runs);
            for (const Run& run : runs) large.push_back(inside(lattice, cell, run.begin, run.end));
            do {
                if (large.empty()) return;
                cell = large.back();
                large.pop_back();
                box = box_of_points(cell);
            } while (!(box.longest() > 0));  // all points are equal
        }
    }

    unsigned levels() const noexcept { return levels_; }

  private:
    static constexpr unsigned least_steps = 3, most_steps = 5;
    static constexpr std::size_t min_items_per_thread = 32768;

    struct Cell {
        std::size_t begin, end;  // the range of its points
        unsigned state;          // the state of the curve in the cell
        unsigned depth;          // the depth of nesting; 1 for the whole set
    };
    // A cell whose points are sorted by its curve. Of the crowded cells inside this cell, those
    // before cell.begin are sorted, too.
    struct Level {
        Cell cell;
        Lattice lattice;
    };

    std::uint64_t key(const Lattice& lattice, std::uint64_t index, unsigned& state) const noexcept {
        const auto i = static_cast<std::size_t>(index);
        return hilbert_curve.key(lattice.step(points_, i, 0), lattice.step(points_, i, 1),
                                 lattice.step(points_, i, 2), steps_, state);
    }

    Box box_of_points(const Cell& cell) const noexcept {
        return box_of(points_, cell.end - cell.begin,
                      [&](std::size_t j) { return order_.index(cell.begin + j); });
    }

    // The cell of the finest level that has the points begin..end-1. This cell is inside `cell`,
    // whose points are sorted already.
    Cell inside(const Lattice& lattice, const Cell& cell, std::size_t begin,
                std::size_t end) const noexcept {
        unsigned state = cell.state;
        key(lattice, order_.index(begin), state);
        return {begin, end, state, cell.depth + 1};
    }

    // Sorts the points of a cell by their keys on its lattice. Returns the lattice.
    Lattice sort_cell(Team& team, const Cell& cell, const Box& box) {
        unsigned deepest = levels_;
        while (cell.depth > deepest && !levels_.compare_exchange_weak(deepest, cell.depth)) {
        }
        const unsigned levels = HilbertCurve::levels_per_step * steps_;
        const Lattice lattice = Lattice::cubes(points_, box, 1u << levels);
        const std::size_t size = cell.end - cell.begin;
        const unsigned state = cell.state;
        std::uint64_t* const words = words_ + cell.begin;
        team.split(size, min_items_per_thread, [&](std::size_t first, std::size_t last, unsigned) {
            for (std::size_t k = first; k < last; ++k) {
                unsigned to = state;
                const std::uint64_t index = words[k] & order_.index_mask();
                words[k] = key(lattice, index, to) << order_.index_bits | index;
            }
        });
        radix_sort(team, allocator_, words, scratch_ + cell.begin, size, order_.index_bits,
                   order_.index_bits + 3 * levels);
        return lattice;
    }

    // Sorts a cell of the finest level and all curves nested inside it. `open` is working memory,
    // empty before and after the call.
    void sort_inside(Buffer<Level>& open, const Lattice& lattice, const Cell& cell,
                     std::size_t begin, std::size_t end) {
        Team alone;
        enter(alone, open, inside(lattice, cell, begin, end));
        while (!open.empty()) {
            Level& level = open.back();
            const std::size_t stop = level.cell.end;
            std::size_t first = level.cell.begin, last = first;
            for (; first < stop; first = last) {
                last = end_of_run(first, stop, InOneCell{words_, order_.index_bits});
                if (last - first > crowd_) break;
            }
            if (first < stop) {
                level.cell.begin = last;
                enter(alone, open, inside(level.lattice, level.cell, first, last));
            } else {
                open.pop_back();
            }
        }
    }

    void enter(Team& alone, Buffer<Level>& open, const Cell& cell) {
        const Box box = box_of_points(cell);
        if (!(box.longest() > 0)) return;  // all points are equal
        open.grow(open.size() + 1);
        const Lattice lattice = sort_cell(alone, cell, box);
        open.resize_within_capacity(open.size() + 1);
        open.back() = {cell, lattice};
    }

    const PointSet& points_;
    const std::size_t crowd_;
    const CurveOrder& order_;
    Allocator& allocator_;
    std::uint64_t* words_;
    std::uint64_t* scratch_;
    unsigned steps_;
    Atomic<unsigned> levels_{0};
};

}  // namespace

CurveOrder sort_along_curve(Team& team, const PointSet& points, Allocator& allocator,
                            std::size_t crowd) {
    const std::size_t n = points.size;
    CurveOrder order{Buffer<std::uint64_t>(allocator), 0, 0};
    if (n == 0) return order;
    Buffer<std::uint64_t> scratch(allocator);
    order.words.resize(n);
    scratch.resize(n);
    order.index_bits = bit_width(n - 1);
    team.split(n, 65536, [&](std::size_t begin, std::size_t end, unsigned) {
        order.words.prefault(begin, end);
        scratch.prefault(begin, end);
        for (std::size_t k = begin; k < end; ++k) order.words[k] = k;
    });
    CurveSorter sorter(points, crowd, order, scratch);
    sorter.sort(team);
    order.levels = sorter.levels();
    return order;
}

}  // namespace mgdt
