// SPDX-License-Identifier: MIT
// What fills the hole of a vertex: the kernel finds it facet by facet. With very many neighbours
// that is slow: then they are triangulated by themselves, and the tetrahedra inside the hole are
// taken from there. Where memory lacks for that the removal fails, for the other way may take
// hours.
#include <memory>

#include "core/triangulation.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

// As the memory of another handle: it is counted, and limited, as this one's.
void* allocate_from(std::size_t bytes, std::size_t align, void* allocator) {
    try {
        return static_cast<Allocator*>(allocator)->allocate(bytes, align);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void release_to(void* p, std::size_t bytes, std::size_t align, void* allocator) {
    static_cast<Allocator*>(allocator)->release(p, bytes, align);
}

// Where a triangulation is: the stack that a call may take has no room for it.
struct Room {
    alignas(Triangulation) unsigned char bytes[sizeof(Triangulation)];
};
struct Destroy {
    void operator()(Triangulation* t) const noexcept { t->~Triangulation(); }
};

}  // namespace

void Triangulation::find_link(VertexId v) {
    vertex_removal_.find(mesh_, v, Locator{mesh_, calls(), nullptr}.tetrahedron_of(v));
}

std::size_t Triangulation::fill_hole() {
    if (has_large_link())
        if (const std::size_t tetrahedra = fill_from_link()) return tetrahedra;
    vertex_removal_.fill(*kernel_, mesh_);
    return 0;
}

// Returns 0 where the link's points do not span space.
std::size_t Triangulation::fill_from_link() {
    const Buffer<VertexId>& vertices = vertex_removal_.link();
    Buffer<double> xyz(allocator_);
    xyz.reserve(3 * vertices.size());
    for (const VertexId v : vertices)
        if (v != infinite_vertex)
            for (const double x : mesh_.vertices[v].x) xyz.push_back(x);

    Buffer<Room> room(allocator_, 1);
    const std::unique_ptr<Triangulation, Destroy> owned(
        new (room.data()) Triangulation(allocate_from, release_to, &allocator_));
    Triangulation& link = *owned;
    link.set_kernel(*kernel_);
    link.settings_.threads = settings_.threads;
    link.hooks_.min_points_per_thread = hooks_.min_points_per_thread;
    link.settings_.progress = [](double, void* request) -> std::int32_t {
        return static_cast<Atomic<bool>*>(request)->load(std::memory_order_relaxed);
    };
    link.settings_.progress_user = &cancelled_;
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    link.insert(xyz.size() / 3, axis, 3);
    if (link.dimension() < 3) return 0;
    vertex_removal_.fill_from(link.mesh(), mesh_);
    return link.mesh().live_count();
}

}  // namespace mgdt
