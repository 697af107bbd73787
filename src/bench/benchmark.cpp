// SPDX-License-Identifier: MIT
// What mgdt-bench measures: distributions, sizes, order schemes, threads and peers, each run in a
// process of its own.
#include "bench/benchmark.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "bench/churn.hpp"
#include "bench/json.hpp"
#include "bench/peers.hpp"
#include "bench/result_file.hpp"
#include "bench/runs.hpp"
#include "bench/summary.hpp"
#include "bench/table.hpp"
#include "cli/counts.hpp"
#include "cli/data_directory.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/opening.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli::bench {
namespace {

PlanOptions plan_options(const BenchOptions& options) {
    PlanOptions plan = options.plan;
    for (const std::string& size : options.sizes) {
        plan.sizes.push_back(parse_point_count("--sizes", size));
        if (plan.sizes.back() == 0) throw Error(exit_usage, "--sizes: at least 1 is needed");
    }
    if (!options.largest.empty()) plan.largest = parse_point_count("--largest", options.largest);
    return plan;
}

class Benchmark {
  public:
    explicit Benchmark(const BenchOptions& options)
        : options_(options),
          plan_(make_plan(plan_options(options))),
          out_(options.json == "-" ? stderr : stdout) {
        for (const PlannedSet& set : plan_.sets) {
            check_data(set.name.distribution, options.data_directory);
        }
        if (!options.json.empty()) check_writable(options.json);
        std::vector<std::string> outputs;
        for (const std::string& file : {options.csv, options.json})
            if (!file.empty()) outputs.push_back(file);
        std::vector<std::string> names;
        for (const PlannedSet& set : plan_.sets) names.push_back(set.name.distribution);
        require_apart(data_files(names, options.data_directory), outputs);
        if (options.csv == "-") {
            throw Error(exit_usage, "--csv: standard output cannot be read back; name a file");
        }
        if (!options.csv.empty()) file_.emplace(options.csv);
        if (file_) {
            for (const Row& row : file_->rows()) known_.emplace(row.key(), row);
        }
        look_for_runners();
    }

    int run() {
        announce();
        for (const PlannedSet& set : plan_.sets) run_set(set);
        print_summary(out_, medians(done_), options_.plan.peers);
        if (!options_.json.empty()) {
            OutputSet outputs;
            write_json(outputs.open(options_.json), options_.command, done_);
            outputs.commit();
        }
        report_missing();
        require_success();
        return exit_ok;
    }

  private:
    // Removes the rows of peers without a runner from the plan, unless the file has them.
    void look_for_runners() {
        for (const std::string& peer : options_.plan.peers) {
            const std::string runner = find_runner(peer, options_.peer_directory);
            if (!runner.empty()) {
                runners_[peer] = runner;
                continue;
            }
            missing_.push_back(peer);
            for (PlannedSet& set : plan_.sets) {
                const auto lost = [&](const Row& row) {
                    return row.library == peer && known_.count(row.key()) == 0;
                };
                set.rows.erase(std::remove_if(set.rows.begin(), set.rows.end(), lost),
                               set.rows.end());
            }
        }
    }

    void report_missing() const {
        for (const std::string& peer : missing_) {
            fmt::print(stderr, "mgdt: {}\n", how_to_get_runner(peer, options_.peer_directory));
        }
    }

    void announce() const {
        report_missing();
        if (options_.quiet) return;
        std::size_t here = 0;
        for (const PlannedSet& set : plan_.sets) {
            for (const Row& row : set.rows) here += known_.count(row.key());
        }
        if (here > 0) {
            fmt::print(out_, "{} of {} runs are in {} already\n", here, plan_.row_count(),
                       printable(options_.csv));
        }
        if (!plan_.left_out.empty()) {
            fmt::print(out_, "left out, larger than --largest: {}\n",
                       fmt::join(plan_.left_out, ", "));
        }
        print_heading(out_);
    }

