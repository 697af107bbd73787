// SPDX-License-Identifier: MIT
#include "periodic/merging.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedron.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

// The points that are not merged, in cubes whose sides are as long as the distance. The table has
// the last point of each cube, and each point has a link to the previous one.
class Cubes {
  public:
    Cubes(const Buffer<double>& points, double distance, double size, Allocator& allocator)
        : points_(points),
          squared_(distance * distance),
          size_(size),
          last_(allocator),
          before_(allocator) {
        const std::size_t n = points.size() / 3;
        while ((std::size_t{1} << bits_) < n + n / 2) ++bits_;
        last_.resize(std::size_t{1} << bits_, no_index);
        before_.resize(n, no_index);
    }

    void add(std::uint32_t point) {
        std::int64_t cube[3];
        find_cube(points_.begin() + 3 * std::size_t{point}, cube);
        std::uint32_t& last = last_[slot_of(cube)];
        before_[point] = last;
        last = point;
    }
    // Returns the least number of a point that is within the distance of x, or no_index.
    std::uint32_t first_near(const double* x) const {
        std::int64_t around[3];
        find_cube(x, around);
        std::uint32_t first = no_index;
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k) {
                    const std::int64_t cube[3] = {around[0] + i, around[1] + j, around[2] + k};
                    for (std::uint32_t p = last_[slot_of(cube)]; p != no_index; p = before_[p])
                        if (p < first && is_near(x, p)) first = p;
                }
        return first;
    }

  private:
    void find_cube(const double* x, std::int64_t (&cube)[3]) const {
        for (unsigned c = 0; c < 3; ++c)
            cube[c] = static_cast<std::int64_t>(std::floor(x[c] / size_));
    }
    std::size_t slot_of(const std::int64_t (&cube)[3]) const {
        std::uint64_t sum = 0;
        for (const std::int64_t c : cube) {
            sum = (sum ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
            sum ^= sum >> 29;
        }
        return static_cast<std::size_t>(sum * 0xBF58476D1CE4E5B9u >> (64 - bits_));
    }
    bool is_near(const double* x, std::uint32_t point) const {
        const double* const p = points_.begin() + 3 * std::size_t{point};
        double sum = 0;
        for (unsigned c = 0; c < 3; ++c) sum += (x[c] - p[c]) * (x[c] - p[c]);
        return sum <= squared_;
    }

    const Buffer<double>& points_;
    const double squared_, size_;
    unsigned bits_ = 1;
    Buffer<std::uint32_t> last_, before_;
};

}  // namespace

void merge_points(const ImageGrid& grid, double distance, Buffer<double>& wrapped,
                  Buffer<Multiples>& taken, Allocator& allocator) {
    const BoxLattice& lattice = grid.lattice();
    const unsigned d = lattice.dimensions();
    // The largest change of each coordinate along the basis over the distance.
    double reach[3] = {};
    for (unsigned k = 0; k < d; ++k) {
        reach[k] = lattice.slope(k) * distance;
        if (reach[k] > 0.125)
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "points are to be merged over a distance of %g, more than an eighth of the box",
                 lattice.to_callers(distance));
    }
    // The numbers of cubes are below 2^51. On the grid, points that are nearer to each other and
    // not equal are rare.
    const double size = std::max(distance, grid.size() * 0x1p-50);
    Cubes cubes(wrapped, distance, size, allocator);
    const auto n = static_cast<std::uint32_t>(wrapped.size() / 3);
    for (std::uint32_t i = 0; i < n; ++i) {
        double* const x = wrapped.begin() + 3 * std::size_t{i};
        double s[3];
        lattice.coordinates(x, s);
        // The range of multiples by which the point can be moved so that it stays in the box or
        // within the distance of it.
        std::int32_t low[3] = {}, high[3] = {};
        for (unsigned k = 0; k < d; ++k) {
            const double margin = 1.001 * reach[k] + lattice.error_of(k, grid.size());
            low[k] = s[k] > 1 - margin ? -1 : 0;
            high[k] = s[k] < margin ? 1 : 0;
        }
        std::uint32_t leader = no_index;
        Multiples of = {};
        for (Multiples k = {low[0], 0, 0}; k[0] <= high[0]; ++k[0])
            for (k[1] = low[1]; k[1] <= high[1]; ++k[1])
                for (k[2] = low[2]; k[2] <= high[2]; ++k[2]) {
                    double image[3];
                    grid.image(x, k, image);
                    const std::uint32_t found = cubes.first_near(image);
                    if (found >= leader) continue;
                    leader = found;
                    of = k;
                }
        if (leader == no_index) {
            cubes.add(i);
            continue;
        }
        std::copy_n(wrapped.begin() + 3 * std::size_t{leader}, 3, x);
        taken[i] = taken[i] - of;
    }
}

}  // namespace mgdt
