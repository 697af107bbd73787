// SPDX-License-Identifier: MIT
// The stages of a concurrent insertion in zones (core/zones.hpp).
//
// The points near the border of zones are inserted first, with the threads working anywhere. The
// tetrahedra between zones are then as small as the others, so that few points inside a zone would
// remove one. These few are deferred, and inserted anywhere at the end. A deferred point is not
// cheap: until it is inserted, threads make tetrahedra in its cavity that the point removes again.
// So zones are not used if many points would be deferred, as among the long tetrahedra between the
// arms of a spiral.
#include "core/concurrent_insertion.hpp"

namespace mgdt {

// Inserts a round in zones, unless insertion anywhere is better. Returns whether the round is
// inserted.
bool ConcurrentInsertion::insert_in_zones(const Zones::Round& round, unsigned threads) {
    // Zones need a previous round, to find the border, and stored spheres, to close tetrahedra.
    if (threads == 1 || !policy_.may_use_zones() || positions_.first_vertex() != first_vertex ||
        round.before == round.begin || !state_.mesh.tetrahedra.has_spheres())
        return false;
    Buffer<std::uint32_t> border(state_.allocator);
    try {
        zones_.divide(threads, round, state_.mesh);
        if (!list_border(round, threads, border)) return false;
    } catch (const std::bad_alloc&) {
        zones_.forget();
        return false;  // insertion anywhere needs less memory
    }
    insert_anywhere({0, border.size(), border.data()}, policy_.threads_for_few(border.size()));
    insert_inside(round, threads);
    const Buffer<std::uint32_t> left = take_left();
    insert_anywhere({0, left.size(), left.data()}, policy_.threads_for_few(left.size()));
    return true;
}

// Lists the positions near the border, ascending. Returns false if they are too many. The function
// is not inlined, so that its array takes no stack while threads insert.
MGDT_NOT_INLINE bool ConcurrentInsertion::list_border(const Zones::Round& round, unsigned threads,
                                                      Buffer<std::uint32_t>& border) {
    std::size_t ends[Team::most + 1] = {};
    const auto for_each = [&](unsigned zone, auto f) {
        const std::size_t end = zones_.first(round, zone + 1);
        for (std::size_t k = zones_.first(round, zone); k < end; ++k)
            if (zones_.is_at_border(k)) f(static_cast<std::uint32_t>(k));
    };
    team_.run(threads, [&](unsigned m) {
        std::size_t count = 0;
        for_each(m, [&](std::uint32_t) { ++count; });
        ends[m + 1] = count;
    });
    for (unsigned m = 0; m < threads; ++m) ends[m + 1] += ends[m];
    if (!policy_.is_border_short(ends[threads], round.size())) return false;
    border.resize(ends[threads]);
    team_.run(threads, [&](unsigned m) {
        std::uint32_t* to = border.data() + ends[m];
        for_each(m, [&](std::uint32_t k) { *to++ = k; });
    });
    return true;
}

// Inserts as many of the points inside zones as possible. The others are added to `left_`.
void ConcurrentInsertion::insert_inside(const Zones::Round& round, unsigned threads) {
    for (unsigned m = 0; m < threads; ++m)
        workers_[m].begin_zone(zones_.first(round, m), zones_.first(round, m + 1));
    bool goes_on = true;
    while (goes_on) {
        try {
            zones_.close(state_.mesh);
        } catch (const std::bad_alloc&) {
            break;
        }
        insert_between_closed(threads);
        goes_on = stage_.lacks_slots ? try_to_grow_storage(threads) : insert_hubs() > 0;
    }
    for (unsigned m = 0; m < threads; ++m)
        workers_[m].for_left_in_zone([this](std::uint32_t k) { left_.push_back(k); });
}

// Inserts points in zones, while the tetrahedra between zones are closed, until one zone is done or
// all threads stop. Then opens the tetrahedra.
void ConcurrentInsertion::insert_between_closed(unsigned threads) {
    queue_.deal(0, 1, threads);
    begin_stage({0, 0, nullptr}, threads);
    supply_.open();
    const auto finish = [&] {
        zones_.open(state_.mesh);
        for (unsigned m = 0; m < threads; ++m) workers_[m].leave_zone();
        end_stage(threads);
    };
    try {
        team_.run(threads, [&](unsigned m) {
            workers_[m].insert_in_zone([this](std::size_t done) { poll(done); });
        });
    } catch (...) {
        finish();
        throw;
    }
    finish();
    poll(stage_.done);
}

}  // namespace mgdt
