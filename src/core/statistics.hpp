// SPDX-License-Identifier: MIT
// The statistics of mgdt_get_stat() that the operations of a triangulation count.
#pragma once

#include <cstdint>

namespace mgdt {

struct Statistics {
    std::uint64_t points_inserted = 0;
    std::uint64_t duplicates = 0;
    std::uint64_t deferred = 0;        // attempts that met another thread's work and were repeated
    std::uint64_t inserted_alone = 0;  // points that one thread inserted while the others waited
    std::uint64_t removed = 0;         // points that were removed
    std::uint64_t moved = 0;           // points whose coordinates changed
    std::uint64_t put_back = 0;        // points that were moved without a rebuild
    std::uint64_t link_vertices = 0;   // sum of the sizes of the links of removed vertices
    std::uint64_t rebuilds = 0;
    double order_seconds = 0;
    double insert_seconds = 0;
    double remove_seconds = 0;
    double move_seconds = 0;
    double levels = 0;
    double rounds = 0;
    double threads = 0;
};

}  // namespace mgdt
