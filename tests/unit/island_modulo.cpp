// SPDX-License-Identifier: MIT
// A stage of near ties that the islands with four doubles in a register have.
#include "islands.hpp"
#include "kernel/ties.hpp"

namespace islands {

int decided_modulo(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q) {
    const mgdt::Transpose4 rows([&](unsigned k) { return vertices[t.v[k]].x; });
    const auto [x, y, z] = mgdt::relative_to(rows, {q[0], q[1], q[2]});
    constexpr double units = 1.5 * 0x1p52;
    return mgdt::decided_modulo(x, y, z, units);
}

}  // namespace islands
