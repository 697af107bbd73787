// SPDX-License-Identifier: MIT
#include "refinement/refiner.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace mgdt {

// Finds out which tetrahedra are bad.
void Refiner::judge_all(StageProgress& progress) {
    const Mesh& mesh = mesh_.walled.mesh;
    mesh_.verdicts.resize(mesh.tetrahedra.size());
    constexpr std::size_t tetrahedra_per_thread = 1024;
    team_.split(mesh.tetrahedra.size(), tetrahedra_per_thread,
                [&](std::size_t begin, std::size_t end, unsigned member) {
                    for (std::size_t t = begin; t < end; ++t) {
                        progress.step(t, begin, end, member);
                        const Tetrahedron& tet = mesh.tetrahedra[t];
                        mesh_.verdicts[t] = tet.is_dead() || tet.is_ghost()
                                                ? Verdict()
                                                : Verdict(mesh_.excess(tet.v));
                    }
                });
}

// Divides the mesh for the next pass, and supplies its zones. Returns false if nothing is left to
// do.
bool Refiner::prepare(std::size_t pass) {
    constexpr std::size_t vertices_per_zone = 20000, least_single = 1000;
    const std::size_t vertices = mesh_.walled.mesh.vertices.size() - 1 - mesh_.free_vertices.size();
    const std::size_t left = most_points - inserted;
    const std::size_t count =
        is_single_ ? 1 : std::max<std::size_t>(vertices / vertices_per_zone, 1);
    const double shift = std::fmod(0.382 * static_cast<double>(pass), 1.0);
    division_.divide(mesh_, count, shift, team_);
    const std::size_t bad = division_.tetrahedra.size() + division_.bad_between;
    if (bad == 0 || left == 0) return false;
    std::size_t most = left;
    if (count > 1 && division_.wanted_between > division_.wanted_inside) {
        // Most cavities would be between zones: the mesh is too coarse for them.
        division_.divide(mesh_, 1, 0, team_);
        most = std::min(left, std::max(vertices / 4, least_single));
    } else if (count > 1 && bad < vertices / 8) {
        division_.divide(mesh_, 1, 0, team_);
    }
    supply(most);
    return true;
}

// Gives each zone the slots and vertices that it may need.
void Refiner::supply(std::size_t most) {
    Mesh& mesh = mesh_.walled.mesh;
    supplies_.clear();
    double wanted = 0;
    const auto limit_of = [](const ZoneDivision::Zone& zone) {
        constexpr double growth = 3, least = 16, safety = 1.5;
        return std::min(safety * zone.wanted, growth * static_cast<double>(zone.vertices)) + least;
    };
    for (const ZoneDivision::Zone& zone : division_.zones)
        if (zone.begin != zone.end) wanted += limit_of(zone);
    const double share = std::min(1.0, static_cast<double>(most) / wanted);
    std::size_t vertices = 0, slots = 0, room = 0;
    constexpr std::size_t slots_per_vertex = 8, least_slots = 256;
    struct Part {
        std::size_t vertices, slots, room;
    };
    Buffer<Part> parts(slots_.allocator());
    for (const ZoneDivision::Zone& zone : division_.zones) {
        Part part = {0, 0, 0};
        if (zone.begin != zone.end) {
            part.vertices = static_cast<std::size_t>(share * limit_of(zone));
            if (division_.zones.size() == 1)
                part.vertices = std::max(part.vertices, std::size_t{1});
            part.slots = slots_per_vertex * part.vertices + least_slots;
            // A zone may free as many slots as it has tetrahedra.
            part.room = part.slots + zone.tetrahedra;
        }
        parts.push_back(part);
        vertices += part.vertices;
        slots += part.slots;
        room += part.room;
    }
    // Free slots and vertices come first.
    const std::size_t free_slots = std::min(slots, mesh.free_slots.size()),
                      free_vertices = std::min(vertices, mesh_.free_vertices.size());
    auto next_slot = static_cast<TetId>(mesh.tetrahedra.size());
    auto next_vertex = static_cast<VertexId>(mesh.vertices.size());
    mesh_.walled.add_slots(slots - free_slots);
    mesh_.walled.add_vertices(vertices - free_vertices);
    mesh_.resize();
    for (TetId t = next_slot; t < mesh.tetrahedra.size(); ++t) mesh.tetrahedra[t].kill();
    slots_.resize(room);
    vertices_.resize(vertices);
    std::size_t at_slot = 0, at_vertex = 0;
    for (const Part& part : parts) {
        ZoneSupply supply;
        supply.first_slot = supply.slots_end = slots_.begin() + at_slot;
        for (std::size_t i = 0; i < part.slots; ++i) {
            TetId slot = next_slot;
            if (mesh.free_slots.empty()) {
                ++next_slot;
            } else {
                slot = mesh.free_slots.back();
                mesh.free_slots.pop_back();
            }
            *supply.slots_end++ = slot;
        }
        at_slot += part.room;
        supply.next_vertex = vertices_.begin() + at_vertex;
        for (std::size_t i = 0; i < part.vertices; ++i) {
            VertexId v = next_vertex;
            if (mesh_.free_vertices.empty()) {
                ++next_vertex;
            } else {
                v = mesh_.free_vertices.back();
                mesh_.free_vertices.pop_back();
            }
            vertices_[at_vertex++] = v;
        }
        supply.vertices_end = vertices_.begin() + at_vertex;
        supplies_.push_back(supply);
    }
}

