// SPDX-License-Identifier: MIT
// mgdt mesh: fills what facets enclose with tetrahedra.
#include <fmt/core.h>

#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/domain_program.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/mesh_program.hpp"
#include "cli/mesh_refinement.hpp"
#include "cli/progress.hpp"
#include "cli/unused_points.hpp"

namespace mgdt::cli {
namespace {

struct MeshOptions {
    InputOptions input;
    OutputOptions output;
    std::vector<double> holes;    // three numbers for each
    std::vector<double> regions;  // three numbers and the marker for each
    bool check = false;
    bool rounded = false;        // write rounded points, which facets cover exactly
    bool keeps_surface = false;  // add points inside only
    bool strict = false;         // refuse a mesh that leaves out a part of the input
    bool all_points = false;     // also write points that are in no tetrahedron
    bool improve = false;        // improve the tetrahedra before they are written
    bool not_improved = false;   // do not improve a refined mesh
    ImproveOptions improvement;
    RefineOptions refinement;
    CleanOptions cleaning;
    int threads = 1;
    std::uint64_t memory_limit = 0;  // bytes, 0 for none
    bool quiet = false;
};

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

// Cleans the domain if that is asked for. Returns a line that says what was done.
std::string clean(Domain& domain, const std::string& name, const MeshOptions& options) {
    if (!options.cleaning.is_asked_for()) return "";
    check_interrupt();
    Progress progress("cleaning", options.quiet);
    domain.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
    try {
        std::string done = clean(domain, options.cleaning);
        domain.clear_progress();
        return "cleaned: " + done + "\n";
    } catch (...) {
        rethrow_failure(name, domain.last_error());
    }
}

mgdt::Mesh build(Domain& domain, const std::string& name, const MeshOptions& options) {
    check_interrupt();
    Progress progress("meshing", options.quiet);
    domain.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
    try {
        if (options.rounded) domain.set_option(DomainOption::round_points, 1);
        if (options.strict) domain.set_option(DomainOption::strict, 1);
        if (options.keeps_surface) domain.set_option(DomainOption::keep_boundary, 1);
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

int mesh_surface(const MeshOptions& options) {
    const OutputOptions& output = options.output;
    std::vector<std::string> files;
    const Format& format = mesh_format(output, files);
    for (const std::string& file : files) check_writable(file);
    const std::string name = input_name(options.input.path);
    WriteOptions write;
    Mesh mesh;
    std::size_t n_facets = 0, n_points = 0, n_steiner = 0, n_regions = 0;
    std::string said;  // of cleaning and improvement
    {
        Mesh input = read_facets(options.input);
        require_apart(input.inputs, {output.path});
        add_places(options, input);
        n_facets = input.facets.size();
        n_points = input.point_count();
        Domain domain = make_domain(input, options.threads, options.memory_limit, name);
        said = clean(domain, name, options);
        mgdt::Mesh made = build(domain, name, options);
        if (!options.quiet) warn_of_losses(made, name);
        const bool is_refined = options.refinement.is_asked_for();
        if (is_refined) set_boundary(made, options.improvement);
        if (is_refined) said += refine_mesh(made, options.refinement, options.quiet, name);
        const bool is_improved = options.improve || (is_refined && !options.not_improved);
        if (is_improved) said += improve_mesh(made, options.improvement, options.quiet, name);
        if (options.check && (is_refined || is_improved)) require_sound(made, name);
        n_steiner = static_cast<std::size_t>(made.statistic(MeshStatistic::steiner_points));
        n_regions = static_cast<std::size_t>(made.statistic(MeshStatistic::regions));
        mesh = mesh_of(made);
        mesh.faces.names = input.facets.names;
        write = options_after(input, &format, output.write);
    }
    if (!options.all_points) take_out_unused_points(mesh);
    OutputSet outputs;
    format.write_mesh(mesh, output.path, outputs, write);
    if (format.write_neighbors) format.write_neighbors(mesh.neighbors, output.path, outputs, write);
    outputs.commit();
    if (!options.quiet && output.path != "-") fmt::print("{}", said);
    if (!options.quiet && output.path != "-")
        fmt::print("{}, {}, {} added, {}, {}{}: {}\n", counted(n_facets, "facet", "facets"),
                   counted(n_points, "point", "points"), n_steiner,
                   counted(n_regions, "region", "regions"),
                   counted(mesh.tetrahedron_count(), "tetrahedron", "tetrahedra"),
                   options.check ? ", checked" : "", printable(output.path));
    return exit_ok;
}

}  // namespace

const Command mesh_command = {
    "mesh", "Read a closed surface, write tetrahedra that fill it.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<MeshOptions>();
        add_facets_input(app, options->input);
        add_output(app, options->output, true);
        add_index_base(app, options->output);
        add_compress(app, options->output);
        app.add_option("--hole", options->holes,
                       "Leave what facets enclose around this place empty; may be repeated")
            ->delimiter(',')
            ->type_name("X,Y,Z");
        app.add_option("--region", options->regions,
                       "Give the tetrahedra around this place a marker; may be repeated")
            ->delimiter(',')
            ->type_name("X,Y,Z,N");
        CLI::Option* const improve = app.add_flag(
            "--improve", options->improve,
            "Improve the tetrahedra: exchange edges and faces, move and insert points");
        app.add_flag("--no-improve", options->not_improved,
                     "Leave a mesh with wanted sizes as its refinement has made it")
            ->excludes(improve);
        add_refinement(app, options->refinement);
        add_improvement(app, options->improvement, {"all", "slide"});
        app.add_flag("--check", options->check, "Prove the mesh before writing");
        app.add_flag("--rounded", options->rounded,
                     "Write points rounded to 2^-36 of the largest coordinate, so that facets are "
                     "covered exactly");
        app.add_flag("--strict", options->strict,
                     "Refuse a mesh that leaves out facets, points, regions or holes");
        app.add_flag("--keep-surface", options->keeps_surface,
                     "Keep every facet and every segment as it is, and add points inside only; an "
                     "improvement keeps the boundary fixed then");
        app.add_flag("--all-points", options->all_points,
                     "Also write points that are in no tetrahedron");
        add_cleaning(app, options->cleaning);
        add_limits(app, options->threads, options->memory_limit);
        app.add_flag("-q,--quiet", options->quiet, "Print nothing but errors");
        app.footer(formats_and_exit_codes);
        return [options, &app] {
            if (options->keeps_surface && app.count("--boundary") == 0)
                options->improvement.boundary = "fixed";
            const bool is_improved =
                options->improve || (options->refinement.is_asked_for() && !options->not_improved);
            for (const char* const name : improvement_options)
                if (app.count(name) > 0 && !is_improved)
                    throw Error(exit_usage, fmt::format("{} needs --improve", name));
            return mesh_surface(*options);
        };
    }};

}  // namespace mgdt::cli
