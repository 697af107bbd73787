// SPDX-License-Identifier: MIT
// The program mgdt-bench: measures order schemes, and other libraries, on distributions of points.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "bench/benchmark.hpp"
#include "cli/data_directory.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_triangulation.hpp"
#include "cli/system.hpp"

namespace mgdt::cli::bench {
namespace {

// The command line, so that it can be typed again.
std::string command_line(const std::vector<std::string>& words) {
    std::string line = "mgdt-bench";
    for (std::size_t i = 1; i < words.size(); ++i) line += " " + words[i];
    return line;
}

void add_options(CLI::App& app, BenchOptions& options) {
    using Names = std::vector<std::string>;
    app.add_option("--distributions", options.plan.distributions,
                   "Distributions (default: the seven of the paper), see below")
        ->delimiter(',')
        ->type_name("LIST");
    CLI::Option* sizes =
        app.add_option("--sizes", options.sizes, "Numbers of points, such as 1e5,1e6 (default 1e6)")
            ->delimiter(',')
            ->type_name("LIST");
    app.add_option("--schemes", options.plan.schemes,
                   "Orders of insertion (default auto): " +
                       fmt::format("{}", fmt::join(scheme_names(), ", ")))
        ->delimiter(',')
        ->type_name("LIST");
    app.add_option("--threads", options.plan.threads,
                   "Numbers of threads; 0 for all cores (default 1)")
        ->delimiter(',')
        ->check(CLI::Range(0, 1 << 20))
        ->type_name("LIST");
    app.add_flag("--compact", options.plan.compact, "Time compact storage too, in turns");
    app.add_option("--runs", options.plan.runs, "Runs of each (default 3, with --paper 1)")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N");
    app.add_option("--seed", options.plan.seed,
                   "Seed of the points and of the schemes that shuffle (default 1)")
        ->type_name("N");
    app.add_option("--time-limit", options.time_limit, "Most time of a run (default: none)")
        ->check(CLI::PositiveNumber)
        ->type_name("SECONDS");
    CLI::Option* paper =
        app.add_flag("--paper", options.plan.paper, "What the paper ran in its tables 1 to 9")
            ->excludes(sizes);
    app.add_flag("--churn", options.churn,
                 "Time points that leave and move, not insertions; prints a table alone")
        ->excludes(paper);
    app.add_option("--largest", options.largest, "Largest of the paper's sets (default 2e6)")
        ->needs(paper)
        ->type_name("N");
    app.add_option_function<Names>(
           "--peers",
           [&options](const Names& names) {
               for (const std::string& name : names) {
                   if (!name.empty()) options.plan.peers.push_back(name);
               }
               if (options.plan.peers.empty()) options.plan.peers = peer_names;
           },
           "Time these too, in turns: cgal,tetgen,qhull (default: all)")
        ->delimiter(',')
        ->expected(0, 3)
        ->type_name("LIST");
    app.add_option("--peer-directory", options.peer_directory,
                   "Where the peers' runners are (default: in the program's build folder)")
        ->envname("MGDT_PEERS")
        ->type_name("DIR");
    app.add_option("--csv", options.csv,
                   "Table to write a line a run to; started again, goes on from there")
        ->type_name("FILE");
    app.add_option("--json", options.json, "File to write at the end; - for standard output")
        ->type_name("FILE");
    app.add_option("--data", options.data_directory, "Where machine.msh and church.msh are")
        ->envname("MGDT_DATA")
        ->type_name("DIR");
    app.add_flag("-q,--quiet", options.quiet, "Print nothing but errors and the medians");
    app.footer(fmt::format("Distributions: {}\n\nExit codes are those of mgdt: see mgdt --help",
                           fmt::join(distribution_names(), ", ")));
}

// The options; nothing for --help and --version.
std::optional<BenchOptions> parse(const std::vector<std::string>& words) {
    BenchOptions options;
    options.command = command_line(words);
    options.data_directory = default_data_directory();
    CLI::App app("Measure order schemes, and other libraries, on distributions of points.",
                 "mgdt-bench");
    app.set_version_flag("--version", fmt::format("mgdt-bench {}", version()));
    add_options(app, options);
    try {
        // CLI11 takes arguments in reverse order.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend() - (words.empty() ? 0 : 1)));
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() != 0)
            throw Error(exit_usage, fmt::format("{}; see mgdt-bench --help", e.what()));
        app.exit(e);
        return std::nullopt;
    }
    return options;
}

}  // namespace
}  // namespace mgdt::cli::bench

int main(int argc, char** argv) {
    using namespace mgdt::cli;
    try {
        install_signal_handlers();
        const auto options = bench::parse(system::arguments(argc, argv));
        const int code = options ? bench::run(*options) : exit_ok;
        // Reports what could not be written to standard output.
        if (std::fflush(stdout) != 0) throw Error(exit_output, "standard output: cannot write");
        return code;
    } catch (...) {
        return report_exception(stderr);
    }
}
