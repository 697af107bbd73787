// SPDX-License-Identifier: MIT
#include "dual/alpha.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "mesh/facet_turns.hpp"
#include "parallel/atomic_array.hpp"
#include "parallel/disjoint_sets.hpp"
#include "parallel/watched_split.hpp"
#include "predicates/circumcenter.hpp"
#include "predicates/facet_sphere.hpp"
#include "query/export.hpp"
#include "query/graphs.hpp"
#include "query/vertex_indices.hpp"

namespace mgdt {
namespace {

constexpr double infinite_alpha = std::numeric_limits<double>::infinity();
constexpr std::size_t slots_per_thread = 4096;

double alpha_of(const Mesh& mesh, const Tetrahedron& t) {
    return circumcenter(
               {mesh.point(t.v[0]), mesh.point(t.v[1]), mesh.point(t.v[2]), mesh.point(t.v[3])},
               mesh.scale)
        .radius2;
}

// The alpha of the tetrahedron in each slot; infinite where the slot has no finite tetrahedron.
Buffer<double> alphas_by_slot(const MeshView& view, StageProgress& progress) {
    const Mesh& mesh = view.mesh;
    Buffer<double> alphas(view.allocator, mesh.tetrahedra.size());
    watched_split(view.team, progress, mesh.tetrahedra.size(), slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for (std::size_t id = begin; id < end; ++id) {
                          const Tetrahedron& t = mesh.tetrahedra[id];
                          alphas[id] =
                              t.is_dead() || t.is_ghost() ? infinite_alpha : alpha_of(mesh, t);
                      }
                  });
    return alphas;
}

// Whether a vertex opposite the facet, in one of the two tetrahedra at the facet, is inside the
// smallest sphere through the facet's vertices. If both vertices are outside, no other vertex is
// inside.
bool is_attached(const Mesh& mesh, const VertexId (&v)[3], const Tetrahedron& t, unsigned face,
                 const Tetrahedron& other) {
    const auto is_inside = [&](VertexId apex) {
        return apex != infinite_vertex &&
               side_of_facet_sphere(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]),
                                    mesh.point(apex)) > 0;
    };
    if (is_inside(t.v[face])) return true;
    for (const VertexId apex : other.v)
        if (apex != v[0] && apex != v[1] && apex != v[2]) return is_inside(apex);
    return false;
}

// Calls f(id, face, v, alpha) once for each facet, where `id` is the lower slot of the two
// tetrahedra at the facet. The vertices v are sorted by index.
template <class F>
void for_each_facet(const MeshView& view, const Buffer<double>& alphas, std::size_t begin,
                    std::size_t end, F f) {
    const Mesh& mesh = view.mesh;
    for (std::size_t id = begin; id < end; ++id) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        if (t.is_dead()) continue;
        for (unsigned face = 0; face < 4; ++face) {
            const TetId beyond = tetrahedron_of(t.n[face]);
            if (beyond < id || (t.is_ghost() && t.v[face] != infinite_vertex)) continue;
            const unsigned char* const corner = outer_face[face];
            VertexId v[3] = {t.v[corner[0]], t.v[corner[1]], t.v[corner[2]]};
            std::sort(v, v + 3, [&](VertexId a, VertexId b) {
                return mesh.vertices[a].index < mesh.vertices[b].index;
            });
            double alpha = std::min(alphas[id], alphas[beyond]);
            if (!is_attached(mesh, v, t, face, mesh.tetrahedra[beyond]))
                alpha = std::min(
                    alpha, facet_radius2({mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])},
                                         mesh.scale));
            f(static_cast<TetId>(id), face, v, alpha);
        }
    }
}

}  // namespace

void export_tetrahedron_alphas(const MeshView& view, StageProgress& progress, double* out) {
    constexpr std::size_t stretches_per_thread = 64;
    watched_split(view.team, progress, view.numbering->stretches(), stretches_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      view.numbering->for_each(begin, end, [&](TetId id, std::size_t number) {
                          out[number] = alpha_of(view.mesh, view.mesh.tetrahedra[id]);
                      });
                  });
}

