// SPDX-License-Identifier: MIT
//
// All occurrences of an id are sent to one part, which compares them.
#include "parts/ids.hpp"

#include <algorithm>
#include <functional>

#include "parts/post.hpp"
#include "platform/random.hpp"

namespace mgdt {
namespace {

struct Claim {
    std::int64_t id, vertex;
    double x[3];
    std::uint64_t part;  // the part that the point was inserted into
};

}  // namespace

void require_distinct_ids(Collective& all, const GivenPoints* given, const std::int64_t* const* ids,
                          const Objects<Buffer<std::int64_t>>& vertices, Allocator& allocator) {
    Objects<Mail> out(allocator, all.local_parts(), std::ref(allocator)),
        in(allocator, all.local_parts(), std::ref(allocator));
    all.each_local([&](PartId p) {
        Post<Claim> post(allocator);
        post.reserve(given[p].n);
        for (std::size_t i = 0; i < given[p].n; ++i) {
            const auto hash = Random::at(static_cast<std::uint64_t>(ids[p][i]), 0);
            const double* const x = given[p].xyz + 3 * i;
            post.add(static_cast<PartId>(hash % all.parts()),
                     {ids[p][i], vertices[p][i], {x[0], x[1], x[2]}, all.first_local() + p});
        }
        post.put(all.parts(), out[p], nullptr);
    });
    all.exchange<Claim>(out, in);
    all.each_local([&](PartId p) {
        Claim* const claims = in[p].records<Claim>();
        Claim* const end = claims + in[p].count();
        std::sort(claims, end, [](const Claim& a, const Claim& b) {
            return a.id != b.id ? a.id < b.id : a.vertex < b.vertex;
        });
        const Claim* const a = std::adjacent_find(claims, end, [](const Claim& x, const Claim& y) {
            return x.id == y.id && x.vertex != y.vertex;
        });
        if (a == end) return;
        const Claim& b = a[1];
        all.name_no_part();
        fail(MGDT_ERR_INVALID_ARGUMENT,
             "id %lld is given to two points: (%g, %g, %g) in part %llu and (%g, %g, %g) in part "
             "%llu",
             static_cast<long long>(a->id), a->x[0], a->x[1], a->x[2],
             static_cast<unsigned long long>(a->part), b.x[0], b.x[1], b.x[2],
             static_cast<unsigned long long>(b.part));
    });
}

}  // namespace mgdt
