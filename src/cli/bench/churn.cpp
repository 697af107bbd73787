// SPDX-License-Identifier: MIT
#include "cli/bench/churn.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "cli/bench/summary.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli::bench {
namespace {

// Single calls and rounds of a run, at most.
constexpr std::size_t most_calls = 10000;
constexpr std::size_t fewest_points = 100;

struct ChurnFigures {
    // Microseconds per point that is inserted, removed or moved.
    std::vector<double> insert, remove, remove_one, move_one, round;
    std::vector<double> move_all;  // all of them, in units of the insertion of all
    std::vector<double> growth;    // of memory during the rounds, as a part of it
};

// One run on one handle, whose calls are timed.
class Run {
  public:
    Run(const ChurnOptions& options, const std::vector<double>& xyz, std::uint64_t seed)
        : t_(settings(options)), xyz_(xyz), random_(seed) {}

    void run(ChurnFigures& f) {
        const std::size_t n = xyz_.size() / 3, few = std::min(most_calls, n / 20 + 1);
        mgdt_triangulation* const t = t_.get();
        const auto count = [](std::size_t k) { return static_cast<std::int64_t>(k); };
        const auto timed = [&](std::size_t points, const auto& body) {
            check_interrupt();
            const auto start = std::chrono::steady_clock::now();
            body();
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() *
                   1e6 / static_cast<double>(points);
        };
        f.insert.push_back(
            timed(n, [&] { require(mgdt_insert_points(t, count(n), xyz_.data())); }));

        // A hundredth of the spacing that a uniform set of this extent has.
        move_a_little(0.01);
        f.move_all.push_back(
            timed(n, [&] { require(mgdt_move_points(t, count(n), nullptr, places_.data())); }) /
            f.insert.back());

        std::vector<std::int64_t> order(n);
        for (std::size_t i = 0; i < n; ++i) order[i] = count(i);
        std::shuffle(order.begin(), order.end(), random_);
        f.move_one.push_back(timed(few, [&] {
            for (std::size_t k = 0; k < few; ++k) {
                const std::int64_t i = order[k];
                require(mgdt_move_points(t, 1, &i, &xyz_[3 * static_cast<std::size_t>(i)]));
            }
        }));
        const std::size_t tenth = n / 10 + 1;
        f.remove.push_back(
            timed(tenth, [&] { require(mgdt_remove_points(t, count(tenth), order.data())); }));
        f.remove_one.push_back(timed(few, [&] {
            for (std::size_t k = 0; k < few; ++k)
                require(mgdt_remove_points(t, 1, &order[tenth + k]));
        }));
        std::vector<std::int64_t> index(n);
        require(mgdt_renumber_points(t, count(n), index.data()));

        // Rounds in which one point leaves and another comes.
        const double before = bytes();
        f.round.push_back(timed(few, [&] {
            for (std::size_t k = 0; k < few; ++k) {
                mgdt_status status = MGDT_ERR_INVALID_ARGUMENT;
                while (status == MGDT_ERR_INVALID_ARGUMENT) {  // it has left before
                    const std::int64_t i = count(static_cast<std::size_t>(random_()) %
                                                 static_cast<std::size_t>(mgdt_point_count(t)));
                    status = mgdt_remove_points(t, 1, &i);
                }
                require(status);
                require(mgdt_insert_points(t, 1, &xyz_[3 * (k % n)]));
            }
        }));
        require(mgdt_renumber_points(t, mgdt_point_count(t), room(index, t)));
        f.growth.push_back(bytes() / before - 1);
        require(mgdt_check(t, n > 200000 ? MGDT_CHECK_COMBINATORIAL : MGDT_CHECK_CANONICAL));
    }

  private:
    static TriangulationOptions settings(const ChurnOptions& options) {
        TriangulationOptions settings;
        settings.threads = options.threads;
        settings.compact = options.compact;
        settings.quiet = true;
        return settings;
    }
    static std::int64_t* room(std::vector<std::int64_t>& index, const mgdt_triangulation* t) {
        index.resize(static_cast<std::size_t>(mgdt_point_count(t)));
        return index.data();
    }
    void require(mgdt_status status) const {
        if (status == MGDT_OK) return;
        check_interrupt();
        char text[256] = "";
        mgdt_get_error(t_.get(), sizeof text, text);
        throw Error(status == MGDT_ERR_OUT_OF_MEMORY ? exit_memory : exit_internal,
                    fmt::format("--churn: {}", text));
    }
    double bytes() const {
        double value = 0;
        mgdt_get_stat(t_.get(), MGDT_STAT_MEMORY_BYTES, &value);
        return value;
    }
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
