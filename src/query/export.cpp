// SPDX-License-Identifier: MIT
#include "query/export.hpp"

#include <algorithm>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "query/incidence.hpp"

namespace mgdt {
namespace {

struct HullFacet {
    std::uint32_t v[3];
    bool operator<(const HullFacet& other) const {
        return std::lexicographical_compare(v, v + 3, other.v, other.v + 3);
    }
};

}  // namespace

void export_places(const ExportView& view, const Tetrahedron& t, unsigned places[4]) {
    if (view.canonical) {
        Numbering::canonical_places(view.mesh, t, places);
    } else {
        for (unsigned i = 0; i < 4; ++i) places[i] = i;
    }
}

// Four values at a time, past the cache where that can be: what is written is not read here, and
// fetching the lines first would cost as much again.
template <class Int>
class Rows {
  public:
    explicit Rows(Int* out)
        : out_(out), streams_(reinterpret_cast<std::uintptr_t>(out) % sizeof(Wide) == 0) {}
#if defined(__SSE2__)
    ~Rows() {
        _mm_sfence();
    }
#endif

    void add(Int a, Int b, Int c, Int d) {
        const Int row[4] = {a, b, c, d};
#if defined(__SSE2__)
        if (streams_) {
            for (unsigned i = 0; i < 4; i += 16 / sizeof(Int)) {
                Wide wide;
                std::memcpy(&wide, row + i, sizeof wide);
                _mm_stream_si128(reinterpret_cast<Wide*>(out_ + i), wide);
            }
            out_ += 4;
            return;
        }
#endif
        std::copy(row, row + 4, out_);
        out_ += 4;
    }

  private:
#if defined(__SSE2__)
    using Wide = __m128i;
#else
    using Wide = Int;
#endif
    Int* out_;
    const bool streams_;
};

// Stretches of the numbering that a thread should have at least.
constexpr std::size_t stretches_a_thread = 1024;
// Records between one that is read and one that is asked for.
constexpr std::size_t ahead = 32;

// Calls add(t, places, rows) for the finite tetrahedra in order, the threads side by side.
template <class Int, class Add>
void export_rows(const ExportView& view, Int* out, Add add) {
    const Mesh& mesh = view.mesh;
    const Numbering& numbering = *view.numbering;
    view.team.split(numbering.stretches(), stretches_a_thread,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                        if (begin == end) return;
                        Rows<Int> rows(out + 4 * numbering.first_number(begin));
                        numbering.for_each(begin, end, [&](TetId id) {
                            const Tetrahedron& t = mesh.tetrahedra[id];
                            prefetch(&t + ahead);
                            unsigned places[4];
                            export_places(view, t, places);
                            add(t, places, rows);
                        });
                    });
}

template <class Int>
void export_tetrahedra(const ExportView& view, Int* out) {
    const Mesh& mesh = view.mesh;
    // The indices by themselves fit the cache where the vertices' records do not.
    Buffer<Int> index(view.allocator, mesh.vertices.size());
    view.team.split(index.size(), 65536, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t v = begin; v < end; ++v)
            index[v] = static_cast<Int>(mesh.vertices[v].index) + static_cast<Int>(view.base);
    });
    export_rows(view, out, [&](const Tetrahedron& t, const unsigned* p, Rows<Int>& rows) {
        rows.add(index[t.v[p[0]]], index[t.v[p[1]]], index[t.v[p[2]]], index[t.v[p[3]]]);
    });
}

template <class Int>
void export_neighbors(const ExportView& view, Int* out) {
    const Int none = static_cast<Int>(view.base - 1);
    const Numbering& numbering = *view.numbering;
    const auto number = [&](FacetCode code) {
        return numbering.is_finite(code >> 2)
                   ? static_cast<Int>(numbering.rank(code >> 2)) + static_cast<Int>(view.base)
                   : none;
    };
    export_rows(view, out, [&](const Tetrahedron& t, const unsigned* p, Rows<Int>& rows) {
        rows.add(number(t.n[p[0]]), number(t.n[p[1]]), number(t.n[p[2]]), number(t.n[p[3]]));
    });
}