void export_facet_alphas(const MeshView& view, StageProgress& progress, double* out) {
    const Mesh& mesh = view.mesh;
    progress.enter(0, 0.4);
    const Buffer<double> alphas = alphas_by_slot(view, progress);
    const auto write = [&](TetId id, unsigned face, double alpha) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        if (t.is_ghost()) return;
        unsigned positions[4], at = 0;
        export_positions(view, t, positions);
        while (positions[at] != face) ++at;
        out[4 * static_cast<std::size_t>(view.numbering->number(id)) + at] = alpha;
    };
    progress.enter(0.4, 1);
    watched_split(view.team, progress, mesh.tetrahedra.size(), slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for_each_facet(
                          view, alphas, begin, end,
                          [&](TetId id, unsigned face, const VertexId(&)[3], double alpha) {
                              write(id, face, alpha);
                              const FacetCode beyond = mesh.tetrahedra[id].n[face];
                              write(tetrahedron_of(beyond), face_of(beyond), alpha);
                          });
                  });
}

namespace {

// Writes the alphas of all edges in the order of the caller's indices. The function is not inlined,
// so that its lists are not on the stack while circumcentres are computed.
template <class AlphaOf>
MGDT_NOT_INLINE void write_by_index(const MeshView& view, const Buffer<VertexId>& point_map,
                                    double* out, AlphaOf alpha_of) {
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    const EdgeLists edges(view, point_map.size(),
                          edges_from_lesser(view.mesh, [&](VertexId v) { return indices[v]; }));
    edges.write(
        [&](std::size_t k, std::size_t position, const std::uint32_t* others, std::size_t size) {
            for (std::size_t i = 0; i < size; ++i)
                out[position + i] = alpha_of(point_map[k], point_map[others[i]]);
        });
}

}  // namespace

void export_edge_alphas(const MeshView& view, const Buffer<VertexId>& point_map,
                        StageProgress& progress, double* out) {
    const Mesh& mesh = view.mesh;
    // The edges are listed by vertex numbers, which are near each other in memory for near
    // vertices.
    progress.enter(0, 0.2);
    const EdgeLists edges(view, mesh.vertices.size(),
                          edges_from_lesser(mesh, [](VertexId v) { return v; }));
    struct List {
        std::size_t position;
        const VertexId *begin, *end;
    };
    Buffer<List> lists(view.allocator, mesh.vertices.size());
    edges.write([&](std::size_t v, std::size_t position, const VertexId* others, std::size_t size) {
        lists[v] = {position, others, others + size};
    });
    const auto position_of = [&](VertexId a, VertexId b) {
        const List& list = lists[std::min(a, b)];
        return list.position +
               static_cast<std::size_t>(std::lower_bound(list.begin, list.end, std::max(a, b)) -
                                        list.begin);
    };
    // The bits of non-negative doubles, read as integers, have the same order as the doubles.
    const auto bits_of = [](double x) {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        return bits;
    };
    AtomicArray<std::uint64_t> least(view.allocator, edges.size());
    AtomicArray<std::uint8_t> is_attached(view.allocator, edges.size());
    progress.enter(0.2, 0.22);
    watched_split(view.team, progress, edges.size(), slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for (std::size_t e = begin; e < end; ++e)
                          least[e].store(bits_of(infinite_alpha), std::memory_order_relaxed);
                  });
    progress.enter(0.22, 0.4);
    const Buffer<double> alphas = alphas_by_slot(view, progress);
    const auto add_facet = [&](TetId, unsigned, const VertexId(&v)[3], double alpha) {
        const unsigned obtuse =
            obtuse_corner({mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])});
        for (unsigned i = 0; i < 3; ++i) {
            const std::size_t e = position_of(v[(i + 1) % 3], v[(i + 2) % 3]);
            if (i == obtuse) is_attached[e].store(1, std::memory_order_relaxed);
            std::uint64_t known = least[e].load(std::memory_order_relaxed);
            while (
                bits_of(alpha) < known &&
                !least[e].compare_exchange_weak(known, bits_of(alpha), std::memory_order_relaxed)) {
            }
        }
    };
    progress.enter(0.4, 0.9);
    watched_split(view.team, progress, mesh.tetrahedra.size(), slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for_each_facet(view, alphas, begin, end, add_facet);
                  });
    const auto alpha_at = [&](std::size_t position, VertexId a, VertexId b) {
        double alpha;
        const std::uint64_t bits = least[position].load(std::memory_order_relaxed);
        std::memcpy(&alpha, &bits, sizeof bits);
        if (is_attached[position].load(std::memory_order_relaxed) != 0) return alpha;
        return std::min(alpha, edge_radius2(mesh.point(a), mesh.point(b), mesh.scale));
    };
    progress.enter(0.9, 1);
    if (!view.canonical) {
        // The export is in the order of these lists.
        edges.write(
            [&](std::size_t v, std::size_t position, const VertexId* others, std::size_t size) {
                for (std::size_t i = 0; i < size; ++i)
                    out[position + i] = alpha_at(position + i, static_cast<VertexId>(v), others[i]);
            });
        return;
    }
    write_by_index(view, point_map, out,
                   [&](VertexId a, VertexId b) { return alpha_at(position_of(a, b), a, b); });
}

