// SPDX-License-Identifier: MIT
// mgdt mesh: fill what facets enclose with tetrahedra. mgdt validate: find the facets that cross or
// touch where they must not.
#include <fmt/core.h>

#include <algorithm>

#include "cli/domain_program.hpp"
#include "cli/errors.hpp"
#include "cli/formats/grid.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/unused_points.hpp"

namespace mgdt::cli {
namespace {

std::string name_of(DomainKind kind, std::int64_t number) {
    const char* const what = kind == DomainKind::facet     ? "facet"
                             : kind == DomainKind::segment ? "segment"
                                                           : "point";
    return fmt::format("{} {}", what, number);
}

std::string describe(const OffendingPair& pair) {
    const std::string first = name_of(pair.kinds[0], pair.numbers[0]);
    if (pair.kinds[0] == pair.kinds[1] && pair.numbers[0] == pair.numbers[1])
        return first +
               (pair.kinds[0] == DomainKind::segment ? " has no length" : " is flat or no polygon");
    return first + " meets " + name_of(pair.kinds[1], pair.numbers[1]);
}

// Where a surface is open: three numbers for each edge that one facet alone has.
std::string describe_openings(const std::vector<std::int64_t>& edges) {
    if (edges.empty()) return "";
    return fmt::format("; {} to one facet alone, the first from point {} to point {} to facet {}",
                       counted(edges.size() / 3, "edge belongs", "edges belong"), edges[0],
                       edges[1], edges[2]);
}

// The facets that offend, with their points.
VtkFacets facets_of(const std::vector<OffendingPair>& pairs, const Mesh& mesh) {
    VtkFacets out;
    out.points = mesh.points;
    std::vector<std::int64_t> count(mesh.facets.size());
    for (const OffendingPair& pair : pairs)
        for (int k = 0; k < 2; ++k) {
            const std::int64_t number = pair.numbers[k];
            const bool is_first =
                k == 0 || pair.kinds[0] != pair.kinds[1] || number != pair.numbers[0];
            if (!is_first) continue;
            if (pair.kinds[k] == DomainKind::facet) {
                ++count[static_cast<std::size_t>(number)];
            } else if (pair.kinds[k] == DomainKind::segment) {
                for (int e = 0; e < 2; ++e)
                    out.lines.push_back(
                        mesh.facets.segments[static_cast<std::size_t>(2 * number + e)]);
            } else {
                out.vertices.push_back(number);
            }
        }
    for (std::size_t f = 0; f < count.size(); ++f) {
        if (count[f] == 0) continue;
        for (auto i = mesh.facets.begin[f]; i < mesh.facets.begin[f + 1]; ++i)
            out.corners.push_back(mesh.facets.corners[static_cast<std::size_t>(i)]);
        out.offsets.push_back(static_cast<std::int64_t>(out.corners.size()));
        out.facets.push_back(static_cast<std::int64_t>(f));
        out.pairs.push_back(count[f]);
    }
    return out;
}

void require_numbers(std::size_t numbers, std::size_t each, const char* option) {
    if (numbers % each != 0)
        throw Error(exit_usage, fmt::format("{} takes {} numbers", option, each));
}

void add_places(const MeshOptions& options, Mesh& mesh) {
    require_numbers(options.holes.size(), 3, "--hole");
    require_numbers(options.regions.size(), 4, "--region");
    for (std::size_t i = 0; i < options.holes.size(); i += 3)
        mesh.facets.holes.push_back(
            {{options.holes[i], options.holes[i + 1], options.holes[i + 2]}, 0});
    for (std::size_t i = 0; i < options.regions.size(); i += 4) {
        const double marker = options.regions[i + 3];
        if (!(marker >= -0x1p31 && marker < 0x1p31) || marker != static_cast<std::int32_t>(marker))
            throw Error(exit_usage,
                        fmt::format("--region: the marker {} is no 32-bit integer", marker));
        mesh.facets.regions.push_back(
            {{options.regions[i], options.regions[i + 1], options.regions[i + 2]},
             static_cast<std::int32_t>(marker)});
    }
}

// Checks a mesh, and compares it with its domain.
void check(const Domain& domain, const mgdt::Mesh& mesh, const std::string& name) {
    bool is_own = true;
    try {
        mesh.check();
        is_own = false;
        domain.check(mesh);
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_CHECK_FAILED)
            throw Error(exit_check_failed,
                        fmt::format("{}: the mesh fails its check: {}; please report this", name,
                                    e.what()));
        rethrow_failure(name, is_own ? mesh.last_error() : domain.last_error());
    } catch (...) {
        rethrow_failure(name, is_own ? mesh.last_error() : domain.last_error());
    }
}

mgdt::Mesh build(Domain& domain, const std::string& name, const MeshOptions& options) {
    check_interrupt();
    Progress progress("meshing", options.quiet);
    domain.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
    try {
        if (options.rounded) domain.set_option(DomainOption::round_points, 1);
        if (options.strict) domain.set_option(DomainOption::strict, 1);
        mgdt::Mesh mesh = domain.build();
        domain.clear_progress();
        if (options.check) check(domain, mesh, name);
        return mesh;
    } catch (const Error&) {
        throw;
    } catch (...) {
        rethrow_failure(name, domain.last_error());
    }
}

// Says what the mesh leaves out.
void warn_of_losses(const mgdt::Mesh& mesh, const std::string& name) {
    const auto warn = [&](MeshStatistic of, const char* one, const char* many, const char* why) {
        const auto count = static_cast<std::size_t>(mesh.statistic(of));
        if (count > 0)
            fmt::print(stderr, "mgdt: {}: warning: {} {}\n", name, counted(count, one, many), why);
    };
    warn(MeshStatistic::unused_faces, "face of the surface", "faces of the surface",
         "at no tetrahedron: what is open encloses nothing (mgdt validate shows open edges)");
    warn(MeshStatistic::unused_regions, "region", "regions", "outside of the mesh");
    warn(MeshStatistic::unused_holes, "hole", "holes", "in nothing that the facets enclose");
    warn(MeshStatistic::unused_points, "point", "points", "in no tetrahedron");
}

// Adds the faces that are at a tetrahedron.
void add_faces(const mgdt::Mesh& made, Mesh& mesh) {
    const std::vector<MeshIndex> corners = made.array<MeshIndex>(MeshArray::faces),
                                 tetrahedra = made.array<MeshIndex>(MeshArray::face_tetrahedra),
                                 markers = made.array<MeshIndex>(MeshArray::face_markers);
    for (std::size_t f = 0; f < markers.size(); ++f) {
        const MeshIndex front = tetrahedra[2 * f], back = tetrahedra[2 * f + 1],
                        t = back >= 0 ? back : front;
        if (t < 0) continue;
        const MeshIndex* const face = &corners[3 * f];
        const MeshIndex* const tetrahedron = &mesh.tetrahedra[4 * static_cast<std::size_t>(t)];
        std::uint32_t k = 0;
        while (std::find(face, face + 3, tetrahedron[k]) != face + 3) ++k;
        mesh.faces.corners.insert(mesh.faces.corners.end(), face, face + 3);
        mesh.faces.markers.push_back(markers[f]);
        mesh.faces.sides.push_back(4 * static_cast<std::uint32_t>(t) + k);
    }
}

// The mesh, with the points that were read first.
Mesh mesh_of(const mgdt::Mesh& made) {
    Mesh mesh;
    mesh.has_tetrahedra = true;
    const std::vector<Point> points = made.points();
    mesh.points.reserve(3 * points.size());
    for (const Point& p : points) mesh.points.insert(mesh.points.end(), p.begin(), p.end());
    mesh.tetrahedra = made.array<MeshIndex>(MeshArray::tetrahedra);
    mesh.neighbors = made.array<MeshIndex>(MeshArray::neighbors);
    const std::vector<MeshIndex> markers = made.array<MeshIndex>(MeshArray::region_markers);
    for (const MeshIndex region : made.array<MeshIndex>(MeshArray::tetrahedron_regions))
        mesh.regions.push_back(markers[static_cast<std::size_t>(region)]);
    add_faces(made, mesh);
    return mesh;
}

const Format& tetrahedra_format(const OutputOptions& output) {
    const Format& format = output_format(output.path, output.to);
    if (!format.write_mesh)
        throw Error(exit_usage,
                    fmt::format("{} ({}) has no place for tetrahedra; write .vtu, .msh, "
                                ".mesh, .inp, .vtk or .ele",
                                format.name, format.description));
    require_compressible(output.write, format);
    check_terminal(output, format);
    for (const std::string& path :
         format.mesh_files ? format.mesh_files(output.path) : std::vector<std::string>{output.path})
        check_writable(path);
    return format;
}

}  // namespace

