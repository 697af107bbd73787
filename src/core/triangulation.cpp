// SPDX-License-Identifier: MIT
#include "core/triangulation.hpp"

#include "core/batch_insertion.hpp"
#include "core/insertion.hpp"
#include "core/motion.hpp"
#include "core/removal.hpp"
#include "platform/error.hpp"

namespace mgdt {

void Triangulation::insert(std::size_t n, const double* const axis[3], std::ptrdiff_t stride) {
    insert_points(state_, n, axis, stride);
}

void Triangulation::remove(const Buffer<std::uint32_t>& points) {
    remove_points(state_, points);
}

void Triangulation::move(const Buffer<std::uint32_t>& points, const double* xyz) {
    move_points(state_, points, xyz);
}

void Triangulation::forget_absent_points() noexcept {
    forget_numbering();
    state_.points.equals.forget();
    Buffer<VertexId>& map = state_.points.map;
    Buffer<Vertex>& vertices = state_.mesh.vertices;
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < map.size(); ++i) {
        const VertexId v = map[i];
        if (v == infinite_vertex) continue;
        map[next] = v;
        // A vertex has the index of its least point, which is the first one that the loop meets.
        if (vertices[v].index == i) vertices[v].index = next;
        ++next;
    }
    // The exponents include those of points that were left out of an insertion.
    if (next < map.size()) state_.points.exponents_are_wide = true;
    map.resize_within_capacity(next);
}

void Triangulation::set_indices(const Buffer<std::uint32_t>& indices) noexcept {
    Buffer<Vertex>& vertices = state_.mesh.vertices;
    for (VertexId v = 1; v < vertices.size(); ++v) vertices[v].index = indices[vertices[v].index];
}

void Triangulation::reserve(std::size_t points) {
    if (points > max_points)
        fail(MGDT_ERR_TOO_LARGE, "%zu points; at most %zu can be numbered", points, max_points);
    Mesh& mesh = state_.mesh;
    state_.points.map.reserve(points);
    mesh.vertices.reserve(points + 1);
    mesh.vertex_hint.reserve(points + 1);
    mesh.reserve_tetrahedra(expected_tetrahedra(points, mesh.slot_limit));
}

void Triangulation::set_compact(bool compact) {
    TetrahedronStore& tetrahedra = state_.mesh.tetrahedra;
    if (compact != tetrahedra.has_spheres()) return;
    if (compact) {
        tetrahedra.drop_spheres();
    } else {
        tetrahedra.make_room_for_spheres();
        state_.set_spheres();
    }
}

CheckInput Triangulation::check_input() const {
    return {state_.mesh,
            state_.points.map,
            dimension(),
            state_.statistics.points_inserted,
            state_.statistics.duplicates,
            state_.points.exponents,
            state_.points.exponents_are_wide,
            state_.walk_starts.last,
            state_.walk_starts.tree_if_made()};
}

}  // namespace mgdt
