// SPDX-License-Identifier: MIT
#include "bench/churn.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "bench/summary.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli::bench {
namespace {

// The largest number of single calls, and of rounds, in a run.
constexpr std::size_t most_calls = 10000;
constexpr std::size_t fewest_points = 100;

struct ChurnFigures {
    // Microseconds per point that is inserted, removed or moved.
    std::vector<double> insert, remove, remove_one, move_one, round;
    std::vector<double> move_all;  // moves of all points, as a multiple of the insertion of all
    std::vector<double> growth;    // the relative growth of memory during the rounds
};

// One run on one handle. The run times its calls.
class Run {
  public:
    Run(const ChurnOptions& options, const std::vector<double>& xyz, std::uint64_t seed)
        : t_(make_triangulation(settings(options))), xyz_(xyz), random_(seed) {}

    void run(ChurnFigures& f) {
        try {
            measure(f);
        } catch (...) {
            rethrow_failure("--churn", t_.last_error());
        }
    }

  private:
    void measure(ChurnFigures& f) {
        const std::size_t n = xyz_.size() / 3, few = std::min(most_calls, n / 20 + 1);
        const auto timed = [&](std::size_t points, const auto& body) {
            check_interrupt();
            const auto start = std::chrono::steady_clock::now();
            body();
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() *
                   1e6 / static_cast<double>(points);
        };
        f.insert.push_back(timed(n, [&] { t_.insert(xyz_); }));

        // Moves by a hundredth of the mean spacing of a uniform set of this extent.
        move_a_little(0.01);
        f.move_all.push_back(timed(n, [&] { t_.move(places_); }) / f.insert.back());

        std::vector<std::int64_t> order(n);
        for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::int64_t>(i);
        std::shuffle(order.begin(), order.end(), random_);
        f.move_one.push_back(timed(few, [&] {
            for (std::size_t k = 0; k < few; ++k) {
                const std::int64_t i = order[k];
                t_.move({i}, Points(&xyz_[3 * static_cast<std::size_t>(i)], 1));
            }
        }));
        const std::size_t tenth = n / 10 + 1;
        f.remove.push_back(
            timed(tenth, [&] { t_.remove(Span<const std::int64_t>(order.data(), tenth)); }));
        f.remove_one.push_back(timed(few, [&] {
            for (std::size_t k = 0; k < few; ++k) t_.remove({order[tenth + k]});
        }));
        t_.renumber();

        // Rounds of one removal and one insertion each.
        const double before = bytes();
        f.round.push_back(timed(few, [&] {
            for (std::size_t k = 0; k < few; ++k) {
                while (!remove_one()) {
                }
                t_.insert(Points(&xyz_[3 * (k % n)], 1));
            }
        }));
        t_.renumber();
        f.growth.push_back(bytes() / before - 1);
        t_.check(n > 200000 ? Check::combinatorial : Check::canonical);
    }
    // Removes a random point. Returns false if it has been removed before.
    bool remove_one() {
        const auto points = static_cast<std::size_t>(t_.point_count());
        const auto i = static_cast<std::int64_t>(static_cast<std::size_t>(random_()) % points);
        try {
            t_.remove({i});
            return true;
        } catch (const mgdt::Error& e) {
            if (e.status() != MGDT_ERR_INVALID_ARGUMENT) throw;
            return false;
        }
    }

    static TriangulationOptions settings(const ChurnOptions& options) {
        TriangulationOptions settings;
        settings.threads = options.threads;
        settings.compact = options.compact;
        settings.quiet = true;
        return settings;
    }
    double bytes() const { return t_.statistic(Statistic::memory_bytes); }
    void move_a_little(double share) {
        const std::size_t n = xyz_.size() / 3;
        double spacing[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double low = xyz_[axis], high = xyz_[axis];
            for (std::size_t i = axis; i < xyz_.size(); i += 3) {
                low = std::min(low, xyz_[i]);
                high = std::max(high, xyz_[i]);
            }
            spacing[axis] = share * (high - low) / std::cbrt(static_cast<double>(n));
        }
        std::uniform_real_distribution<double> uniform(-1, 1);
        places_ = xyz_;
        for (std::size_t i = 0; i < places_.size(); ++i)
            places_[i] += spacing[i % 3] * uniform(random_);
    }

    Triangulation t_;
    const std::vector<double>& xyz_;
    std::vector<double> places_;
    std::mt19937_64 random_;
};

}  // namespace

void run_churn(const ChurnOptions& options) {
    fmt::print("{:<15} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7}\n",
               "distribution", "points", "insert", "out", "/ insert", "one out", "one move",
               "a round", "all move", "/ insert", "memory");
    for (const PointSetName& set : options.sets) {
        const PointSet points(set, options.data_directory, [] { check_interrupt(); });
        check_interrupt();
        if (points.status() != "ok") {
            throw Error(exit_input,
                        fmt::format("{} {}: {}", set.distribution, set.points, points.status()));
        }
        const std::vector<double> xyz = points.read();
        if (xyz.size() < 3 * fewest_points) {
            throw Error(exit_usage, fmt::format("--churn: {} {} are too few; {} points are needed",
                                                set.distribution, xyz.size() / 3, fewest_points));
        }
        ChurnFigures f;
        for (int run = 0; run < options.runs; ++run)
            Run(options, xyz, set.seed + static_cast<std::uint64_t>(run)).run(f);
        const double insert = median(f.insert), remove = median(f.remove), all = median(f.move_all);
        fmt::print(
            "{:<15} {:>9} {:>8.3f} {:>8.3f} {:>8.2f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} "
            "{:>8.2f} {:>6.1f}%\n",
            set.distribution, xyz.size() / 3, insert, remove, remove / insert, median(f.remove_one),
            median(f.move_one), median(f.round), all * insert, all, 100 * median(f.growth));
    }
}

}  // namespace mgdt::cli::bench