int mesh_surface(const MeshOptions& options) {
    const OutputOptions& output = options.output;
    const Format& format = tetrahedra_format(output);
    const std::string name = input_name(options.input.path);
    WriteOptions write;
    Mesh mesh;
    std::size_t n_facets = 0, n_points = 0, n_steiner = 0, n_regions = 0;
    {
        Mesh input = read_facets(options.input);
        require_apart(input.inputs, {output.path});
        add_places(options, input);
        n_facets = input.facets.size();
        n_points = input.point_count();
        Domain domain = make_domain(input, options.threads, options.memory_limit, name);
        const mgdt::Mesh made = build(domain, name, options);
        n_steiner = static_cast<std::size_t>(made.statistic(MeshStatistic::steiner_points));
        n_regions = static_cast<std::size_t>(made.statistic(MeshStatistic::regions));
        if (!options.quiet) warn_of_losses(made, name);
        mesh = mesh_of(made);
        mesh.faces.names = input.facets.names;
        write = options_after(input, &format, output.write);
    }
    if (!options.all_points) take_out_unused_points(mesh);
    OutputSet outputs;
    format.write_mesh(mesh, output.path, outputs, write);
    if (format.write_neighbors) format.write_neighbors(mesh.neighbors, output.path, outputs, write);
    outputs.commit();
    if (!options.quiet && output.path != "-")
        fmt::print("{}, {}, {} added, {}, {}{}: {}\n", counted(n_facets, "facet", "facets"),
                   counted(n_points, "point", "points"), n_steiner,
                   counted(n_regions, "region", "regions"),
                   counted(mesh.tetrahedron_count(), "tetrahedron", "tetrahedra"),
                   options.check ? ", checked" : "", printable(output.path));
    return exit_ok;
}

