// SPDX-License-Identifier: MIT
// Functions of the program for domains: they are made from files of facets, and their failures are
// thrown as Error.
#pragma once

#include <mgdt/mgdt.hpp>
#include <string>
#include <vector>

#include "cli/opening.hpp"

namespace mgdt::cli {

// Reads points and facets.
Mesh read_facets(InputOptions input);

// A domain with the points and facets of a file. `name` is the file's, for messages.
Domain make_domain(const Mesh& mesh, int threads, std::uint64_t memory_limit,
                   const std::string& name);

// How facets and segments are cleaned before they are meshed.
struct CleanOptions {
    bool clean = false;
    double weld = 0, flat = 0;  // shares of the size of the points

    bool is_asked_for() const { return clean || weld > 0 || flat > 0; }
};
// Cleans a domain. Returns what was done, such as "2 points welded, 1 facet collapsed".
std::string clean(Domain& domain, const CleanOptions& options);

// Two facets, segments or points, that offend.
struct OffendingPair {
    DomainKind kinds[2];
    std::int64_t numbers[2];
};
std::vector<OffendingPair> offending_pairs(const Domain& domain);

}  // namespace mgdt::cli
