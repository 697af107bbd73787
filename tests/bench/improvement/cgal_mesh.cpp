// SPDX-License-Identifier: MIT
// Meshes a solid with CGAL, without its optimisers and then with them, for versus_peers.py. Links
// gmp and mpfr.
//
// usage: cgal_mesh SHAPE SIZE BEFORE AFTER
//
// SHAPE is ball, torus or balls, SIZE the largest circumradius. Each file gets two counts, the
// points, and the corners of the tetrahedra, from 0. The processor time of the optimisers, in
// seconds, is printed.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

// Functions that are negative inside.
double ball(const Kernel::Point_3& p) {
    return p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - 0.36;
}
double torus(const Kernel::Point_3& p) {
    const double around = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 0.8;
    return around * around + p.z() * p.z() - 0.0625;
}
// Two balls that melt into each other.
double balls(const Kernel::Point_3& p) {
    const double side = p.y() * p.y() + p.z() * p.z();
    return 1.7 - 0.2 / ((p.x() - 0.4) * (p.x() - 0.4) + side + 0.01) -
           0.2 / ((p.x() + 0.4) * (p.x() + 0.4) + side + 0.01);
}

bool write(const Complex& mesh, const char* path) {
    std::FILE* const file = std::fopen(path, "w");
    if (file == nullptr) return false;
    std::map<Complex::Vertex_handle, std::size_t> numbers;
    std::vector<Complex::Vertex_handle> vertices;
    for (auto cell = mesh.cells_in_complex_begin(); cell != mesh.cells_in_complex_end(); ++cell)
        for (int i = 0; i < 4; ++i)
            if (numbers.emplace(cell->vertex(i), vertices.size()).second)
                vertices.push_back(cell->vertex(i));
    std::fprintf(file, "%zu %zu\n", vertices.size(),
                 static_cast<std::size_t>(mesh.number_of_cells_in_complex()));
    for (const Complex::Vertex_handle v : vertices)
        std::fprintf(file, "%.17g %.17g %.17g\n", v->point().x(), v->point().y(), v->point().z());
    for (auto cell = mesh.cells_in_complex_begin(); cell != mesh.cells_in_complex_end(); ++cell)
        std::fprintf(file, "%zu %zu %zu %zu\n", numbers[cell->vertex(0)], numbers[cell->vertex(1)],
                     numbers[cell->vertex(2)], numbers[cell->vertex(3)]);
    return std::fclose(file) == 0;
}

}  // namespace

int main(int argc, char** argv) {
    namespace params = CGAL::parameters;
    const std::map<std::string, double (*)(const Kernel::Point_3&)> shapes = {
        {"ball", ball}, {"torus", torus}, {"balls", balls}};
    if (argc != 5 || shapes.count(argv[1]) == 0) return 2;
    const double size = std::atof(argv[2]);
    const Domain domain = Domain::create_implicit_mesh_domain(
        shapes.at(argv[1]), Kernel::Sphere_3(CGAL::ORIGIN, 4), params::relative_error_bound = 1e-6);
    const Criteria criteria(params::facet_angle = 25, params::facet_size = size,
                            params::facet_distance = size / 10, params::cell_radius_edge_ratio = 2,
                            params::cell_size = size);
    Complex mesh =
        CGAL::make_mesh_3<Complex>(domain, criteria, params::no_perturb(), params::no_exude());
    if (!write(mesh, argv[3])) return 1;
    const std::clock_t begin = std::clock();
    CGAL::perturb_mesh_3(mesh, domain);
    CGAL::exude_mesh_3(mesh);
    std::printf("%.6f\n", static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    return write(mesh, argv[4]) ? 0 : 1;
}
