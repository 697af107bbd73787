// SPDX-License-Identifier: MIT
// find_apex() for processors without vectors. It decides nothing, so that Filling tests the
// vertices. kernel/apex.hpp documents the function.
#pragma once

namespace mgdt {
inline namespace MGDT_ISLAND {

inline ApexResult find_apex(const HoleColumns&, const std::uint32_t (&)[3]) {
    return {no_apex, {}};
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
