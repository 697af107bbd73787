// SPDX-License-Identifier: MIT
#include "bench/runs.hpp"

#include <fmt/core.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <sstream>

#include "bench/child.hpp"
#include "bench/status.hpp"
#include "cli/errors.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli::bench {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

// A child writes lines "progress FRACTION" and, at the end, "figures" with the figures of the row,
// one word each.
constexpr const char* progress_word = "progress";
constexpr const char* figures_word = "figures";
constexpr const char* no_figure = "-";

struct Reporter {
    int out;
    steady_clock::time_point last;

    void report(double fraction) {
        const auto now = steady_clock::now();
        // Reports are rare, so that they do not slow small sets down.
        if (now - last < std::chrono::milliseconds(100)) return;
        last = now;
        send(out, fmt::format("{} {:.3f}", progress_word, fraction));
    }
};

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// The processor time that all threads of this process have used.
struct ProcessorTime {
    ProcessorTime() {
        rusage usage = {};
        getrusage(RUSAGE_SELF, &usage);
        user = seconds_of(usage.ru_utime);
        system = seconds_of(usage.ru_stime);
    }
    double user, system;
};

Figures figures_of(const Triangulation& t, double seconds, double user, double system) {
    const auto stat = [&t](Statistic key) { return t.statistic(key); };
    Figures f{};
    const double in = stat(Statistic::points_inserted);
    if (in > 0) {
        f[walked] = stat(Statistic::walk_steps) / in;
        f[removed] = stat(Statistic::tetrahedra_removed) / in;
        f[created] = stat(Statistic::tetrahedra_created) / in;
    }
    f[order_seconds] = stat(Statistic::order_seconds);
    f[insert_seconds] = stat(Statistic::insert_seconds);
    f[total_seconds] = seconds;
    f[system_seconds] = system;
    f[user_seconds] = user;
    if (const std::int64_t n = t.point_count(); n > 0) {
        f[bytes_per_point] = stat(Statistic::peak_memory_bytes) / static_cast<double>(n);
    }
    f[inserted] = in;
    f[duplicates] = stat(Statistic::duplicates);
    f[tetrahedra] = static_cast<double>(t.tetrahedron_count());
    f[levels] = stat(Statistic::grid_levels);
    f[rounds] = stat(Statistic::rounds);
    if (const double points = in + f[duplicates].value();
        points > 0 && stat(Statistic::threads) > 1)
        f[alone_percent] = 100 * stat(Statistic::inserted_alone) / points;
    return f;
}

void triangulate_in_child(int out, const PointSet& set, const Row& row) {
    const std::vector<double> points = set.read();
    TriangulationOptions options;
    options.scheme = row.plain_scheme();
    options.compact = row.compact();
    options.threads = row.threads;
    options.seed = row.seed;
    Reporter reporter{out, steady_clock::now()};
    const ProcessorTime before;
    const auto begin = steady_clock::now();
    Triangulation t = make_triangulation(options);
    t.set_progress([&](double fraction) { reporter.report(fraction); });
    try {
        t.insert(points);
    } catch (...) {
        rethrow_failure(row.distribution, t.last_error());
    }
    const double seconds = duration<double>(steady_clock::now() - begin).count();
    const ProcessorTime after;
    std::string line = figures_word;
    for (const std::optional<double>& figure :
         figures_of(t, seconds, after.user - before.user, after.system - before.system)) {
        line += figure ? fmt::format(" {}", *figure) : std::string(" ") + no_figure;
    }
    send(out, line);
    // The process ends without destroying the triangulation.
    _exit(exit_ok);
}

bool read_figures(const std::string& line, Figures& figures) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != figures_word) return false;
    for (std::optional<double>& figure : figures) {
        if (!(words >> word)) return false;
        if (word != no_figure) figure = std::stod(word);
    }
    return true;
}

// Replaces the child process, which calls this function, by the runner.
int execute(const std::string& runner, int input, int out) {
    dup2(input, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    close(out);
    // Ignored signals stay ignored in a new program.
    signal(SIGPIPE, SIG_DFL);
    signal(SIGXFSZ, SIG_DFL);
    execl(runner.c_str(), runner.c_str(), static_cast<char*>(nullptr));
    send(STDOUT_FILENO, fmt::format("cannot run {}: {}", runner, system_message(errno)));
    return exit_internal;
}

}  // namespace

void run_mgdt(const PointSet& set, double time_limit, const Watcher& watch, Row& row) {
    double fraction = 0;
    const ChildEnd end = run_in_child(
        [&](int out) { return guarded(out, [&] { triangulate_in_child(out, set, row); }); },
        time_limit,
        [&](const std::string& line) {
            std::istringstream words(line);
            std::string word;
            if (words >> word && word == progress_word) words >> fraction;
            watch(fraction);
        });
    row.status = status_of(end);
    if (!row.ok()) return;
    if (!read_figures(end.last_line, row.figures)) {
        row.status = "error: no figures from the child";
        return;
    }
    row.figures[peak_rss_bytes] = static_cast<double>(end.peak_rss_bytes);
}

void run_peer(const PointSet& set, const std::string& runner, double time_limit,
              const Watcher& watch, Row& row) {
    const ChildEnd end = run_in_child([&](int out) { return execute(runner, set.file(), out); },
                                      time_limit, [&](const std::string&) { watch(0); });
    row.status = status_of(end);
    if (!row.ok()) return;
    std::istringstream words(end.last_line);
    double seconds = 0, count = 0, bytes = 0, user = 0;
    if (!(words >> row.version >> seconds >> count >> bytes)) {
        row.status = "error: not a runner's line: " + as_field(end.last_line);
        return;
    }
    row.version = as_field(row.version);
    row.figures[total_seconds] = seconds;
    row.figures[tetrahedra] = count;
    if (words >> user) row.figures[user_seconds] = user;
    if (set.points() > 0) {
        row.figures[bytes_per_point] = bytes / static_cast<double>(set.points());
    }
    row.figures[peak_rss_bytes] = static_cast<double>(end.peak_rss_bytes);
}

}  // namespace mgdt::cli::bench
