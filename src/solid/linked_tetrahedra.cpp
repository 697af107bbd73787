// SPDX-License-Identifier: MIT
#include "solid/linked_tetrahedra.hpp"

#include "platform/error.hpp"

namespace mgdt {

std::uint32_t LinkedTetrahedra::add(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                    std::uint32_t d) {
    const std::uint32_t t = take_slot();
    tetrahedra[t] = {{a, b, c, d},
                     {no_index, no_index, no_index, no_index},
                     {no_index, no_index, no_index, no_index}};
    for (const std::uint32_t v : {a, b, c, d}) hints[v] = t;
    return t;
}

std::uint32_t LinkedTetrahedra::take_slot() {
    if (!free_slots.empty()) {
        const std::uint32_t t = free_slots.back();
        free_slots.pop_back();
        return t;
    }
    const auto t = static_cast<std::uint32_t>(tetrahedra.size());
    if (t >= max_tetrahedra) fail(MGDT_ERR_TOO_LARGE, "there are too many tetrahedra");
    tetrahedra.push_back({});
    return t;
}

void LinkedTetrahedra::remove(std::uint32_t tetrahedron) {
    tetrahedra[tetrahedron].v[0] = no_index;
    free_slots.push_back(tetrahedron);
}

}  // namespace mgdt
