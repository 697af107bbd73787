// SPDX-License-Identifier: MIT
#include "core/hole_filling.hpp"

#include <memory>

#include "core/insertion.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

// Memory for the state of the link, which is too large for the stack.
struct Room {
    alignas(State) unsigned char bytes[sizeof(State)];
};
struct Destroy {
    void operator()(State* t) const noexcept { t->~State(); }
};

// Fills the hole from a triangulation of the link, and returns the size of that triangulation.
// Returns 0 if the link's points do not span space.
std::size_t fill_from_link(State& state) {
    const Buffer<VertexId>& vertices = state.vertex_removal.link();
    Buffer<double> xyz(state.allocator);
    xyz.reserve(3 * vertices.size());
    for (const VertexId v : vertices)
        if (v != infinite_vertex)
            for (const double x : state.mesh.vertices[v].x) xyz.push_back(x);

    Buffer<Room> room(state.allocator, 1);
    const std::unique_ptr<State, Destroy> owned(
        new (room.data()) State(Allocator::allocate_from, Allocator::release_to, &state.allocator));
    State& link = *owned;
    link.kernel = state.kernel;
    link.settings.threads = state.settings.threads;
    link.hooks.min_points_per_thread = state.hooks.min_points_per_thread;
    link.settings.progress = [](double, void* progress) -> std::int32_t {
        return static_cast<Progress*>(progress)->is_cancelled();
    };
    link.settings.progress_user = &state.progress;
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    insert_points(link, xyz.size() / 3, axis, 3);
    if (link.points.dimension() < 3) return 0;
    state.vertex_removal.fill_from(link.mesh, state.mesh);
    return link.mesh.live_count();
}

}  // namespace

void find_link(State& state, VertexId v) {
    state.vertex_removal.find(state.mesh, v,
                              Locator{state.mesh, state.calls(), nullptr}.tetrahedron_of(v));
}

std::size_t fill_hole(State& state) {
    if (has_large_link(state))
        if (const std::size_t tetrahedra = fill_from_link(state)) return tetrahedra;
    state.vertex_removal.fill(*state.kernel, state.mesh);
    return 0;
}

}  // namespace mgdt
