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

// Two facets, segments or points, that offend.
struct OffendingPair {
    DomainKind kinds[2];
    std::int64_t numbers[2];
};
std::vector<OffendingPair> offending_pairs(const Domain& domain);

}  // namespace mgdt::cli
