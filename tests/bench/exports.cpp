// SPDX-License-Identifier: MIT
// Times everything that is exported as a share of the triangulation that it is exported from, with
// one thread and with several, interleaved, and prints medians.
//
//   exports [points [runs [threads [distribution...]]]]
//
// "first" exports of canonical output sort the tetrahedra too, which is done once a triangulation.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"

namespace {

struct Export {
    const char* name;
    bool canonical, sorts;  // for the first time
    std::int64_t (*size)(const mgdt_triangulation*);
    mgdt_status (*get)(const mgdt_triangulation*, std::int64_t, std::int64_t*);
};

std::int64_t corners(const mgdt_triangulation* t) {
    return 4 * mgdt_tetrahedron_count(t);
}
std::int64_t hull_corners(const mgdt_triangulation* t) {
    return 3 * mgdt_hull_facet_count(t);
}
std::int64_t ends(const mgdt_triangulation* t) {
    return 2 * mgdt_edge_count(t);
}
// Offsets and list, one after the other.
std::int64_t lists(const mgdt_triangulation* t) {
    return mgdt_point_count(t) + 1 + mgdt_vertex_tetrahedra_count(t);
}
mgdt_status get_lists(const mgdt_triangulation* t, std::int64_t capacity, std::int64_t* v) {
    const std::int64_t offsets = mgdt_point_count(t) + 1;
    return mgdt_get_vertex_tetrahedra(t, offsets, v, capacity - offsets, v + offsets);
}
std::int64_t neighbor_lists(const mgdt_triangulation* t) {
    return mgdt_point_count(t) + 1 + mgdt_vertex_neighbors_count(t);
}
mgdt_status get_neighbor_lists(const mgdt_triangulation* t, std::int64_t capacity,
                               std::int64_t* v) {
    const std::int64_t offsets = mgdt_point_count(t) + 1;
    return mgdt_get_vertex_neighbors(t, offsets, v, capacity - offsets, v + offsets);
}
template <mgdt_status (*Get)(const mgdt_triangulation*, std::int64_t, std::int64_t*, std::int64_t*)>
mgdt_status get_graph(const mgdt_triangulation* t, std::int64_t capacity, std::int64_t* v) {
    std::int64_t edges;
    return Get(t, capacity, v, &edges);
}
mgdt_status get_circumcenters(const mgdt_triangulation* t, std::int64_t capacity, std::int64_t* v) {
    static_assert(sizeof(double) == sizeof(std::int64_t), "the room is for doubles as well");
    double* const xyz = reinterpret_cast<double*>(v);
    return mgdt_get_circumcenters(t, capacity / 4, xyz, xyz + capacity / 4 * 3);
}

template <std::int32_t measure>
mgdt_status get_measure(const mgdt_triangulation* t, std::int64_t capacity, std::int64_t* v) {
    return mgdt_get_tetrahedron_measures(t, measure, capacity / 4, reinterpret_cast<double*>(v));
}

mgdt_status get_volumes(const mgdt_triangulation* t, std::int64_t capacity, std::int64_t* v) {
    return mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, nullptr, capacity,
                                  reinterpret_cast<double*>(v));
}

template <std::int32_t dimension>
mgdt_status get_alphas(const mgdt_triangulation* t, std::int64_t capacity, std::int64_t* v) {
    return mgdt_get_alphas(t, dimension, capacity, reinterpret_cast<double*>(v));
}

