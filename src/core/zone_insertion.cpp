// SPDX-License-Identifier: MIT
// The part of concurrent insertion that goes on in zones (core/zones.hpp).
//
// What is near the border of zones is inserted first, by all threads anywhere. Then the tetrahedra
// between zones are as small as others will be, and few points inside come to one. Those are put
// off, and inserted anywhere at the end. A point that is put off is not cheap: until it is in,
// others make tetrahedra in its place that it removes again. So where many would be, as among the
// long tetrahedra between the arms of a spiral, zones are not used.
#include <algorithm>

#include "core/concurrent_member.hpp"

namespace mgdt {

bool ConcurrentInsertion::may_use_zones(const Zones::Round& round, unsigned members) const {
    const ZoneUse use = state_.hooks.zones;
    if (use == ZoneUse::never || (use == ZoneUse::where_few_meet && is_crowded_)) return false;
    // A round finds the border by the one before it, and a closed tetrahedron has a sphere.
    return members > 1 && base_ == first_vertex && round.before < round.begin &&
           state_.mesh.tetrahedra.has_spheres();
}

// Inserts a round, unless it is better inserted otherwise. Whether it did.
bool ConcurrentInsertion::insert_in_zones(const Zones::Round& round, unsigned members) {
    if (!may_use_zones(round, members)) return false;
    Buffer<std::uint32_t> border(state_.allocator);
    try {
        zones_.divide(members, round, state_.mesh);
        if (!list_border(round, members, border)) return false;
    } catch (const std::bad_alloc&) {
        zones_.forget();
        return false;  // the other way needs less
    }
    insert_anywhere({0, border.size(), border.data()}, members_for_few(border.size()));
    insert_inside(round, members);
    const Buffer<std::uint32_t> left = take_left();
    insert_anywhere({0, left.size(), left.data()}, members_for_few(left.size()));
    return true;
}

// Lists the positions near the border, ascending. False if they are too many.
bool ConcurrentInsertion::list_border(const Zones::Round& round, unsigned members,
                                      Buffer<std::uint32_t>& border) {
    std::size_t ends[Team::most + 1] = {};
    const auto for_each = [&](unsigned zone, auto f) {
        const std::size_t end = zones_.first(round, zone + 1);
        for (std::size_t k = zones_.first(round, zone); k < end; ++k)
            if (zones_.is_at_border(k)) f(static_cast<std::uint32_t>(k));
    };
    team_.run(members, [&](unsigned m) {
        std::size_t count = 0;
        for_each(m, [&](std::uint32_t) { ++count; });
        ends[m + 1] = count;
    });
    for (unsigned m = 0; m < members; ++m) ends[m + 1] += ends[m];
    constexpr std::size_t enough = 8;  // points inside for one at the border
    if (state_.hooks.zones == ZoneUse::where_few_meet && enough * ends[members] > round.size())
        return false;
    border.resize(ends[members]);
    team_.run(members, [&](unsigned m) {
        std::uint32_t* to = border.data() + ends[m];
        for_each(m, [&](std::uint32_t k) { *to++ = k; });
    });
    return true;
}

// Inserts what it can of the points inside zones. The others are left.
void ConcurrentInsertion::insert_inside(const Zones::Round& round, unsigned members) {
    for (unsigned m = 0; m < members; ++m) {
        members_[m].next = zones_.first(round, m);
        members_[m].end = zones_.first(round, m + 1);
    }
    bool goes_on = true;
    while (goes_on) {
        try {
            zones_.close(state_.mesh);
        } catch (const std::bad_alloc&) {
            break;
        }
        insert_closed(round, members);
        goes_on = no_slots_ ? grow_storage(members) : insert_hubs() > 0;
    }
    for (unsigned m = 0; m < members; ++m)
        for (std::size_t k = members_[m].next; k < members_[m].end; ++k)
            if (!zones_.is_at_border(k)) left_.push_back(static_cast<std::uint32_t>(k));
}

// The same while the tetrahedra between zones are closed, till a zone is done, or all stop.
void ConcurrentInsertion::insert_closed(const Zones::Round& round, unsigned members) {
    const Items none{round.begin, 0, nullptr};
    queue_.deal(0, 1, members);
    begin_stage(none, members);
    supply_.open();
    const auto finish = [&] {
        zones_.open(state_.mesh);
        for (unsigned m = 0; m < members; ++m) {
            // The others may change it from now on.
            members_[m].here = no_tetrahedron;
            members_[m].workspace.slot_count = 0;
        }
        gather_results(members, none);
    };
    try {
        team_.run(members, [&](unsigned m) { work_inside(members_[m], m); });
    } catch (...) {
        finish();
        throw;
    }
    finish();
    poll(done_);
}

// The first one that is done stops all: what they have left is shared better anywhere.
void ConcurrentInsertion::work_inside(Member& member, unsigned zone) {
    constexpr std::size_t piece_size = 256;
    std::size_t& k = member.next;
    member.misses = 0;
    try {
        while (k < member.end && !stop_) {
            const std::size_t piece_end = std::min(k + piece_size, member.end);
            std::size_t inserted = 0;
            for (; k < piece_end && !stop_.load(std::memory_order_relaxed); ++k) {
                if (zones_.is_at_border(k)) continue;
                if (try_insert_inside(member, zone, k)) {
                    ++inserted;
                } else {
                    member.left.push_back(static_cast<std::uint32_t>(k));
                    ++member.times_deferred;
                }
            }
            const std::size_t done = done_.fetch_add(inserted) + inserted;
            if (zone == 0) poll(done);
        }
        stop_ = true;
    } catch (...) {
        stop_ = true;
        throw;
    }
}

bool ConcurrentInsertion::try_insert_inside(Member& member, unsigned zone, std::size_t k) {
    // After so many failures in a row the thread may be in a corner of its zone.
    constexpr std::size_t most_misses = 4;
    if ((member.here == no_tetrahedron || member.misses >= most_misses) &&
        !arrive_inside(member, zone, k))
        return false;
    const bool is_in = insert(member, k, state_.calls().insert_in_zone);
    member.misses = is_in ? 0 : member.misses + 1;
    return is_in;
}

// Finds a tetrahedron of a zone near point k, to walk from. Whether there is one.
bool ConcurrentInsertion::arrive_inside(Member& member, unsigned zone, std::size_t k) {
    const Mesh& mesh = state_.mesh;
    return for_nearby_positions(k, [&](std::size_t position) {
        const VertexId near = vertex(position);
        if (zones_.of(near) != zone) return false;
        const TetId t = mesh.vertex_hint[near];
        if (t == no_tetrahedron) return false;
        // Another thread may have taken its slot, for a tetrahedron whose first vertex is in
        // another zone; that of a free slot is in none.
        VertexId first[2];
        read_racing(mesh.tetrahedra[t].v, first);
        if (zones_.of(first[0]) != zone || mesh.tetrahedra.sphere(t).is_closed()) return false;
        member.here = t;
        member.workspace.slot_count = 0;
        return true;
    });
}

}  // namespace mgdt
