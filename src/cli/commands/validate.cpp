// SPDX-License-Identifier: MIT
// mgdt validate: finds the facets that cross or touch where they must not.
#include <fmt/core.h>

#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/domain_program.hpp"
#include "cli/errors.hpp"
#include "cli/formats/grid.hpp"
#include "cli/interrupt.hpp"

namespace mgdt::cli {
namespace {

struct ValidateOptions {
    InputOptions input;
    OutputOptions output;  // a .vtp file of what offends, or empty
    int threads = 1;
    std::uint64_t memory_limit = 0;
    bool repairable = false;  // say what cleaning would mend
    bool quiet = false;
};

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

// Finds what offends. Returns the pairs.
std::vector<OffendingPair> find_offences(Domain& domain, const std::string& name) {
    check_interrupt();
    try {
        domain.validate();
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_BOUNDARY) rethrow_failure(name, domain.last_error());
    } catch (...) {
        rethrow_failure(name, domain.last_error());
    }
    return offending_pairs(domain);
}

// Says what cleaning would mend, exactly and with distances, until a step leaves no pair and no
// open edge.
void print_repairs(const Mesh& mesh, const ValidateOptions& options, const std::string& name) {
    for (const double weld : {0.0, 1e-12, 1e-9, 1e-6}) {
        Domain domain = make_domain(mesh, options.threads, options.memory_limit, name);
        check_interrupt();
        std::string done;
        try {
            done = clean(domain, {true, weld, 0});
        } catch (...) {
            rethrow_failure(name, domain.last_error());
        }
        const std::size_t pairs = find_offences(domain, name).size();
        const std::size_t open = domain.array(DomainArray::open_edges).size() / 3;
        fmt::print("{}: {}; {} left{}\n", weld == 0 ? "--clean" : fmt::format("--weld {:g}", weld),
                   done, pairs == 0 ? "no pair is" : counted(pairs, "pair is", "pairs are"),
                   pairs > 0 ? ""
                             : fmt::format(", {}", open == 0 ? "no edge is open"
                                                             : counted(open, "edge is open",
                                                                       "edges are open")));
        if (pairs == 0 && open == 0) return;
    }
}

int validate_surface(const ValidateOptions& options) {
    const std::string name = input_name(options.input.path);
    if (!options.output.path.empty()) check_writable(options.output.path);
    const Mesh mesh = read_facets(options.input);
    require_apart(mesh.inputs, {options.output.path});
    Domain domain = make_domain(mesh, options.threads, options.memory_limit, name);
    const std::vector<OffendingPair> pairs = find_offences(domain, name);
    if (!options.output.path.empty()) {
        OutputSet outputs;
        write_vtk_facets(facets_of(pairs, mesh), options.output.write.compress,
                         outputs.open(options.output.path));
        outputs.commit();
    }
    if (!options.quiet)
        for (const OffendingPair& pair : pairs) fmt::print("{}\n", describe(pair));
    if (options.repairable) print_repairs(mesh, options, name);
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

}  // namespace

const Command validate_command = {
    "validate", "Read a surface, list all facets that cross or touch where they must not.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<ValidateOptions>();
        add_facets_input(app, options->input);
        app.add_option("-o,--output", options->output.path,
                       "Write what offends too, as .vtp for ParaView")
            ->type_name("FILE");
        add_compress(app, options->output);
        app.add_flag("--repairable", options->repairable,
                     "Say what mgdt mesh --clean and --weld would mend, and what they would leave");
        add_limits(app, options->threads, options->memory_limit);
        app.add_flag("-q,--quiet", options->quiet, "Print nothing but errors");
        app.footer(formats_and_exit_codes);
        return [options] { return validate_surface(*options); };
    }};

}  // namespace mgdt::cli
