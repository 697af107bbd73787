// SPDX-License-Identifier: MIT
// The measurements of S.H. Lo in section 5 of "3D Delaunay triangulation of non-uniform point
// distributions", Finite Elements in Analysis and Design 90 (2014) 113-130, and the combinations
// that the paper left out.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mgdt::cli::bench {

struct PaperTable {
    std::string distribution;
    std::vector<std::size_t> sizes;
};

const std::vector<PaperTable>& paper_tables();

std::vector<std::string> paper_schemes();

// Whether a scheme or a peer takes unreasonably long on a set. The paper, too, leaves out the
// regular grid beyond 2 million points of the sets that do not suit it.
bool is_hopeless(const std::string& scheme_or_peer, const std::string& distribution,
                 std::size_t points);

}  // namespace mgdt::cli::bench
