// SPDX-License-Identifier: MIT
// The settings that the caller of a triangulation chooses, and the thresholds that tests change.
#pragma once

#include <cstddef>
#include <cstdint>

#include "mgdt/mgdt.h"
#include "order/schedule.hpp"
#include "platform/call_settings.hpp"

namespace mgdt {

struct Settings : CallSettings {
    Settings() noexcept { watches_reads = false; }  // as in 1.0 to 1.2

    std::int32_t scheme = MGDT_ORDER_AUTO;
    OrderParameters order;
    bool canonical_output = false;
};

// Whether threads insert in zones (core/zones.hpp).
enum class ZoneUse : std::uint8_t { never, where_few_meet, always };

// Thresholds that decide which of several algorithms an operation uses. The values result from
// measurements. Only tests change them, to run every algorithm with few points.
struct TestHooks {
    // A thread with fewer points costs more than it gains.
    std::size_t min_points_per_thread = 8192;
    ZoneUse zones = ZoneUse::where_few_meet;
    // With more tetrahedra per vertex, one thread inserts: several would wait for each other.
    std::size_t max_tetrahedra_per_vertex = 16;
    // The number of attempts after which a thread may doubt that several threads are faster than
    // one.
    std::size_t attempts_before_doubt = 2048;
    // A call that removes or moves more than one in this many vertices triangulates all points
    // anew. With 0 no call does so.
    std::size_t vertices_per_rebuild = 14;
    // A link of at least this many vertices is triangulated by itself when its vertex is removed.
    std::size_t large_link = 128;
    // A function that threads call when they take or release blocks of vertices, to provoke races.
    void (*pause)() = nullptr;
};

}  // namespace mgdt
