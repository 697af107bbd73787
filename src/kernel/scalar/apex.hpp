// SPDX-License-Identifier: MIT
// Without vectors, VertexRemoval tests one vertex at a time. See kernel/apex.hpp.
#pragma once

namespace mgdt {
inline namespace MGDT_ISLAND {

inline ApexResult find_apex(const LinkColumns&, const std::uint32_t (&)[3]) {
    return {no_apex, {}};
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
