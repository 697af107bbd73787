// SPDX-License-Identifier: MIT
// CGAL's Delaunay triangulation of the points in a file of doubles, written as TetGen's elements:
// a mesh of another program, for the check to judge.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstdio>
#include <utility>
#include <vector>

int main(int argc, char** argv) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<unsigned, Kernel>;
    using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
    using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
    if (argc != 3) return 2;
    std::FILE* in = std::fopen(argv[1], "rb");
    if (!in) return 3;
    std::vector<std::pair<Kernel::Point_3, unsigned>> points;
    double x[3];
    while (std::fread(x, sizeof x, 1, in) == 1)
        points.emplace_back(Kernel::Point_3(x[0], x[1], x[2]),
                            static_cast<unsigned>(points.size()));
    std::fclose(in);
    const CGAL::Delaunay_triangulation_3<Kernel, Structure> mesh(points.begin(), points.end());
    std::FILE* out = std::fopen(argv[2], "w");
    if (!out) return 4;
    std::fprintf(out, "%zu 4 0\n", static_cast<std::size_t>(mesh.number_of_finite_cells()));
    unsigned number = 0;
    for (auto cell = mesh.finite_cells_begin(); cell != mesh.finite_cells_end(); ++cell)
        std::fprintf(out, "%u %u %u %u %u\n", number++, cell->vertex(0)->info(),
                     cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info());
    return std::fclose(out) == 0 ? 0 : 4;
}
