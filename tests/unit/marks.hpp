// SPDX-License-Identifier: MIT
// put_four() of kernel/marks.hpp as it is compiled for AVX2.
#pragma once

#include "kernel/territory.hpp"

std::uint32_t put_four_avx2(const mgdt::MarkTable::View& marks, const mgdt::FacetCode* codes,
                            std::uint32_t which);