void export_vertex_alphas(const MeshView& view, std::size_t points, double* out) {
    std::fill_n(out, points, infinite_alpha);
    for (VertexId v = 1; v < view.mesh.vertices.size(); ++v) out[view.mesh.vertices[v].index] = 0;
}

Buffer<std::uint32_t> alpha_surface(const MeshView& view, double alpha2, StageProgress& progress) {
    const Mesh& mesh = view.mesh;
    progress.enter(0, 0.7);
    const Buffer<double> alphas = alphas_by_slot(view, progress);
    struct Facet {
        std::uint32_t v[3];
    };
    Buffer<Facet> facets(view.allocator);
    progress.enter(0.7, 1);
    for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
        progress.step(id, 0, mesh.tetrahedra.size());
        const Tetrahedron& t = mesh.tetrahedra[id];
        if (t.is_dead() || t.is_ghost() || !(alphas[id] <= alpha2)) continue;
        for (unsigned face = 0; face < 4; ++face) {
            const TetId beyond = tetrahedron_of(t.n[face]);
            if (!mesh.tetrahedra[beyond].is_ghost() && alphas[beyond] <= alpha2) continue;
            // Seen from outside, the vertices in the order of outer_face are clockwise.
            const unsigned char* const corner = outer_face[face];
            Facet f = {{mesh.vertices[t.v[corner[0]]].index, mesh.vertices[t.v[corner[2]]].index,
                        mesh.vertices[t.v[corner[1]]].index}};
            turn_to_least(f.v);
            facets.push_back(f);
        }
    }
    std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) {
        return std::lexicographical_compare(a.v, a.v + 3, b.v, b.v + 3);
    });
    Buffer<std::uint32_t> surface(view.allocator);
    surface.reserve(3 * facets.size());
    for (const Facet& f : facets)
        for (const std::uint32_t index : f.v) surface.push_back(index);
    return surface;
}

double solid_alpha(const MeshView& view, StageProgress& progress) {
    const Mesh& mesh = view.mesh;
    progress.enter(0, 0.4);
    const Buffer<double> alphas = alphas_by_slot(view, progress);
    Buffer<TetId> order(view.allocator);
    order.reserve(mesh.finite_count());
    for (TetId id = 0; id < mesh.tetrahedra.size(); ++id)
        if (!mesh.tetrahedra[id].is_dead() && !mesh.tetrahedra[id].is_ghost()) order.push_back(id);
    progress.enter(0.4, 0.8);
    std::size_t steps = 0;
    const StopRequest stop = progress.stop_request();
    std::sort(order.begin(), order.end(), [&](TetId a, TetId b) {
        stop.poll_in_step(steps++);
        return alphas[a] < alphas[b];
    });
    progress.enter(0.8, 1);
    DisjointSets parts(view.allocator, mesh.tetrahedra.size());
    Buffer<bool> is_in(view.allocator), is_reached(view.allocator);
    is_in.resize(mesh.tetrahedra.size(), false);
    is_reached.resize(mesh.vertices.size(), false);
    std::size_t solids = 0, vertices_left = mesh.vertices.size() - 1;
    for (std::size_t k = 0; k < order.size(); ++k) {
        progress.step(k, 0, order.size());
        const TetId id = order[k];
        const Tetrahedron& t = mesh.tetrahedra[id];
        is_in[id] = true;
        ++solids;
        for (unsigned i = 0; i < 4; ++i) {
            vertices_left -= !is_reached[t.v[i]];
            is_reached[t.v[i]] = true;
            const TetId beyond = tetrahedron_of(t.n[i]);
            if (is_in[beyond] && parts.join(id, beyond)) --solids;
        }
        // All tetrahedra with the same alpha are added before the solid is tested.
        const bool is_last = k + 1 == order.size() || alphas[order[k + 1]] > alphas[id];
        if (is_last && solids == 1 && vertices_left == 0) return alphas[id];
    }
    return order.empty() ? 0 : infinite_alpha;
}

}  // namespace mgdt