constexpr Export exports[] = {
    {"tetrahedra", false, false, corners, mgdt_get_tetrahedra},
    {"neighbours", false, false, corners, mgdt_get_neighbors},
    {"hull facets", false, false, hull_corners, mgdt_get_hull_facets},
    {"edges", false, false, ends, mgdt_get_edges},
    {"point map", false, false, mgdt_point_count, mgdt_get_point_map},
    {"tetrahedra of vertices", false, false, lists, get_lists},
    {"neighbours of vertices", false, false, neighbor_lists, get_neighbor_lists},
    {"Gabriel edges", false, false, ends, get_graph<mgdt_get_gabriel_edges>},
    {"spanning tree", false, false, ends, get_graph<mgdt_get_spanning_tree>},
    {"circumcentres", false, false, corners, get_circumcenters},
    {"volumes of tetrahedra", false, false, corners, get_measure<MGDT_TETRAHEDRON_VOLUME>},
    {"radius ratios", false, false, corners, get_measure<MGDT_TETRAHEDRON_RADIUS_RATIO>},
    {"least angles", false, false, corners, get_measure<MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE>},
    {"alphas of facets", false, false, corners, get_alphas<2>},
    {"alphas of edges", false, false, mgdt_edge_count, get_alphas<1>},
    {"volumes of cells", false, false, mgdt_point_count, get_volumes},
    {"canonical tetrahedra, first", true, true, corners, mgdt_get_tetrahedra},
    {"canonical tetrahedra, again", true, false, corners, mgdt_get_tetrahedra},
    {"canonical neighbours", true, false, corners, mgdt_get_neighbors},
    {"canonical hull facets", true, false, hull_corners, mgdt_get_hull_facets},
    {"canonical edges", true, false, ends, mgdt_get_edges},
    {"canonical tetrahedra of vertices", true, false, lists, get_lists},
};

void require(mgdt_status status) {
    if (status == MGDT_OK) return;
    std::fprintf(stderr, "exports: %s\n", mgdt_status_string(status));
    std::exit(1);
}

double measure(mgdt_triangulation* t, const Export& e, std::int32_t threads,
               std::vector<std::int64_t>& room) {
    require(mgdt_set_threads(t, threads));
    const auto size = static_cast<std::size_t>(e.size(t));
    if (room.size() < size) room.resize(size);
    // Numbers are made anew where they are part of what is measured, and are there otherwise.
    if (e.sorts || !e.canonical) require(mgdt_set_canonical_output(t, e.canonical ? 1 : 0));
    if (!e.canonical) {
        std::int64_t place;
        const double origin[3] = {0, 0, 0};
        require(mgdt_locate(t, origin, &place));
    }
    return bench::seconds([&] { require(e.get(t, e.size(t), room.data())); });
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t n = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
    const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
    const std::int32_t threads = argc > 3 ? std::atoi(argv[3]) : 2;
    std::vector<std::string> kinds(argv + (argc > 4 ? 4 : argc), argv + argc);
    if (kinds.empty()) kinds = {"uniform"};
    for (const std::string& kind : kinds) {
        const std::vector<double> xyz = mgdt::cli::generate(kind, n, {});
        std::vector<double> whole;
        std::vector<double> seconds[std::size(exports)][2];
        std::vector<std::int64_t> room;
        for (int r = 0; r < runs; ++r) {
            mgdt_triangulation* t = nullptr;
            require(mgdt_create(&t));
            whole.push_back(bench::seconds(
                [&] { require(mgdt_insert_points(t, static_cast<std::int64_t>(n), xyz.data())); }));
            for (std::size_t k = 0; k < std::size(exports); ++k) {
                if (r == 0) measure(t, exports[k], 1, room);  // so that the room has its pages
                seconds[k][0].push_back(measure(t, exports[k], 1, room));
                seconds[k][1].push_back(measure(t, exports[k], threads, room));
            }
            mgdt_destroy(t);
        }
        const double all = bench::median(whole);
        std::printf("%zu %s points, triangulated by one thread in %.3f s, medians of %d runs\n\n",
                    n, kind.c_str(), all, runs);
        std::printf(
            "| export | seconds | of the triangulation %% | seconds, %d threads | ratio |\n",
            static_cast<int>(threads));
        std::printf("|---|---|---|---|---|\n");
        for (std::size_t k = 0; k < std::size(exports); ++k) {
            const double one = bench::median(seconds[k][0]), many = bench::median(seconds[k][1]);
            std::printf("| %s | %.4f | %.1f | %.4f | %.2f |\n", exports[k].name, one,
                        100 * one / all, many, one / many);
        }
        std::printf("\n");
    }
    return 0;
}
