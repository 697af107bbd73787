// SPDX-License-Identifier: MIT
// Times mgdt with one thread and with several on the same points in one run, interleaved, and
// prints medians, speed-ups, and what stands in the way of more of it.
//
//   threads [points [runs [threads,threads,... [distribution...]]]]
//
// "again" is the insertion of the same points once more after mgdt_clear, when the storage is there
// and no page has to come from the system, or a virtual machine's from its host. "work" is the
// processor time of all threads over that of one thread. "deferred" are insertions that met another
// thread and were tried again, "alone" points inserted while the other threads had nothing to do,
// both of 100 points. "bound" is the speed-up that these two leave with a core for each thread: 1 /
// (alone + (1 + deferred - alone) / threads).
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"

namespace {

struct Figures {
    std::vector<double> seconds, again, processor;
    double deferred = 0, alone = 0;
};

double stat(const mgdt_triangulation* t, int32_t key) {
    double value = 0;
    mgdt_get_stat(t, key, &value);
    return value;
}

bool run(const std::vector<double>& xyz, int32_t threads, Figures& f) {
    const auto n = static_cast<int64_t>(xyz.size() / 3);
    mgdt_triangulation* t = nullptr;
    mgdt_status status = mgdt_create(&t);
    if (status == MGDT_OK) status = mgdt_set_threads(t, threads);
    for (std::vector<double>* const times : {&f.seconds, &f.again}) {
        if (status == MGDT_OK) status = mgdt_clear(t);
        f.processor.push_back(bench::own_seconds([&] {
            times->push_back(bench::seconds([&] {
                if (status == MGDT_OK) status = mgdt_insert_points(t, n, xyz.data());
            }));
        }));
    }
    if (status != MGDT_OK) {
        std::fprintf(stderr, "threads: %s\n", mgdt_status_string(status));
        mgdt_destroy(t);
        return false;
    }
    f.deferred = stat(t, MGDT_STAT_PUT_OFF) / static_cast<double>(n);
    f.alone = stat(t, MGDT_STAT_INSERTED_ALONE) / static_cast<double>(n);
    mgdt_destroy(t);
    return true;
}

std::vector<int32_t> numbers(const std::string& text) {
    std::vector<int32_t> all;
    for (std::size_t at = 0; at < text.size();) {
        all.push_back(static_cast<int32_t>(std::atoi(text.c_str() + at)));
        const std::size_t comma = text.find(',', at);
        at = comma == std::string::npos ? text.size() : comma + 1;
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 4000000;
    const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
    const std::vector<int32_t> threads = numbers(argc > 3 ? argv[3] : "2");
    std::vector<std::string> kinds(argv + (argc > 4 ? 4 : argc), argv + argc);
    if (kinds.empty())
        kinds = {"uniform", "line", "diagonal", "ellipse", "spiral", "cluster", "galaxy"};
    std::printf("%zu points, medians of %d interleaved runs\n\n", n, runs);
    std::printf(
        "| set | threads | seconds | with one | speed-up | again | with one | speed-up | work | "
        "deferred %% | alone %% | bound |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const std::string& kind : kinds) {
        const std::vector<double> xyz = mgdt::cli::generate(kind, n, {});
        Figures one;
        std::vector<Figures> several(threads.size());
        for (int r = 0; r < runs; ++r) {
            if (!run(xyz, 1, one)) return 1;
            for (std::size_t i = 0; i < threads.size(); ++i)
                if (!run(xyz, threads[i], several[i])) return 1;
        }
        const double alone_seconds = bench::median(one.seconds);
        const double alone_again = bench::median(one.again);
        for (std::size_t i = 0; i < threads.size(); ++i) {
            const Figures& f = several[i];
            const double seconds = bench::median(f.seconds), again = bench::median(f.again);
            const double bound = 1 / (f.alone + (1 + f.deferred - f.alone) / threads[i]);
            std::printf(
                "| %s | %d | %.3f | %.3f | %.2f | %.3f | %.3f | %.2f | %.2f | %.3f | %.2f | %.1f "
                "|\n",
                kind.c_str(), static_cast<int>(threads[i]), seconds, alone_seconds,
                alone_seconds / seconds, again, alone_again, alone_again / again,
                bench::median(f.processor) / bench::median(one.processor), 100 * f.deferred,
                100 * f.alone, bound);
            std::fflush(stdout);
        }
    }
    return 0;
}
