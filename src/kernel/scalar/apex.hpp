// SPDX-License-Identifier: MIT
// find_apex() without vectors, which leaves the test of the vertices to Filling. See
// kernel/apex.hpp.
#pragma once

namespace mgdt {
inline namespace MGDT_ISLAND {

inline ApexResult find_apex(const HoleColumns&, const std::uint32_t (&)[3]) {
    return {no_apex, {}};
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
