// SPDX-License-Identifier: MIT
#include "parts/parts.hpp"

#include <algorithm>
#include <functional>

#include "order/random.hpp"
#include "parts/ids.hpp"
#include "parts/post.hpp"
#include "parts/skeleton.hpp"

namespace mgdt {
namespace {

// Numbers of points by their coordinates: open-addressed, with twice as many places as points.
class DistinctPoints {
  public:
    DistinctPoints(Allocator& allocator, std::size_t most) : places_(allocator) {
        std::size_t size = 16;
        while (size < 2 * most) size *= 2;
        places_.resize(size, no_index);
        mask_ = size - 1;
    }
    // The number of a point among `points` that has the coordinates, or else `next`.
    std::uint32_t number(const double* x, const PartPoint* points, std::uint32_t next) {
        std::uint64_t hash = 0;
        for (int k = 0; k < 3; ++k) {
            const double one_zero = x[k] + 0.0;  // no -0
            std::uint64_t bits;
            std::memcpy(&bits, &one_zero, sizeof bits);
            hash = Random::at(hash ^ bits, 0);
        }
        for (std::size_t at = hash & mask_;; at = (at + 1) & mask_) {
            if (places_[at] == no_index) return places_[at] = next;
            const double* const y = points[places_[at]].x;
            if (y[0] == x[0] && y[1] == x[1] && y[2] == x[2]) return places_[at];
        }
    }

  private:
    Buffer<std::uint32_t> places_;
    std::size_t mask_;
};

}  // namespace

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
    for (const Part& part : parts_) sum += part.triangulation().allocator().bytes();
    return sum;
}

void Parts::build(const GivenPoints* given, const std::int64_t* const* ids,
                  PartsProgress& progress) {
    progress.enter(0, 0.1);
    homes_.divide(collective_, given);
    progress.report(0.5);
    send_home(given, ids);
    if (ids) require_distinct_ids(collective_, given, ids, vertices_of_given_, allocator_);
    triangulate(progress);
    progress.enter(0.9, 1);
    find_tetrahedra(collective_, homes_, parts_, tetrahedra_, first_tetrahedron_, allocator_);
    collective_.finish();
    progress.finish();
}

// Each point goes to its home, and its vertex's number comes back.
void Parts::send_home(const GivenPoints* given, const std::int64_t* const* ids) {
    const PartId parts = collective_.parts(), local = collective_.local_parts();
    Buffer<std::uint64_t> counts(allocator_), mine(allocator_, local);
    for (PartId p = 0; p < local; ++p) mine[p] = given[p].n;
    collective_.gather(mine, counts);
    std::int64_t id = 0;
    for (PartId p = 0; p < collective_.first_local(); ++p)
        id += static_cast<std::int64_t>(counts[p]);

    Objects<Mail> out(allocator_, local, std::ref(allocator_)),
        in(allocator_, local, std::ref(allocator_));
    // Where each point is in what its part sends.
    Objects<Buffer<std::uint64_t>> places(allocator_, local, std::ref(allocator_));
    collective_.each_local([&](PartId p) {
        const std::size_t n = given[p].n;
        Post<PartPoint> post(allocator_);
        post.reserve(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double* const x = given[p].xyz + 3 * i;
            post.add(homes_.of(x),
                     {{x[0], x[1], x[2]}, ids ? ids[p][i] : id + static_cast<std::int64_t>(i), 0});
        }
        post.put(parts, out[p], &places[p]);
        id += static_cast<std::int64_t>(n);
    });
    collective_.exchange<PartPoint>(out, in);
    settle(in);
    for (PartId p = 0; p < local; ++p) {
        // What comes back has the order of what was sent.
        std::int64_t* const replies = begin_replies<std::int64_t>(in[p], out[p]);
        for (std::size_t i = 0; i < in[p].count(); ++i)
            replies[i] = in[p].records<PartPoint>()[i].number;
    }
    collective_.exchange<std::int64_t>(out, in);
    for (PartId p = 0; p < local; ++p) {
        vertices_of_given_[p].resize(given[p].n);
        for (std::size_t i = 0; i < given[p].n; ++i)
            vertices_of_given_[p][i] = in[p].records<std::int64_t>()[places[p][i]];
    }
}