int validate_surface(const ValidateOptions& options) {
    const std::string name = input_name(options.input.path);
    if (!options.output.path.empty()) check_writable(options.output.path);
    const Mesh mesh = read_facets(options.input);
    require_apart(mesh.inputs, {options.output.path});
    Domain domain = make_domain(mesh, options.threads, options.memory_limit, name);
    check_interrupt();
    try {
        domain.validate();
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_BOUNDARY) rethrow_failure(name, domain.last_error());
    } catch (...) {
        rethrow_failure(name, domain.last_error());
    }
    const std::vector<OffendingPair> pairs = offending_pairs(domain);
    if (!options.output.path.empty()) {
        OutputSet outputs;
        write_vtk_facets(facets_of(pairs, mesh), options.output.write.compress,
                         outputs.open(options.output.path));
        outputs.commit();
    }
    if (!options.quiet)
        for (const OffendingPair& pair : pairs) fmt::print("{}\n", describe(pair));
    if (!pairs.empty())
        throw Error(exit_check_failed,
                    fmt::format("{}: {} of facets, segments or points cross, touch where they must "
                                "not, or are flat",
                                name, counted(pairs.size(), "pair", "pairs")));
    if (!options.quiet)
        fmt::print("{}: {} and {} meet in common corners and edges only{}\n", name,
                   counted(mesh.facets.size(), "facet", "facets"),
                   counted(mesh.point_count(), "point", "points"),
                   describe_openings(domain.array(DomainArray::open_edges)));
    return exit_ok;
}

}  // namespace mgdt::cli
