// SPDX-License-Identifier: MIT
#include "cli/domain_program.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {

Mesh read_facets(InputOptions input) {
    input.read.has_facets = input.needs_facets = true;
    const Format* format = nullptr;
    Mesh mesh = read_input(input, &format);
    const std::string name = input_name(input.path);
    if (!format->has_facets) {
        std::vector<std::string> known;
        for (const Format* const f : all_formats())
            if (f->has_facets)
                known.insert(known.end(), f->extensions.begin(), f->extensions.end());
        throw Error(exit_usage, fmt::format("{}: facets are not read from {} files; they are read "
                                            "from {}",
                                            name, format->name, fmt::join(known, ", ")));
    }
    if (mesh.facets.size() == 0)
        throw Error(exit_input, fmt::format("{}: there are no facets", name));
    return mesh;
}

Domain make_domain(const Mesh& mesh, int threads, std::uint64_t memory_limit,
                   const std::string& name) {
    Domain domain;
    try {
        domain.set_option(DomainOption::threads, threads);
        domain.set_option(DomainOption::memory_limit, static_cast<std::int64_t>(memory_limit));
        domain.set_points(mgdt::Points(mesh.points.data(), mesh.point_count()));
        domain.set_facets(mesh.facets.begin, mesh.facets.corners, mesh.facets.markers);
        domain.set_segments(mesh.facets.segments);
        std::vector<Point> holes, regions;
        std::vector<std::int32_t> markers;
        for (const FileFacets::Place& hole : mesh.facets.holes) holes.push_back(hole.x);
        for (const FileFacets::Place& region : mesh.facets.regions) {
            regions.push_back(region.x);
            markers.push_back(region.marker);
        }
        domain.set_holes(holes);
        domain.set_regions(regions, markers);
    } catch (...) {
        rethrow_failure(name, domain.last_error());
    }
    return domain;
}

std::string clean(Domain& domain, const CleanOptions& options) {
    domain.set_option(DomainDoubleOption::weld, options.weld);
    domain.set_option(DomainDoubleOption::flatness, options.flat);
    domain.clean();
    std::vector<std::string> done;
    const auto add = [&](DomainStatistic key, const char* one, const char* many) {
        const auto n = static_cast<std::size_t>(domain.statistic(key));
        if (n > 0) done.push_back(counted(n, one, many));
    };
    add(DomainStatistic::moved_points, "point welded", "points welded");
    add(DomainStatistic::repeated_corners, "corner repeated", "corners repeated");
    add(DomainStatistic::collapsed_facets, "facet collapsed", "facets collapsed");
    add(DomainStatistic::covered_facets, "facet covered", "facets covered");
    add(DomainStatistic::points_in_edges, "point in an edge", "points in edges");
    add(DomainStatistic::points_in_facets, "point in a facet", "points in facets");
    add(DomainStatistic::edges_in_facets, "edge in a facet", "edges in facets");
    add(DomainStatistic::exchanged_edges, "edge exchanged", "edges exchanged");
    return done.empty() ? "nothing to clean" : fmt::format("{}", fmt::join(done, ", "));
}

std::vector<OffendingPair> offending_pairs(const Domain& domain) {
    const std::vector<std::int64_t> values = domain.array(DomainArray::offending_pairs);
    std::vector<OffendingPair> pairs;
    for (std::size_t i = 0; i < values.size(); i += 4)
        pairs.push_back(
            {{static_cast<DomainKind>(values[i]), static_cast<DomainKind>(values[i + 2])},
             {values[i + 1], values[i + 3]}});
    return pairs;
}

}  // namespace mgdt::cli
