// SPDX-License-Identifier: MIT
// Volumes of the cells of points in a box, triangulation included, beside Voro++; and the diagram
// of the cells as an object. Medians of interleaved runs, and how far the sums are from the volume
// of the box. The second table is for the same points in a periodic box.
//
//   cells_versus_voro [points [runs [distribution...]]]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>
#include <voro++/voro++.hh>

#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.hpp"

namespace {

// A little larger than the points, which Voro++ wants inside.
struct Box {
    double low[3], high[3];
    double volume() const { return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); }
};

Box around(const std::vector<double>& xyz) {
    Box box{};
    for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = box.high[k] = xyz[k];
        for (std::size_t i = k; i < xyz.size(); i += 3) {
            box.low[k] = std::min(box.low[k], xyz[i]);
            box.high[k] = std::max(box.high[k], xyz[i]);
        }
        const double margin = 1e-3 * (box.high[k] - box.low[k]);
        box.low[k] -= margin;
        box.high[k] += margin;
    }
    return box;
}

mgdt::Triangulation triangulation_of(const std::vector<double>& xyz) {
    mgdt::Triangulation t;
    if (mgdt_insert_points(t.handle(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data()) !=
        MGDT_OK)
        std::abort();
    return t;
}

std::vector<std::array<double, 4>> planes_of(const Box& box) {
    std::vector<std::array<double, 4>> planes;
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 4> above{}, below{};
        above[k] = 1;
        above[3] = box.high[k];
        below[k] = -1;
        below[3] = -box.low[k];
        planes.push_back(above);
        planes.push_back(below);
    }
    return planes;
}

double of_mgdt(const std::vector<double>& xyz, const Box& box) {
    const mgdt::Triangulation t = triangulation_of(xyz);
    double sum = 0;
    for (const double v : t.cell_measures(mgdt::Measure::volume, planes_of(box))) sum += v;
    return sum;
}

double of_diagram(const std::vector<double>& xyz, const Box& box) {
    const mgdt::Voronoi diagram(triangulation_of(xyz), planes_of(box));
    double sum = 0;
    for (const double v : diagram.doubles(mgdt::VoronoiDoubles::cell_volumes)) sum += v;
    return sum;
}

mgdt::Periodic periodic_of(const std::vector<double>& xyz, const Box& box) {
    std::array<double, 9> vectors{};
    for (std::size_t k = 0; k < 3; ++k) vectors[4 * k] = box.high[k] - box.low[k];
    mgdt::Periodic p(vectors);
    p.insert(xyz);
    p.build();
    return p;
}

double of_periodic(const std::vector<double>& xyz, const Box& box) {
    double sum = 0;
    for (const double v : periodic_of(xyz, box).cell_measures(mgdt::Measure::volume)) sum += v;
    return sum;
}

double of_periodic_diagram(const std::vector<double>& xyz, const Box& box) {
    const mgdt::Voronoi diagram = periodic_of(xyz, box).voronoi();
    double sum = 0;
    for (const double v : diagram.doubles(mgdt::VoronoiDoubles::cell_volumes)) sum += v;
    return sum;
}

double of_voro(const std::vector<double>& xyz, const Box& box, bool is_periodic) {
    // Six points a block, as its manual advises.
    const double n = static_cast<double>(xyz.size()) / 3;
    const int blocks = std::max(1, static_cast<int>(std::cbrt(n / 6)));
    voro::container all(box.low[0], box.high[0], box.low[1], box.high[1], box.low[2], box.high[2],
                        blocks, blocks, blocks, is_periodic, is_periodic, is_periodic, 8);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        all.put(static_cast<int>(i / 3), xyz[i], xyz[i + 1], xyz[i + 2]);
    double sum = 0;
    voro::c_loop_all loop(all);
    voro::voronoicell cell;
    if (loop.start()) do
            if (all.compute_cell(cell, loop)) sum += cell.volume();
        while (loop.inc());
    return sum;
}

using Sum = double (*)(const std::vector<double>&, const Box&);

void print_heading(const char* title) {
    std::printf(
        "%s\n\n| points | volumes, us a point | sum - 1 | Voro++ | sum - 1 | ratio | diagram | "
        "sum - 1 |\n|---|---|---|---|---|---|---|---|\n",
        title);
}

void measure(const std::string& name, std::size_t n, int runs, Sum volumes, Sum diagram,
             bool is_periodic) {
    const std::vector<double> xyz = mgdt::cli::generate(name, n, {});
    const Box box = around(xyz);
    std::vector<double> ours, theirs, diagrams;
    double our_sum = 0, their_sum = 0, diagram_sum = 0;
    for (int run = 0; run < runs; ++run) {
        ours.push_back(bench::seconds([&] { our_sum = volumes(xyz, box); }));
        diagrams.push_back(bench::seconds([&] { diagram_sum = diagram(xyz, box); }));
        theirs.push_back(bench::seconds([&] { their_sum = of_voro(xyz, box, is_periodic); }));
    }
    const double per = 1e6 * 3 / static_cast<double>(xyz.size());
    const double us = bench::median(ours), them = bench::median(theirs);
    std::printf("| %s | %.3f | %.1e | %.3f | %.1e | %.2f | %.3f | %.1e |\n", name.c_str(), us * per,
                our_sum / box.volume() - 1, them * per, their_sum / box.volume() - 1, them / us,
                bench::median(diagrams) * per, diagram_sum / box.volume() - 1);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100000;
    const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
    std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
    if (names.empty()) names = {"uniform"};
    print_heading("Points in a box");
    for (const std::string& name : names) measure(name, n, runs, of_mgdt, of_diagram, false);
    print_heading("\nPoints in a periodic box");
    for (const std::string& name : names)
        measure(name, n, runs, of_periodic, of_periodic_diagram, true);
}
