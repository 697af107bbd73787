// SPDX-License-Identifier: MIT
//
// There may be too many points for an extra copy. So a first pass counts the points of each home,
// and a second pass writes each point directly to its position in the mail. A third pass counts the
// points again, to find the position of each point.
#include "parts/settlement.hpp"

#include <algorithm>
#include <functional>

#include "parts/post.hpp"
#include "platform/hash.hpp"
#include "platform/number_table.hpp"
#include "platform/random.hpp"

namespace mgdt {
namespace {

class Settlement {
  public:
    Settlement(Collective& all, const Homes& homes, const GivenPoints* given,
               const std::int64_t* const* ids, Allocator& allocator)
        : all_(all),
          homes_(homes),
          given_(given),
          ids_(ids),
          allocator_(allocator),
          first_id_(allocator),
          arrived_(allocator, all.local_parts(), std::ref(allocator)),
          vertices_(allocator, all.local_parts(), std::ref(allocator)) {}

    void settle(Objects<Part>& parts, Buffer<std::int64_t>& first_vertex,
                Objects<Buffer<std::int64_t>>& of_given) {
        count_ids();
        for (PartId p = 0; p < all_.local_parts(); ++p) of_given[p].resize(given_[p].n);
        if (all_.local_parts() == all_.parts())
            in_one_process(parts, first_vertex, of_given);
        else
            in_processes(parts, first_vertex, of_given);
    }

  private:
    void count_ids() {
        Buffer<std::uint64_t> counts(allocator_), mine(allocator_, all_.local_parts());
        for (PartId p = 0; p < all_.local_parts(); ++p) mine[p] = given_[p].n;
        all_.gather(mine, counts);
        std::int64_t id = 0;
        for (PartId p = 0; p < all_.parts(); ++p) {
            if (p >= all_.first_local() && p - all_.first_local() < all_.local_parts())
                first_id_.push_back(id);
            id += static_cast<std::int64_t>(counts[p]);
        }
    }
    // Calls visit(i, home) for each point i of a local part.
    template <class Visit>
    void each_given(PartId p, const Visit& visit) const {
        for (std::size_t i = 0; i < given_[p].n; ++i) visit(i, homes_.of(given_[p].xyz + 3 * i));
    }
    PartPoint point(PartId p, std::size_t i) const {
        const double* const x = given_[p].xyz + 3 * i;
        return {
            {x[0], x[1], x[2]}, ids_ ? ids_[p][i] : first_id_[p] + static_cast<std::int64_t>(i), 0};
    }

    // If all parts are in one process, no mail is sent. Each point is written directly to the
    // memory of its home, so that only one further copy of the points exists.
    void in_one_process(Objects<Part>& parts, Buffer<std::int64_t>& first_vertex,
                        Objects<Buffer<std::int64_t>>& of_given) {
        Buffer<std::uint64_t> next(allocator_);
        next.resize(all_.parts(), 0);
        for (PartId p = 0; p < all_.parts(); ++p)
            each_given(p, [&](std::size_t, PartId home) { ++next[home]; });
        for (PartId p = 0; p < all_.parts(); ++p) {
            arrived_[p].begin.push_back(next[p]);
            arrived_[p].bytes.resize(bytes_of(next[p], sizeof(PartPoint)));
            next[p] = 0;
        }
        for (PartId p = 0; p < all_.parts(); ++p)
            each_given(p, [&](std::size_t i, PartId home) {
                arrived_[home].records<PartPoint>()[next[home]++] = point(p, i);
            });
        make_vertices(parts, first_vertex);
        next.clear();
        next.resize(all_.parts(), 0);
        for (PartId p = 0; p < all_.parts(); ++p)
            each_given(p, [&](std::size_t i, PartId home) {
                of_given[p][i] =
                    first_vertex[home] + vertices_[home][static_cast<std::size_t>(next[home]++)];
            });
    }