template <class Int>
void export_hull_facets(const ExportView& view, Int* out) {
    const Mesh& mesh = view.mesh;
    Buffer<HullFacet> facets(view.allocator);
    facets.reserve(mesh.ghost_count);
    for (const Tetrahedron& t : mesh.tetrahedra) {
        if (t.is_dead() || !t.is_ghost()) continue;
        // (q, a, b, c) is positive for q inside the hull, so (a, b, c) turns counter-clockwise
        // seen from outside.
        const int slot = t.infinite_slot();
        const unsigned char* face = outer_face[slot];
        HullFacet f;
        for (int i = 0; i < 3; ++i) f.v[i] = mesh.vertices[t.v[face[i]]].index;
        std::rotate(f.v, std::min_element(f.v, f.v + 3), f.v + 3);
        facets.push_back(f);
    }
    if (view.canonical) std::sort(facets.begin(), facets.end());
    for (const HullFacet& f : facets)
        for (const std::uint32_t v : f.v)
            *out++ = static_cast<Int>(v) + static_cast<Int>(view.base);
}

template <class Int>
void export_edges(const ExportView& view, Int* out) {
    const Mesh& mesh = view.mesh;
    const Incidence around(mesh, view.allocator);
    // In canonical output edges go by the caller's indices.
    Buffer<VertexId> vertices(view.allocator, mesh.vertices.size() - 1);
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) vertices[v - 1] = v;
    const bool sorted = view.canonical;
    const auto by_index = [&](VertexId a, VertexId b) {
        return mesh.vertices[a].index < mesh.vertices[b].index;
    };
    if (sorted) std::sort(vertices.begin(), vertices.end(), by_index);
    Buffer<VertexId> seen_from(view.allocator);
    seen_from.resize(mesh.vertices.size(), infinite_vertex);
    Buffer<VertexId> ends(view.allocator);
    for (const VertexId v : vertices) {
        ends.clear();
        for (const TetId id : around.tetrahedra(v)) {
            if (mesh.tetrahedra[id].is_ghost()) continue;
            for (const VertexId end : mesh.tetrahedra[id].v) {
                if (seen_from[end] == v || !by_index(v, end)) continue;
                seen_from[end] = v;
                ends.push_back(end);
            }
        }
        if (sorted) std::sort(ends.begin(), ends.end(), by_index);
        for (const VertexId end : ends) {
            *out++ = static_cast<Int>(mesh.vertices[v].index) + static_cast<Int>(view.base);
            *out++ = static_cast<Int>(mesh.vertices[end].index) + static_cast<Int>(view.base);
        }
    }
}

template <class Int>
void export_point_map(const ExportView& view, const Buffer<VertexId>& point_map, Int* out) {
    for (const VertexId v : point_map)
        *out++ = v == infinite_vertex
                     ? static_cast<Int>(view.base - 1)
                     : static_cast<Int>(view.mesh.vertices[v].index) + static_cast<Int>(view.base);
}

template <class Int>
void export_vertex_tetrahedra(const ExportView& view, std::size_t points, Int* offsets, Int* list) {
    const Mesh& mesh = view.mesh;
    const Int base = static_cast<Int>(view.base);
    std::fill(offsets, offsets + points + 1, Int{0});
    view.numbering->for_each([&](TetId id) {
        for (const VertexId v : mesh.tetrahedra[id].v) ++offsets[mesh.vertices[v].index + 1u];
    });
    // Positions of the lists' beginnings; filling moves each to its end, the next one's beginning.
    Buffer<Int> next(view.allocator, points + 1);
    for (std::size_t k = 1; k <= points; ++k) offsets[k] += offsets[k - 1];
    std::copy(offsets, offsets + points + 1, next.begin());
    std::size_t number = 0;
    view.numbering->for_each([&](TetId id) {
        for (const VertexId v : mesh.tetrahedra[id].v)
            list[next[mesh.vertices[v].index]++] = static_cast<Int>(number) + base;
        ++number;
    });
    for (std::size_t k = 0; k <= points; ++k) offsets[k] += base;
}

#define MGDT_INSTANTIATE(Int)                                                         \
    template void export_tetrahedra(const ExportView&, Int*);                         \
    template void export_neighbors(const ExportView&, Int*);                          \
    template void export_hull_facets(const ExportView&, Int*);                        \
    template void export_edges(const ExportView&, Int*);                              \
    template void export_point_map(const ExportView&, const Buffer<VertexId>&, Int*); \
    template void export_vertex_tetrahedra(const ExportView&, std::size_t, Int*, Int*);
MGDT_INSTANTIATE(std::int64_t)
MGDT_INSTANTIATE(std::int32_t)

}  // namespace mgdt
