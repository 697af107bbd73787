// SPDX-License-Identifier: MIT
#include "parts/parts.hpp"

#include <algorithm>
#include <functional>

#include "parts/ids.hpp"
#include "parts/settlement.hpp"
#include "parts/skeleton.hpp"

namespace mgdt {
Parts::Parts(Collective& collective, mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
    : allocator_(alloc, release, user),
      collective_(collective),
      homes_(allocator_, collective.parts()),
      boxes_(allocator_, collective.parts()),
      parts_(allocator_, collective.local_parts(), alloc, release, user),
      tetrahedra_(allocator_, collective.local_parts(), std::ref(allocator_)),
      vertices_of_given_(allocator_, collective.local_parts(), std::ref(allocator_)),
      first_vertex_(allocator_),
      first_tetrahedron_(allocator_) {}

void Parts::set_threads(std::int32_t threads) {
    for (Part& part : parts_) part.settings().threads = threads;
}

std::size_t Parts::bytes() const {
    std::size_t sum = allocator_.bytes();
    for (const Part& part : parts_) sum += part.bytes();
    return sum;
}

void Parts::build(const GivenPoints* given, const std::int64_t* const* ids,
                  StageProgress& progress) {
    settle(given, ids, progress);
    const PartId local = collective_.local_parts();
    Objects<Mail> received(allocator_, local, std::ref(allocator_));
    exchange(progress, false, received);
    progress.enter(0.7, 0.9);
    collective_.each_local([&](PartId p) {
        parts_[p].insert(received[p].records<PartPoint>(), received[p].count(), progress, p, local);
    });
    progress.enter(0.9, 1);
    find_tetrahedra(collective_, homes_, parts_, tetrahedra_, first_tetrahedron_, allocator_);
    collective_.finish();
    progress.finish();
}

void Parts::build_each(const GivenPoints* given, const std::int64_t* const* ids,
                       StageProgress& progress, const Visit& visit) {
    settle(given, ids, progress);
    const PartId parts = collective_.parts();
    Objects<Mail> received(allocator_, parts, std::ref(allocator_));
    exchange(progress, true, received);
    progress.enter(0.5, 1);
    std::int64_t first = 0;
    first_tetrahedron_.push_back(first);
    collective_.each_local([&](PartId p) {
        parts_[p].insert(received[p].records<PartPoint>(), received[p].count(), progress, p, parts);
        received[p].bytes.reset();
        first += static_cast<std::int64_t>(tetrahedra_[p].list(parts_[p], p, first));
        first_tetrahedron_.push_back(first);
        visit(p);
        tetrahedra_[p].forget();
        parts_[p].forget_triangulation();
    });
    progress.finish();
}

void Parts::settle(const GivenPoints* given, const std::int64_t* const* ids,
                   StageProgress& progress) {
    progress.enter(0, 0.1);
    homes_.divide(collective_, given);
    progress.report(0.5);
    settle_points(collective_, homes_, given, ids, parts_, first_vertex_, vertices_of_given_,
                  allocator_);
    if (ids) require_distinct_ids(collective_, given, ids, vertices_of_given_, allocator_);
}

void Parts::exchange(StageProgress& progress, bool one_at_a_time, Objects<Mail>& received) {
    const PartId local = collective_.local_parts();
    progress.enter(0.1, one_at_a_time ? 0.5 : 0.7);
    gather_boxes();
    Skeleton skeleton(allocator_);
    skeleton.gather(collective_, parts_);
    Buffer<PartPoint> points(allocator_), others(allocator_);
    Objects<Mail> out(allocator_, local, std::ref(allocator_));
    collective_.each_local([&](PartId p) {
        const PartId part = collective_.first_local() + p;
        skeleton.points_for(part, collective_.parts(), points);
        others.clear();
        for (const PartPoint& x : points)
            if (x.number < first_vertex_[part] || x.number >= first_vertex_[part + 1])
                others.push_back(x);
        parts_[p].insert(others.data(), others.size(), progress, p, local);
        parts_[p].push(boxes_, collective_.parts(), out[p]);
        if (one_at_a_time) parts_[p].forget_triangulation();
        progress.report((p + 1.0) / local);
    });
    collective_.exchange<PartPoint>(out, received);
}

void Parts::gather_boxes() {
    const PartId local = collective_.local_parts();
    Buffer<BoundingBox> boxes(allocator_, boxes_.size() * local);
    for (PartId p = 0; p < local; ++p)
        boxes_.divide(parts_[p].points(), parts_[p].own_count(), boxes.data() + boxes_.size() * p);
    boxes_.gather(collective_, boxes);
}

}  // namespace mgdt
