// SPDX-License-Identifier: MIT
#include "core/zones.hpp"

#include <algorithm>
#include <cassert>

namespace mgdt {
namespace {

constexpr std::size_t min_items_per_thread = 8192;
constexpr std::uint8_t no_zone = 255;

}  // namespace

Zones::Zones(Team& team, Allocator& allocator, const Schedule& schedule, std::size_t n)
    : team_(team),
      rounds_(schedule.rounds),
      n_(n),
      zone_(allocator),
      at_border_(allocator),
      between_(team, allocator, &allocator) {}

void Zones::divide(unsigned count, const Round& round, const Mesh& mesh) {
    if (count != count_) {
        zone_.resize(first_vertex + n_);
        zone_[infinite_vertex] = no_zone;
        count_ = count;
        for (std::size_t r = 0; r < rounds_.size(); ++r) {
            const std::size_t begin = rounds_[r],
                              end = r + 1 < rounds_.size() ? rounds_[r + 1] : n_;
            for (unsigned zone = 0; zone < count; ++zone)
                std::fill(zone_.begin() + first_vertex + first({begin, end, begin}, zone),
                          zone_.begin() + first_vertex + first({begin, end, begin}, zone + 1),
                          static_cast<std::uint8_t>(zone));
        }
    }
    find_between(mesh);

    begin_ = round.begin;
    const std::size_t near = round.begin - round.before;
    share_ = static_cast<double>(near) / static_cast<double>(round.size());
    // One entry for each vertex of the previous round, and one more at either end, so that the loop
    // below may write to both neighbours of every vertex.
    at_border_.clear();
    at_border_.resize(near + 2, 0);
    for (const Part& part : between_)
        for (const Closed& c : part.closed)
            for (const VertexId v : mesh.tetrahedra[c.tetrahedron].v) {
                if (v < first_vertex + round.before) continue;
                // The neighbours of v along the curve are near the border as well.
                std::uint8_t* const before = &at_border_[v - first_vertex - round.before];
                before[0] = before[1] = before[2] = 1;
            }
}

bool Zones::is_between(const Tetrahedron& t) const noexcept {
    // The first two vertices of a record are finite.
    const std::uint8_t zone = zone_[t.v[0]];
    const auto is_other = [&](VertexId v) { return (zone_[v] != zone) & (v != infinite_vertex); };
    return (zone_[t.v[1]] != zone) | is_other(t.v[2]) | is_other(t.v[3]);
}

void Zones::find_between(const Mesh& mesh) {
    for (Part& part : between_) part.closed.clear();
    team_.split(mesh.tetrahedra.size(), min_items_per_thread,
                [&](std::size_t begin, std::size_t end, unsigned member) {
                    for (std::size_t t = begin; t < end; ++t) {
                        const Tetrahedron& tet = mesh.tetrahedra[t];
                        if (tet.is_dead() || !is_between(tet)) continue;
                        between_[member].closed.push_back({static_cast<TetId>(t), 0});
                    }
                });
}

void Zones::close(Mesh& mesh) {
    find_between(mesh);
    team_.run(team_.size(), [&](unsigned member) {
        for (Closed& c : between_[member].closed) {
            KeptSphere& sphere = mesh.tetrahedra.sphere(c.tetrahedron);
            c.bound = sphere.e;
            sphere.close();
        }
    });
}

void Zones::open(Mesh& mesh) noexcept {
    team_.run(team_.size(), [&](unsigned member) {
        for (const Closed& c : between_[member].closed) {
            KeptSphere& sphere = mesh.tetrahedra.sphere(c.tetrahedron);
            assert(sphere.is_closed() && "the tetrahedron is open already");
            sphere.e = c.bound;
        }
    });
}

void Zones::forget() noexcept {
    zone_.reset();
    at_border_.reset();
    for (Part& part : between_) part.closed.reset();
    count_ = 0;
}

}  // namespace mgdt
