// SPDX-License-Identifier: MIT
// Looks for the sets of points that suit mgdt least: families of sets, sizes and ways of use, each
// timed against CGAL in turns, so that both meet the same noise. Prints the worst ten by the ratio
// of CGAL's time to mgdt's, then all of them, worst first.
//
//   sweep_cgal [--sizes N,N,...] [--runs N] [--modes MODE,MODE,...] [--threads N,N,...]
//              [--worst N] [--verbose] [FAMILY...]
//
// Modes:
//   batch    all points in one call, against CGAL's insertion of a range
//   single   one point a call, in the order given; against CGAL with its Fast_location policy, as
//            all modes that follow
//   locate   single locations, near vertices and between pairs of them
//   box      single locations, anywhere in the bounding box
//   nearest  single nearest vertices of places near vertices and between them
//   threads  all points in one call, one thread against each number of --threads (2); sets are as
//            many times larger as two threads want; CGAL has no part in it
//
// Seconds are those of the processor, which depend less on what else the machine does, but for
// threads. FAMILY is a part of a family's name; without any, all families are taken. A measurement
// is repeated
// --runs times unless it takes more than half a second.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../support/points.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"
#include "sweep_families.hpp"

namespace {

using mgdt_tests::Points;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Compact = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;

struct Destroy {
    void operator()(mgdt_triangulation* t) const noexcept { mgdt_destroy(t); }
};
using Handle = std::unique_ptr<mgdt_triangulation, Destroy>;

void require(mgdt_status status, const char* call) {
    if (status == MGDT_OK) return;
    throw std::runtime_error(std::string(call) + ": " + mgdt_status_string(status));
}

Handle inserted(const Points& xyz, std::int32_t threads = 1) {
    mgdt_triangulation* t = nullptr;
    require(mgdt_create(&t), "mgdt_create");
    Handle handle(t);
    require(mgdt_set_threads(t, threads), "mgdt_set_threads");
    require(mgdt_insert_points(t, static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            "mgdt_insert_points");
    return handle;
}

Handle inserted_one_by_one(const Points& xyz) {
    mgdt_triangulation* t = nullptr;
    require(mgdt_create(&t), "mgdt_create");
    Handle handle(t);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        require(mgdt_insert_points(t, 1, &xyz[i]), "mgdt_insert_points");
    return handle;
}

std::vector<Point> to_points(const Points& xyz) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    return points;
}

// ------------------------------------------------------------------------------------ options

struct Options {
    std::vector<std::size_t> sizes = {1000};
    int runs = 3;
    bool is_verbose = false;
    std::size_t worst = 10;
    std::vector<int> threads = {2};
    std::vector<std::string> modes, families;

    bool has_mode(const char* mode) const {
        return modes.empty() || std::find(modes.begin(), modes.end(), mode) != modes.end();
    }
    bool has_family(const std::string& name) const {
        return families.empty() ||
               std::any_of(families.begin(), families.end(),
                           [&](const std::string& f) { return name.find(f) != std::string::npos; });
    }
};

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        parts.push_back(text.substr(at, comma - at));
        at = comma + 1;
    }
    return parts;
}

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto value = [&] {
            if (++i == argc) throw std::runtime_error(argument + " wants a value");
            return std::string(argv[i]);
        };
        if (argument == "--sizes") {
            options.sizes.clear();
            for (const std::string& part : parts_of(value()))
                options.sizes.push_back(std::max<std::size_t>(std::stoul(part), 100));
        } else if (argument == "--runs") {
            options.runs = std::max(1, std::stoi(value()));
        } else if (argument == "--verbose") {
            options.is_verbose = true;
        } else if (argument == "--worst") {
            options.worst = std::stoul(value());
        } else if (argument == "--threads") {
            options.threads.clear();
            for (const std::string& part : parts_of(value()))
                options.threads.push_back(std::stoi(part));
        } else if (argument == "--modes") {
            options.modes = parts_of(value());
        } else if (argument.compare(0, 2, "--") == 0) {
            throw std::runtime_error("unknown option " + argument);
        } else {
            options.families.push_back(argument);
        }
    }
    return options;
}

// ------------------------------------------------------------------------------------ measuring

struct Result {
    std::string family, mode;
    std::size_t points;
    double ours, theirs;  // microseconds a point, or a call
    double ratio() const { return theirs / ours; }
};

using Body = std::function<void()>;

void print(std::FILE* out, const Result& r) {
    std::fprintf(out, "%-44s %-10s %8zu %10.3f %10.3f %8.3f\n", r.family.c_str(), r.mode.c_str(),
                 r.points, r.ours, r.theirs, r.ratio());
}

class Sweep {
  public:
    explicit Sweep(const Options& options) : options_(options) {}

