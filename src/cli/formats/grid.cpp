// SPDX-License-Identifier: MIT
#include "cli/formats/grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "cli/formats/vtk_file.hpp"
#include "cli/formats/xml.hpp"

namespace mgdt::cli {
namespace {

// The numbers of an array that stays where it is.
VtkArray numbers(std::uint64_t most, const char* name, const std::vector<std::int64_t>& values) {
    return vtk_integers(most, name, values.size(),
                        [&values](std::uint64_t i) { return values[static_cast<std::size_t>(i)]; });
}

std::vector<VtkArray> arrays_of(const std::vector<Field>& fields) {
    std::vector<VtkArray> arrays;
    arrays.reserve(fields.size() + 1);  // the numbers of points may follow
    for (const Field& f : fields)
        arrays.push_back(vtk_doubles(to_xml(f.name), f.components, f.values));
    return arrays;
}

std::string counts_of_grid(std::uint64_t points, std::uint64_t cells) {
    return fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", points, cells);
}

}  // namespace

void write_grid(const Grid& grid, OutputFile& out) {
    const std::uint64_t points = grid.points.size() / 3,
                        corners = grid.vertices ? grid.vertices->size() : points,
                        bodies = corners / grid.size,
                        faces = grid.faces != nullptr ? grid.faces->size() : 0,
                        cells = bodies + faces, all_corners = corners + 3 * faces;
    VtkFile file = {"UnstructuredGrid", counts_of_grid(points, cells), {}, grid.is_compressed};
    file.sections.push_back({"Points", {vtk_doubles("Points", 3, grid.points)}});
    file.sections.push_back(
        {"Cells",
         {vtk_integers(points, "connectivity", all_corners,
                       [&](std::uint64_t i) {
                           if (i >= corners)
                               return std::int64_t{
                                   grid.faces->corners[static_cast<std::size_t>(i - corners)]};
                           return grid.vertices ? (*grid.vertices)[i]
                                                : static_cast<std::int64_t>(i);
                       }),
          vtk_integers(all_corners, "offsets", cells,
                       [&](std::uint64_t i) {
                           return static_cast<std::int64_t>(
                               i < bodies ? grid.size * (i + 1) : corners + 3 * (i - bodies + 1));
                       }),
          vtk_array<std::uint8_t>("UInt8", "Name=\"types\"", cells, [&](std::uint64_t i) {
              return i < bodies ? grid.type : vtk_triangle;
          })}});
    std::vector<VtkArray> of_points = arrays_of(grid.fields);
    if (grid.ids != nullptr) of_points.push_back(numbers(~std::uint64_t{0}, "point", *grid.ids));
    if (!of_points.empty()) file.sections.push_back({"PointData", of_points});
    if (grid.regions != nullptr)
        file.sections.push_back(
            {"CellData",
             {vtk_array<std::int32_t>("Int32", "Name=\"region\"", cells,
                                      [&](std::uint64_t i) {
                                          return i < bodies
                                                     ? (*grid.regions)[static_cast<std::size_t>(i)]
                                                     : 0;
                                      }),
              vtk_array<std::int32_t>("Int32", "Name=\"facet\"", cells, [&](std::uint64_t i) {
                  return i < bodies ? 0 : grid.faces->markers[static_cast<std::size_t>(i - bodies)];
              })}});
    write_vtk_file(file, out);
}

// See "Polyhedron" in VTK's file formats: types are 42, and the arrays `faces` and `faceoffsets`
// follow the usual ones.
void write_polyhedra(const Polyhedra& polyhedra, OutputFile& out) {
    const std::uint64_t points = polyhedra.points.size() / 3, cells = polyhedra.offsets.size();
    VtkFile file = {"UnstructuredGrid", counts_of_grid(points, cells), {}, polyhedra.is_compressed};
    std::vector<VtkArray> measures = arrays_of(polyhedra.measures);
    measures.push_back(numbers(~std::uint64_t{0}, "point", polyhedra.ids));
    file.sections.push_back({"CellData", measures});
    file.sections.push_back({"Points", {vtk_doubles("Points", 3, polyhedra.points)}});
    file.sections.push_back(
        {"Cells",
         {numbers(points, "connectivity", polyhedra.corners),
          numbers(polyhedra.corners.size(), "offsets", polyhedra.offsets),
          vtk_array<std::uint8_t>("UInt8", "Name=\"types\"", cells,
                                  [](std::uint64_t) { return vtk_polyhedron; }),
          numbers(std::max<std::uint64_t>(points, polyhedra.faces.size()), "faces",
                  polyhedra.faces),
          numbers(polyhedra.faces.size(), "faceoffsets", polyhedra.face_offsets)}});
    write_vtk_file(file, out);
}

// VTK numbers the cells of a file in the order of vertices, lines, polygons.
void write_vtk_facets(const VtkFacets& facets, bool is_compressed, OutputFile& out) {
    const std::uint64_t points = facets.points.size() / 3, vertices = facets.vertices.size(),
                        lines = facets.lines.size() / 2, polygons = facets.offsets.size();
    const std::size_t before = static_cast<std::size_t>(vertices + lines);
    std::vector<std::int64_t> numbers_of(before, -1), pairs_of(before, 0);
    numbers_of.insert(numbers_of.end(), facets.facets.begin(), facets.facets.end());
    pairs_of.insert(pairs_of.end(), facets.pairs.begin(), facets.pairs.end());
    VtkFile file = {"PolyData",
                    fmt::format("NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                                "NumberOfStrips=\"0\" NumberOfPolys=\"{}\"",
                                points, vertices, lines, polygons),
                    {},
                    is_compressed};
    const auto rows = [](std::uint64_t count, std::uint64_t size) {
        return vtk_integers(count * size, "offsets", count,
                            [size](std::uint64_t i) { return size * (i + 1); });
    };
    file.sections.push_back({"CellData",
                             {numbers(~std::uint64_t{0}, "facet", numbers_of),
                              numbers(~std::uint64_t{0}, "pairs", pairs_of)}});
    file.sections.push_back({"Points", {vtk_doubles("Points", 3, facets.points)}});
    file.sections.push_back(
        {"Verts", {numbers(points, "connectivity", facets.vertices), rows(vertices, 1)}});
    file.sections.push_back(
        {"Lines", {numbers(points, "connectivity", facets.lines), rows(lines, 2)}});
    file.sections.push_back({"Polys",
                             {numbers(points, "connectivity", facets.corners),
                              numbers(facets.corners.size(), "offsets", facets.offsets)}});
    write_vtk_file(file, out);
}

void write_vtk_surface(const Surface& surface, bool is_compressed, OutputFile& out) {
    const std::uint64_t points = surface.point_count(), triangles = surface.triangle_count();
    VtkFile file = {"PolyData",
                    fmt::format("NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
                                "NumberOfStrips=\"0\" NumberOfPolys=\"{}\"",
                                points, triangles),
                    {},
                    is_compressed};
    file.sections.push_back({"Points", {vtk_doubles("Points", 3, surface.points)}});
    file.sections.push_back(
        {"Polys",
         {vtk_integers(
              points, "connectivity", surface.triangles.size(),
              [&](std::uint64_t i) { return surface.triangles[static_cast<std::size_t>(i)]; }),
          vtk_integers(3 * triangles, "offsets", triangles,
                       [](std::uint64_t i) { return 3 * (i + 1); })}});
    write_vtk_file(file, out);
}

}  // namespace mgdt::cli
