// SPDX-License-Identifier: MIT
// A program as a user of C++ writes it.
#include <cstdio>
#include <mgdt/mgdt.hpp>

int main() {
    mgdt::Triangulation t;
    t.insert({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    t.check();
    for (const auto& [a, b, c, d] : t.tetrahedra<std::int32_t>())
        std::printf("%d %d %d %d\n", a, b, c, d);
    return t.tetrahedron_count() == 2 ? 0 : 1;
}