// Equal points become one, with the least of their numbers; the vertices of all parts are numbered.
void Parts::settle(Objects<Mail>& arrived) {
    const PartId local = collective_.local_parts();
    Buffer<std::uint64_t> counts(allocator_), mine(allocator_, local);
    Objects<Buffer<PartPoint>> owned(allocator_, local, std::ref(allocator_));
    collective_.each_local([&](PartId p) {
        PartPoint* const points = arrived[p].records<PartPoint>();
        const std::size_t n = arrived[p].count();
        Buffer<PartPoint>& own = owned[p];
        // No triangulation holds as many; its own limit is lower.
        if (n >= in_cavity)
            fail(MGDT_ERR_TOO_LARGE, "%zu points are at home here; take more parts", n);
        own.reserve(n);
        DistinctPoints distinct(allocator_, n);
        for (std::size_t i = 0; i < n; ++i) {
            const auto number = static_cast<std::uint32_t>(own.size());
            const std::uint32_t found = distinct.number(points[i].x, own.data(), number);
            points[i].number = found;
            if (found == number)
                own.push_back(points[i]);
            else if (points[i].id < own[found].id)
                own[found] = points[i];
        }
        mine[p] = own.size();
    });
    collective_.gather(mine, counts);
    first_vertex_.clear();
    first_vertex_.push_back(0);
    for (const std::uint64_t count : counts)
        first_vertex_.push_back(first_vertex_.back() + static_cast<std::int64_t>(count));
    for (PartId p = 0; p < local; ++p) {
        const PartId part = collective_.first_local() + p;
        PartPoint* const points = arrived[p].records<PartPoint>();
        for (std::size_t i = 0; i < arrived[p].count(); ++i)
            points[i].number += first_vertex_[part];
        for (PartPoint& x : owned[p]) x.number += first_vertex_[part];
        parts_[p].begin(part, owned[p].data(), owned[p].size());
        owned[p].reset();
    }
}

void Parts::triangulate(PartsProgress& progress) {
    const PartId local = collective_.local_parts();
    progress.enter(0.1, 0.6);
    {
        Skeleton skeleton(allocator_);
        skeleton.gather(collective_, parts_);
        Buffer<PartPoint> points(allocator_), others(allocator_);
        collective_.each_local([&](PartId p) {
            const PartId part = collective_.first_local() + p;
            skeleton.points_for(part, collective_.parts(), points);
            others.clear();
            for (const PartPoint& x : points)
                if (x.number < first_vertex_[part] || x.number >= first_vertex_[part + 1])
                    others.push_back(x);
            parts_[p].insert(others.data(), others.size(), progress, p, local);
        });
    }
    progress.enter(0.6, 0.7);
    gather_boxes();
    Objects<Mail> out(allocator_, local, std::ref(allocator_)),
        in(allocator_, local, std::ref(allocator_));
    collective_.each_local([&](PartId p) {
        parts_[p].push(boxes_, collective_.parts(), out[p]);
        progress.report((p + 1.0) / local);
    });
    collective_.exchange<PartPoint>(out, in);
    progress.enter(0.7, 0.9);
    collective_.each_local([&](PartId p) {
        parts_[p].insert(in[p].records<PartPoint>(), in[p].count(), progress, p, local);
    });
}

void Parts::gather_boxes() {
    const PartId local = collective_.local_parts();
    Buffer<Box> boxes(allocator_, boxes_.size() * local);
    for (PartId p = 0; p < local; ++p)
        boxes_.divide(parts_[p].points(), parts_[p].own_count(), boxes.data() + boxes_.size() * p);
    boxes_.gather(collective_, boxes);
}

}  // namespace mgdt