    void run(const bench::Family& family, std::size_t size) {
        const Points xyz = family.points(std::min(size, family.most));
        const std::size_t n = xyz.size() / 3;
        const std::vector<Point> points = to_points(xyz);
        const auto measure = [&](const char* mode, std::size_t count, const Body& ours,
                                 const Body& theirs) {
            add({family.name, mode, n, 0, 0}, count, ours, theirs);
        };
        if (options_.has_mode("batch")) {
            Handle t;
            std::unique_ptr<Compact> c;
            measure(
                "batch", n, [&] { t.reset(), t = inserted(xyz); },
                [&] {
                    c = std::make_unique<Compact>();
                    c->insert(points.begin(), points.end());
                });
            compare(family.name, *t, *c);
        }
        if (options_.has_mode("single")) {
            Handle t;
            std::unique_ptr<Fast> c;
            measure(
                "single", n, [&] { t.reset(), t = inserted_one_by_one(xyz); },
                [&] {
                    c = std::make_unique<Fast>();
                    for (const Point& p : points) c->insert(p);
                });
            compare(family.name, *t, *c);
        }
        if (options_.has_mode("locate") || options_.has_mode("box") || options_.has_mode("nearest"))
            find(family.name, xyz, points);
        if (options_.has_mode("threads")) {
            const Points more = family.points(std::min(30 * size, 4 * family.most));
            const std::size_t count = more.size() / 3;
            for (const int threads : options_.threads)
                if (count >= 2 * 8192)
                    add(
                        {family.name, std::to_string(threads) + " threads", count, 0, 0}, count,
                        [&] { inserted(more, threads); }, [&] { inserted(more, 1); });
        }
    }

    const std::vector<Result>& results() const { return results_; }

  private:
    // Calls that look for places.
    void find(const std::string& name, const Points& xyz, const std::vector<Point>& points) {
        const std::size_t n = points.size(), calls = 1000;
        const Handle t = inserted(xyz);
        Fast c;
        c.insert(points.begin(), points.end());
        const auto measure = [&](const char* mode, const Points& places, bool is_nearest) {
            if (!options_.has_mode(mode)) return;
            const std::vector<Point> their_places = to_points(places);
            std::int64_t found = 0;
            typename Fast::Cell_handle cell;
            typename Fast::Vertex_handle vertex;
            const Body ours = [&] {
                for (std::size_t i = 0; i < places.size(); i += 3)
                    require((is_nearest ? mgdt_nearest_vertex : mgdt_locate)(t.get(), &places[i],
                                                                             &found),
                            mode);
            };
            const Body theirs = [&] {
                for (const Point& p : their_places) {
                    if (is_nearest)
                        vertex = c.nearest_vertex(p);
                    else
                        cell = c.locate(p);
                }
            };
            ours();  // makes what helps to find places
            add({name, mode, n, 0, 0}, calls, ours, theirs);
        };
        std::mt19937_64 random(9);
        const auto any = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
        Points near, box;
        double low[3], high[3];
        for (unsigned k = 0; k < 3; ++k) low[k] = high[k] = xyz[k];
        for (std::size_t i = 0; i < xyz.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], xyz[i]);
            high[i % 3] = std::max(high[i % 3], xyz[i]);
        }
        for (std::size_t i = 0; i < calls; ++i) {
            const double *const a = &xyz[3 * (random() % n)], *const b = &xyz[3 * (random() % n)];
            for (unsigned k = 0; k < 3; ++k) {
                near.push_back(i % 2 == 0 ? a[k] / 2 + b[k] / 2
                                          : a[k] * (1 + 1e-3 * (any() - 0.5)));
                const double share = any();
                box.push_back(low[k] * (1 - share) + high[k] * share);
            }
        }
        for (double& x : near) x = std::max(-DBL_MAX, std::min(DBL_MAX, x));
        measure("locate", near, false);
        measure("box", box, false);
        measure("nearest", near, true);
    }

    void add(Result result, std::size_t count, const Body& ours, const Body& theirs) {
        const auto seconds = result.mode.find("threads") != std::string::npos
                                 ? bench::seconds<Body>
                                 : bench::processor_seconds<Body>;
        std::vector<double> our_times, their_times;
        double total = 0;
        for (int run = 0; run < options_.runs && (run == 0 || total < 0.5); ++run) {
            our_times.push_back(seconds(ours));
            their_times.push_back(seconds(theirs));
            total += our_times.back() + their_times.back();
        }
        result.ours = 1e6 * bench::median(our_times) / static_cast<double>(count);
        result.theirs = 1e6 * bench::median(their_times) / static_cast<double>(count);
        results_.push_back(result);
        if (options_.is_verbose) print(stderr, result);
    }

    template <class Cgal>
    static void compare(const std::string& name, const mgdt_triangulation& t, const Cgal& c) {
        if (c.dimension() == 3 &&
            static_cast<std::size_t>(mgdt_tetrahedron_count(&t)) != c.number_of_finite_cells())
            throw std::runtime_error(name + ": mgdt and CGAL differ in their tetrahedra");
    }

    const Options& options_;
    std::vector<Result> results_;
};

void print(const std::vector<Result>& results, std::size_t count) {
    std::printf("%-44s %-10s %8s %10s %10s %8s\n", "family", "mode", "points", "mgdt us",
                "other us", "ratio");
    for (std::size_t i = 0; i < std::min(count, results.size()); ++i) print(stdout, results[i]);
}

}  // namespace

int main(int argc, char** argv) try {
    const Options options = parse(argc, argv);
    Sweep sweep(options);
    const double seconds = bench::seconds([&] {
        for (const bench::Family& family : bench::sweep_families())
            for (const std::size_t size : options.sizes)
                if (options.has_family(family.name)) sweep.run(family, size);
    });
    std::vector<Result> results = sweep.results();
    std::stable_sort(results.begin(), results.end(),
                     [](const Result& a, const Result& b) { return a.ratio() < b.ratio(); });
    std::printf("%zu measurements in %.0f s, medians of up to %d interleaved runs\n\nthe worst\n",
                results.size(), seconds, options.runs);
    print(results, options.worst);
    std::printf("\nall\n");
    print(results, results.size());
    return 0;
} catch (const std::exception& e) {
    std::printf("%s\n", e.what());
    return 1;
}
