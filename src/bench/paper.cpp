// SPDX-License-Identifier: MIT
#include "bench/paper.hpp"

#include <algorithm>
#include <initializer_list>

namespace mgdt::cli::bench {

const std::vector<PaperTable>& paper_tables() {
    static const std::vector<PaperTable> tables = [] {
        const std::vector<std::size_t> sizes{400000,  800000,  1200000,  1600000,  2000000,
                                             4000000, 8000000, 12000000, 16000000, 20000000};
        std::vector<PaperTable> all;
        // Table 1. Its uniform set is one of Table 2.
        for (const char* kind : {"line", "diagonal", "ellipse", "spiral", "cluster"}) {
            all.push_back({std::string("mild-") + kind, {1000000}});
        }
        // Tables 2 to 7
        all.push_back({"uniform", sizes});
        all.back().sizes.insert(all.back().sizes.begin() + 2, 1000000);
        for (const char* kind : {"line", "diagonal", "ellipse", "spiral", "cluster"}) {
            all.push_back({kind, sizes});
        }
        // Tables 8 and 9
        all.push_back({"galaxy", {3000000, 6000000}});
        all.push_back({"machine", {3318541}});
        all.push_back({"church", {4824332}});
        return all;
    }();
    return tables;
}

std::vector<std::string> paper_schemes() {
    return {"regular-grid", "multi-grid", "enhanced-kd-tree", "random", "brio", "hilbert", "auto"};
}

bool is_hopeless(const std::string& scheme_or_peer, const std::string& distribution,
                 std::size_t points) {
    const auto is_any_of = [&](std::initializer_list<const char*> kinds) {
        return std::find(kinds.begin(), kinds.end(), distribution) != kinds.end();
    };
    // Qhull takes a minute per million points, and 1800 bytes per point.
    if (scheme_or_peer == "qhull") return points > 1000000;
    // With random order each walk crosses the whole set: on a line of 400,000 points it visits 3000
    // tetrahedra.
    if (scheme_or_peer == "random") return points > 400000 || is_any_of({"line", "diagonal"});
    if (scheme_or_peer == "regular-grid") {
        return points > 2000000 && is_any_of({"line", "diagonal", "ellipse", "spiral", "cluster"});
    }
    return false;
}

}  // namespace mgdt::cli::bench
