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

bool Triangulation::ConcurrentInsertion::may_use_zones(const Zones::Round& round,
                                                       unsigned members) const {
    const ZoneUse use = t_.settings_.zones;
    if (use == ZoneUse::never || (use == ZoneUse::where_few_meet && is_crowded_)) return false;
    // A round finds the border by the one before it, and a closed tetrahedron has a sphere.
    return members > 1 && base_ == first_vertex && round.before < round.begin &&
           t_.mesh_.tetrahedra.has_spheres();
}

// Inserts a round, unless it is better inserted otherwise. Whether it did.
bool Triangulation::ConcurrentInsertion::insert_in_zones(const Zones::Round& round,
                                                         unsigned members) {
    if (!may_use_zones(round, members)) return false;
    try {
        zones_.divide(members, round, t_.mesh_);
    } catch (const std::bad_alloc&) {
        return false;  // the other way needs less
    }
    const Buffer<std::uint32_t> border = list_border(round, members);
    constexpr std::size_t enough = 8;  // points inside for one at the border
    if (t_.settings_.zones == ZoneUse::where_few_meet && enough * border.size() > round.size())
        return false;
    insert_anywhere({0, border.size(), border.data()}, members_for_few(border.size()));
    insert_inside(round, members);
    const Buffer<std::uint32_t> left = take_left();
    insert_anywhere({0, left.size(), left.data()}, members_for_left(left.size(), round.size()));
    return true;
}

Buffer<std::uint32_t> Triangulation::ConcurrentInsertion::list_border(const Zones::Round& round,
                                                                      unsigned members) {
    team_.run(members, [&](unsigned m) {
        const std::size_t end = zones_.first(round, m + 1);
        for (std::size_t k = zones_.first(round, m); k < end; ++k)
            if (zones_.is_at_border(k)) members_[m].left.push_back(static_cast<std::uint32_t>(k));
    });
    gather_left(members);
    return take_left();
}

void Triangulation::ConcurrentInsertion::insert_inside(const Zones::Round& round,
                                                       unsigned members) {
    Mesh& mesh = t_.mesh_;
    const Items items{round.begin, round.size(), nullptr};
    queue_.deal(0, 1, members);
    begin_stage(items, members);
    inside_ = round.size();
    is_some_zone_done_ = false;
    for (unsigned m = 0; m < members; ++m) {
        members_[m].zone = m;
        members_[m].misses = 0;
    }
    zones_.close(mesh);
    supply_.open();
    const auto finish = [&] {
        zones_.open(mesh);
        for (unsigned m = 0; m < members; ++m) {
            // The others may change it from now on.
            members_[m].here = no_tetrahedron;
            members_[m].workspace.slot_count = 0;
        }
        gather_results(members, items);
    };
    try {
        team_.run(members, [&](unsigned m) { work_inside(members_[m], round); });
    } catch (...) {
        finish();
        throw;
    }
    finish();
    insert_hubs();
    poll(done_);
}

void Triangulation::ConcurrentInsertion::work_inside(Member& member, const Zones::Round& round) {
    constexpr std::size_t piece_size = 256;
    // When a thread is done and the others have no more than that left, all go on together.
    const std::size_t few = round.size() / 16;
    const bool is_first = &member == members_;
    std::size_t k = zones_.first(round, member.zone);
    const std::size_t end = zones_.first(round, member.zone + 1);
    try {
        while (k < end && !stop_ && !(is_some_zone_done_ && inside_ < few)) {
            const std::size_t begin = k, piece_end = std::min(k + piece_size, end);
            std::size_t inserted = 0;
            for (; k < piece_end && !stop_.load(std::memory_order_relaxed); ++k) {
                if (zones_.is_at_border(k)) continue;
                if (try_insert_inside(member, k)) {
                    ++inserted;
                } else {
                    member.left.push_back(static_cast<std::uint32_t>(k));
                    ++member.times_deferred;
                }
            }
            inside_ -= k - begin;
            const std::size_t done = done_.fetch_add(inserted) + inserted;
            if (is_first) poll(done);
        }
        is_some_zone_done_ = true;
        for (; k < end; ++k)
            if (!zones_.is_at_border(k)) member.left.push_back(static_cast<std::uint32_t>(k));
    } catch (...) {
        stop_ = true;
        throw;
    }
}

bool Triangulation::ConcurrentInsertion::try_insert_inside(Member& member, std::size_t k) {
    // After so many failures in a row the thread may be in a corner of its zone.
    constexpr std::size_t most_misses = 4;
    if ((member.here == no_tetrahedron || member.misses >= most_misses) &&
        !arrive_inside(member, k))
        return false;
    const bool is_in = insert(member, k, t_.calls().insert_in_zone);
    member.misses = is_in ? 0 : member.misses + 1;
    return is_in;
}

// Finds a tetrahedron of the zone near point k, to walk from. Whether there is one.
bool Triangulation::ConcurrentInsertion::arrive_inside(Member& member, std::size_t k) {
    const Mesh& mesh = t_.mesh_;
    return for_nearby_positions(k, [&](std::size_t position) {
        const VertexId near = vertex(position);
        if (zones_.of(near) != member.zone) return false;
        const TetId t = mesh.vertex_hint[near];
        if (t == no_tetrahedron) return false;
        // Another thread may have taken its slot, for a tetrahedron whose first vertex is in
        // another zone; that of a free slot is in none.
        VertexId first[2];
        read_racing(mesh.tetrahedra[t].v, first);
        if (zones_.of(first[0]) != member.zone || mesh.tetrahedra.sphere(t).is_closed())
            return false;
        member.here = t;
        member.workspace.slot_count = 0;
        return true;
    });
}

}  // namespace mgdt