    void in_processes(Objects<Part>& parts, Buffer<std::int64_t>& first_vertex,
                      Objects<Buffer<std::int64_t>>& of_given) {
        const PartId local = all_.local_parts();
        Objects<Mail> out(allocator_, local, std::ref(allocator_)),
            replies(allocator_, local, std::ref(allocator_));
        Objects<Buffer<std::uint64_t>> begin(allocator_, local, std::ref(allocator_));
        Buffer<std::uint64_t> next(allocator_);
        all_.each_local([&](PartId p) {
            begin[p].resize(std::size_t{all_.parts()} + 1, 0);
            each_given(p, [&](std::size_t, PartId home) { ++begin[p][std::size_t{home} + 1]; });
            for (std::size_t q = 0; q < all_.parts(); ++q) begin[p][q + 1] += begin[p][q];
            copy(begin[p], out[p].begin);
            copy(begin[p], next);
            out[p].bytes.resize(given_[p].n * sizeof(PartPoint));
            each_given(p, [&](std::size_t i, PartId home) {
                out[p].records<PartPoint>()[next[home]++] = point(p, i);
            });
        });
        all_.exchange<PartPoint>(out, arrived_);
        for (Mail& mail : out) mail.bytes.reset();
        make_vertices(parts, first_vertex);
        for (PartId p = 0; p < local; ++p) {
            // Replies have the order of the records that were sent.
            std::int64_t* const answers = begin_replies<std::int64_t>(arrived_[p], out[p]);
            for (std::size_t i = 0; i < vertices_[p].size(); ++i)
                answers[i] = first_vertex[all_.first_local() + p] + vertices_[p][i];
        }
        all_.exchange<std::int64_t>(out, replies);
        for (PartId p = 0; p < local; ++p) {
            copy(begin[p], next);
            each_given(p, [&](std::size_t i, PartId home) {
                of_given[p][i] = replies[p].records<std::int64_t>()[next[home]++];
            });
        }
    }
    static void copy(const Buffer<std::uint64_t>& from, Buffer<std::uint64_t>& to) {
        to.resize(from.size());
        std::copy(from.begin(), from.end(), to.data());
    }

    // Equal points become one vertex, with the least of their ids.
    void make_vertices(Objects<Part>& parts, Buffer<std::int64_t>& first_vertex) {
        Buffer<std::uint64_t> counts(allocator_), mine(allocator_, all_.local_parts());
        all_.each_local([&](PartId p) {
            // The distinct points move to the front.
            PartPoint* const points = arrived_[p].records<PartPoint>();
            const std::size_t n = arrived_[p].count();
            // A triangulation numbers fewer than `in_cavity` vertices.
            if (n >= in_cavity)
                fail(MGDT_ERR_TOO_LARGE, "%zu points are at home here; take more parts", n);
            NumberTable distinct(allocator_);
            distinct.reserve(n);
            vertices_[p].resize(n);
            std::uint32_t kept = 0;
            for (std::size_t i = 0; i < n; ++i) {
                const double* const x = points[i].x;
                const std::uint32_t found =
                    distinct.number(hash_of_coordinates(x), [&](std::uint32_t k) {
                        const double* const y = points[k].x;
                        return y[0] == x[0] && y[1] == x[1] && y[2] == x[2];
                    });
                vertices_[p][i] = found;
                if (found == kept)
                    points[kept++] = points[i];
                else if (points[i].id < points[found].id)
                    points[found] = points[i];
            }
            mine[p] = kept;
        });
        all_.gather(mine, counts);
        first_vertex.clear();
        first_vertex.push_back(0);
        for (const std::uint64_t count : counts)
            first_vertex.push_back(first_vertex.back() + static_cast<std::int64_t>(count));
        for (PartId p = 0; p < all_.local_parts(); ++p) {
            const PartId part = all_.first_local() + p;
            parts[p].begin(part, first_vertex[part], arrived_[p].records<PartPoint>(),
                           static_cast<std::size_t>(mine[p]));
            arrived_[p].bytes.reset();
        }
    }

    Collective& all_;
    const Homes& homes_;
    const GivenPoints* given_;
    const std::int64_t* const* ids_;
    Allocator& allocator_;
    // The id of the first point of each local part, if the caller gives no ids.
    Buffer<std::int64_t> first_id_;
    Objects<Mail> arrived_;                    // the points that arrived at each local part
    Objects<Buffer<std::uint32_t>> vertices_;  // the vertex of each point that arrived
};

}  // namespace

void settle_points(Collective& all, const Homes& homes, const GivenPoints* given,
                   const std::int64_t* const* ids, Objects<Part>& parts,
                   Buffer<std::int64_t>& first_vertex, Objects<Buffer<std::int64_t>>& of_given,
                   Allocator& allocator) {
    Settlement(all, homes, given, ids, allocator).settle(parts, first_vertex, of_given);
}

}  // namespace mgdt
