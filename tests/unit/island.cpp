// SPDX-License-Identifier: MIT
// The routines of one island, which MGDT_ISLAND names. Compiled for each with the kernel's flags.
#include <string_view>

#include "islands.hpp"
#include "kernel/cavity_marks.hpp"
#include "kernel/powers.hpp"
#include "kernel/spheres.hpp"
#include "kernel/ties.hpp"
#include "kernel/words.hpp"
#include "platform/cpu.hpp"

namespace islands {
namespace {

using namespace mgdt;

template <class Spheres>
void powers(const Mesh& mesh, const FacetCode* codes, const double* q, const Asked& asked,
            Powers& out) {
    const Spheres spheres(mesh);
    const FourPowers four(spheres, spheres.tetrahedra.four(codes), Query(q));
    for (unsigned k = 0; k < 4; ++k) {
        out.value[k] = four[k].value;
        out.error[k] = four[k].error;
    }
    out.negative = four.negative();
    out.decided = four.decided();
    out.ghosts = four.ghosts();
    out.above = four.above({asked.value, asked.error});
    out.least_finite = four.least_finite(asked.bound);
}

void small_spheres(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                   std::uint32_t infinite, TetrahedronStore& store) {
    set_spheres_small(w, vertices, q, count, infinite, store.view<true>(),
                      [](std::size_t i, Tetrahedron& t) { t.n[0] = static_cast<FacetCode>(i); });
}

void any_spheres(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count,
                 std::uint32_t infinite, TetrahedronStore& store) {
    set_spheres(w, vertices, q, count, infinite, store.view<true>());
}

int near_tie(const Tetrahedron& t, const Vertex* vertices, const double* q) {
    return perturbed_doubles(t, vertices, Query(q));
}

bool runs() {
    const std::string_view island = MGDT_TEXT(MGDT_ISLAND);
    const CpuFeatures cpu = cpu_features();
    return island == "avx2" ? cpu.avx2 : island == "avx512" ? cpu.avx512 : true;
}

}  // namespace

Island MGDT_ISLAND() {
    return {MGDT_TEXT(MGDT_ISLAND),
            runs,
            powers<KeptSpheres>,
            powers<ComputedSpheres>,
            small_spheres,
            any_spheres,
            near_tie,
            nullptr,
            [](const auto& marks, auto codes, auto which) { return put_four(marks, codes, which); },
            [](const auto& four, auto which) { return mark_four(four, which); },
            [](auto to, auto words, auto bits) { return append(to, words, bits); },
            [](const auto& outside, auto code, auto q, auto& out) {
                return write_vertices(outside, code, q, out);
            }};
}

}  // namespace islands
