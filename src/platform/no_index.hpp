// SPDX-License-Identifier: MIT
// The index that stands for nothing: no point, no vertex, no facet, no number.
#pragma once

#include <cstdint>

namespace mgdt {

inline constexpr std::uint32_t no_index = 0xFFFFFFFFu;

}  // namespace mgdt