void Refiner::run_zones(StageProgress& progress) {
    division_.close(mesh_.walled.mesh);
    const std::size_t zones = division_.zones.size();
    const unsigned members = team_.members_for(zones, 1);
    queue_.deal(zones, 1, members);
    team_.run(members, [&](unsigned member) {
        unsigned from = member;
        WorkQueue::Piece piece;
        while (queue_.next(member, from, piece)) {
            const ZoneDivision::Zone& zone = division_.zones[piece.begin];
            refiners_[member].run(division_.tetrahedra.begin() + zone.begin,
                                  division_.tetrahedra.begin() + zone.end, supplies_[piece.begin],
                                  [&](std::size_t i) {
                                      constexpr std::size_t interval = 256;
                                      if (i % interval == 0)
                                          progress.look(piece.begin, zones, member);
                                  });
        }
    });
    division_.open(mesh_.walled.mesh);
}

// Takes back what the zones have not used.
void Refiner::take_back() {
    Mesh& mesh = mesh_.walled.mesh;
    std::size_t free = mesh.free_slots.size();
    for (const ZoneSupply& supply : supplies_) free += supply.slots();
    mesh.free_slots.grow(free);
    for (const ZoneSupply& supply : supplies_) {
        for (const TetId* t = supply.first_slot; t != supply.slots_end; ++t)
            mesh.free_slots.push_back(*t);
        for (const VertexId* v = supply.next_vertex; v != supply.vertices_end; ++v)
            mesh_.free_vertices.push_back(*v);
    }
    // The lowest ones are taken first.
    std::sort(mesh_.free_vertices.begin(), mesh_.free_vertices.end(), std::greater<>());
    const std::size_t all = count_inserted();
    is_single_ = all == inserted || all - inserted < division_.bad_between / 64;
    inserted = all;
}

std::size_t Refiner::count_inserted() const noexcept {
    std::size_t all = walls_ ? walls_->inserted : 0;
    for (const ZoneRefiner& refiner : refiners_) all += refiner.inserted;
    return all;
}

void Refiner::run(StageProgress& progress) {
    constexpr double first = 0.05, share = 0.2;
    progress.enter(0, first);
    if (walls_) {
        mesh_.resize();
        walls_->divide_by_size(most_points - inserted, progress);
        inserted = count_inserted();
    }
    judge_all(progress);
    progress.leave_behind(first);
    while (prepare(passes)) {
        progress.enter(0, share);
        run_zones(progress);
        progress.leave_behind(share);
        take_back();
        ++passes;
        if (walls_) {
            walls_->divide_by_shape(calls_, most_points - inserted, progress);
            inserted = count_inserted();
        }
    }
}

}  // namespace mgdt
