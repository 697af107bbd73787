// SPDX-License-Identifier: MIT
// Meshes of domains whose boundaries are kept: every triangle of a facet is one face, every segment
// one edge, and points are added inside of the domain only.
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_volumes.hpp"
#include "random_complexes.hpp"

namespace mgdt {
namespace {

// Whether the boundary of a domain is kept. What flips and added points do not recover is refused.
bool is_kept(MeshedDomain& domain) {
    domain.settings().keeps_boundary = true;
    const Error error = error_of([&] {
        domain.build();
        domain.check();
    });
    if (error.status != MGDT_OK) {
        EXPECT_EQ(error.status, MGDT_ERR_RESOLUTION) << error.message;
        return false;
    }
    const SolidMesh& m = domain.mesh();
    expect_equal_volumes(m);
    EXPECT_FALSE(m.is_rounded);
    EXPECT_TRUE(
        std::equal(domain.input().points.begin(), domain.input().points.end(), m.points.begin()));
    for (const std::uint32_t end : m.steiner_edges) EXPECT_EQ(end, no_index);
    return true;
}

TEST(KeptBoundary, KeepsAllTestSurfaces) {
    for (const Surface& s : test_surfaces()) {
        SCOPED_TRACE(s.name);
        MeshedDomain domain;
        give(domain, s);
        // Facets that hundreds of edges cross are not recovered.
        const bool is_hard = s.name == "city on a large square" || s.name == "square in a cloud";
        EXPECT_EQ(is_kept(domain), !is_hard);
        if (is_hard) continue;
        const SolidMesh& m = domain.mesh();
        EXPECT_GT(m.tetrahedron_count(), 0u);
        if (s.regions > 0) {
            EXPECT_EQ(m.region_markers.size(), s.regions);
        }
        if (s.volume >= 0) {
            EXPECT_NEAR(volume(m), s.volume, 1e-9 * s.volume);
        }
    }
}

TEST(KeptBoundary, KeepsRandomComplexes) {
    int kept = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        MeshedDomain domain;
        give_random_complex(domain, seed);
        kept += is_kept(domain);
    }
    EXPECT_EQ(kept, 150);
}

}  // namespace
}  // namespace mgdt
