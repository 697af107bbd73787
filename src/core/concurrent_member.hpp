// SPDX-License-Identifier: MIT
// What a thread of concurrent insertion has of its own, and how it finds where to start.
#pragma once

#include <algorithm>

#include "core/concurrent_insertion.hpp"

namespace mgdt {

struct ConcurrentInsertion::Member {
    Member(Mesh& mesh, BlockOwners& owners, std::uint8_t who, SlotSupply& supply,
           Workspace* of_handle)
        : thread_state(mesh, owners, who, supply),
          own(mesh.vertices.allocator()),
          workspace(of_handle ? *of_handle : own),
          repeats(mesh.vertices.allocator()),
          deferred(mesh.vertices.allocator()),
          left(mesh.vertices.allocator()) {}
    void begin_counting() noexcept {
        crowd = doubts = {};
        members_given_up = 0;
        waits = 0;
    }

    ThreadState thread_state;
    Workspace own;
    Workspace& workspace;
    TetId here = no_tetrahedron;  // a tetrahedron that is mine, where walks start
    std::size_t last = 0;         // position of the point inserted last
    // Points that have a vertex already. Its index is changed at the end, since others may read
    // its record.
    struct Repeat {
        VertexId q, vertex;
    };
    Buffer<Repeat> repeats;
    Buffer<std::uint32_t> deferred, left;
    std::size_t next = 0, end = 0;  // positions in its zone that are to be inserted
    std::size_t misses = 0;         // points in a row that it could not insert there
    std::uint32_t hub = no_index;   // position of one that all have stopped for
    struct Trial {
        std::size_t tries = 0, failures = 0;
        // Begins another one. Whether more than a quarter failed.
        bool ends_crowded() noexcept {
            const bool is_crowded = failures > tries / 4;
            tries = failures = 0;
            return is_crowded;
        }
    };
    Trial crowd;                       // of this thread, which may wait and leave
    Trial doubts;                      // whether all should stop and compare with one alone
    std::size_t members_given_up = 0;  // of cavities
    unsigned waits = 0;                // in a row, after trials of which too many failed
    std::uint64_t inserted = 0, times_deferred = 0;
};

// Calls f with positions that are probably near that of k, until it returns true: those next to it,
// if points of its round are in, and earlier ones.
template <class F>
bool ConcurrentInsertion::for_nearby_positions(std::size_t k, F f) const {
    constexpr std::size_t tries = 16;
    const Buffer<std::uint32_t>& rounds = schedule_.rounds;
    const std::size_t r = static_cast<std::size_t>(
        std::upper_bound(rounds.begin(), rounds.end(), static_cast<std::uint32_t>(k)) -
        rounds.begin());
    if (r <= 1) {
        for (std::size_t i = 1; i <= tries && i <= k; ++i)
            if (f(k - i)) return true;
        return false;
    }
    // The round before goes along the same way.
    const std::size_t end = r < rounds.size() ? rounds[r] : batch_.points.size;
    const std::size_t begin = rounds[r - 1], before = rounds[r - 2];
    const double share = static_cast<double>(k - begin) / static_cast<double>(end - begin);
    const std::size_t size = begin - before;
    const std::size_t there = static_cast<std::size_t>(share * static_cast<double>(size));
    for (std::size_t i = 0; i < tries; ++i) {
        const std::size_t at = i % 2 == 0 ? there + i / 2 : there - (i + 1) / 2;
        if (at < size && f(before + at)) return true;
    }
    return false;
}

}  // namespace mgdt
