// SPDX-License-Identifier: MIT
// Location and nearest vertices of many places, in threads. Int is std::int64_t or std::int32_t;
// places are finite, and indices fit.
#pragma once

#include "order/schedule.hpp"
#include "query/export.hpp"
#include "query/locate.hpp"

namespace mgdt {

// With fewer places a thread does not pay.
inline constexpr std::size_t places_per_thread = 4096;

// `places` lie one behind the other and have their own scale; `weights` may be nullptr.
template <class Int>
void locate_points(const ExportView& view, const Locator& where, const PointSet& places,
                   Int* tetrahedra, double* weights);
template <class Int>
void nearest_vertices(const ExportView& view, const Locator& where, const PointSet& places,
                      Int* vertices);

}  // namespace mgdt