    void run_set(const PlannedSet& set) {
        std::optional<PointSet> points;
        for (const Row& planned : set.rows) {
            ++number_;
            if (const auto known = known_.find(planned.key()); known != known_.end()) {
                done_.push_back(known->second);
                continue;
            }
            if (!points) {
                Progress progress(
                    fmt::format("points of {} {}", set.name.distribution, set.name.points),
                    options_.quiet);
                points.emplace(set.name, options_.data_directory, [&] { progress.update(0); });
            }
            Row row = planned;
            row.status = points->status();
            if (row.ok()) run_row(*points, row);
            if (row.status.empty()) stop();
            if (row.library == "mgdt") row.version = mgdt_version_string();
            if (file_) file_->append(row);
            if (!options_.quiet) print_row(out_, row);
            done_.push_back(row);
        }
    }

    void run_row(const PointSet& points, Row& row) const {
        Progress progress(fmt::format("{}/{} {} {} {}", number_, plan_.row_count(),
                                      row.distribution, row.points, row.contender()),
                          options_.quiet);
        const Watcher watch = [&](double fraction) { progress.update(fraction); };
        if (row.library == "mgdt") {
            run_mgdt(points, options_.time_limit, watch, row);
        } else {
            run_peer(points, runners_.at(row.library), options_.time_limit, watch, row);
        }
    }

    [[noreturn]] void stop() const {
        throw Error(exit_signal + interrupt_signal(),
                    file_ ? fmt::format("cancelled; the same command goes on from the {} that {} "
                                        "has",
                                        counted(done_.size(), "run", "runs"), options_.csv)
                          : "cancelled; nothing was written");
    }

    // Failures of peers and exceeded time limits are results. Failures of mgdt are errors.
    void require_success() const {
        const Row* first = nullptr;
        std::size_t failed = 0;
        for (const Row& row : done_) {
            if (row.library != "mgdt" || row.ok() || row.status == "timeout") continue;
            if (failed++ == 0) first = &row;
        }
        if (first != nullptr) {
            // The system sends signal 9 if its memory runs out.
            const bool memory = first->status == "out-of-memory" || first->status == "signal 9";
            throw Error(memory ? exit_memory : exit_internal,
                        fmt::format("{} of mgdt failed; the first on {} {} with {}: {}",
                                    counted(failed, "run", "runs"), first->distribution,
                                    first->points, first->scheme, first->status));
        }
        const std::string difference = disagreement(done_);
        if (!difference.empty()) {
            throw Error(exit_internal, "the runs of mgdt differ: " + difference);
        }
    }

    const BenchOptions& options_;
    Plan plan_;
    std::FILE* out_;
    std::optional<ResultFile> file_;
    std::map<std::string, Row> known_;  // the rows that the file has, by their keys
    std::map<std::string, std::string> runners_;
    std::vector<std::string> missing_;
    std::vector<Row> done_;
    std::size_t number_ = 0;
};

}  // namespace

int run(const BenchOptions& options) {
    if (options.churn) {
        const bool has_others = !options.csv.empty() || !options.json.empty() ||
                                !options.plan.peers.empty() || !options.plan.schemes.empty() ||
                                options.time_limit > 0 || options.plan.threads.size() > 1;
        if (has_others) {
            throw Error(exit_usage,
                        "--churn takes --distributions, --sizes, --runs, --seed, "
                        "--compact and one number of --threads alone");
        }
        const Plan plan = make_plan(plan_options(options));
        ChurnOptions churn;
        for (const PlannedSet& set : plan.sets) {
            check_data(set.name.distribution, options.data_directory);
            churn.sets.push_back(set.name);
        }
        if (!options.plan.threads.empty()) churn.threads = options.plan.threads.front();
        if (options.plan.runs > 0) churn.runs = options.plan.runs;
        churn.compact = options.plan.compact;
        churn.data_directory = options.data_directory;
        run_churn(churn);
        return exit_ok;
    }
    return Benchmark(options).run();
}

}  // namespace mgdt::cli::bench
