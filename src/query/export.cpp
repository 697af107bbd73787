// SPDX-License-Identifier: MIT
#include "query/export.hpp"

#include <algorithm>
#include <cstdint>

#include "mesh/facet_turns.hpp"
#include "platform/streaming.hpp"
#include "query/canonical_sort.hpp"
#include "query/vertex_indices.hpp"

namespace mgdt {
namespace {

// Looks up the index of a vertex in its record, for exports of few indices.
struct IndicesInPlace {
    const Mesh& mesh;
    std::uint32_t operator[](VertexId v) const { return mesh.vertices[v].index; }
};

}  // namespace

void export_positions(const MeshView& view, const Tetrahedron& t, unsigned positions[4]) {
    if (view.canonical) {
        Numbering::canonical_positions(t, IndicesInPlace{view.mesh}, positions);
    } else {
        for (unsigned i = 0; i < 4; ++i) positions[i] = i;
    }
}

namespace {

// Writes rows of four values. Rows of large arrays are written by non-temporal stores where the
// processor has them: the rows are not read again here, and fetching their cache lines first would
// double the traffic.
template <class Int>
class Rows {
  public:
    Rows(Int* out, bool is_large)
        : out_(out),
          streams_(is_large && reinterpret_cast<std::uintptr_t>(out) % streaming_alignment == 0) {}
    // Each thread calls this once, after its last row.
    static void finish() { finish_streaming(); }

    void add(Int a, Int b, Int c, Int d) {
        if (streams_) {
            stream_four(out_, a, b, c, d);
        } else {
            out_[0] = a;
            out_[1] = b;
            out_[2] = c;
            out_[3] = d;
        }
        out_ += 4;
    }

  private:
    Int* out_;
    const bool streams_;
};

// The least number of stretches per thread.
constexpr std::size_t stretches_per_thread = 1024;
// An array of this many bytes or more does not fit into the cache beside its source.
constexpr std::size_t large_array = std::size_t{1} << 20;
// The prefetch distance, in records.
constexpr std::size_t ahead = 32;

// Writes the four values row(t, i), for each slot i, of each finite tetrahedron t at the position
// of its number, on all threads. Tetrahedra are read in the order of storage; canonical rows are
// written in another order.
template <bool with_spheres, class Int, class Indices, class Row>
void export_rows(const MeshView& view, const Indices& indices, Int* out, const Row& shared) {
    const Numbering& numbering = *view.numbering;
    const bool is_large = view.mesh.finite_count() >= large_array / (4 * sizeof(Int));
    const auto write = [&](std::size_t begin, std::size_t end, unsigned) {
        if (begin == end) return;
        // The compiler can keep local copies in registers, although the loop writes memory of any
        // type.
        const auto tetrahedra = view.mesh.tetrahedra.view<with_spheres>();
        const Row row = shared;
        if (view.canonical) {
            numbering.for_each(begin, end, [&](TetId id, std::size_t number) {
                const Tetrahedron& t = tetrahedra[id];
                prefetch(&tetrahedra[id + ahead]);
                unsigned positions[4];
                Numbering::canonical_positions(t, indices, positions);
                for (unsigned i = 0; i < 4; ++i) out[4 * number + i] = row(t, positions[i]);
            });
        } else {
            // There is one loop per run, so that the end of the output stays in a register and no
            // function is called per row. Otherwise the export would take twice as long.
            numbering.for_each_run(begin, end, [&](TetId first, TetId last, std::size_t number) {
                Rows<Int> rows(out + 4 * number, is_large);
                for (TetId id = first; id < last; ++id) {
                    const Tetrahedron& t = tetrahedra[id];
                    prefetch(&tetrahedra[id + ahead]);
                    rows.add(row(t, 0), row(t, 1), row(t, 2), row(t, 3));
                }
            });
            Rows<Int>::finish();
        }
    };
    view.team.split(numbering.stretches(), stretches_per_thread, write);
}
template <class Int, class Indices, class Row>
void export_rows(const MeshView& view, const Indices& indices, Int* out, const Row& row) {
    if (view.mesh.tetrahedra.has_spheres())
        export_rows<true>(view, indices, out, row);
    else
        export_rows<false>(view, indices, out, row);
}

// The ghosts in ascending order, sorted by means of a bitmap of the slots.
Buffer<TetId> ghosts_by_slot(const MeshView& view) {
    const std::size_t words = view.mesh.tetrahedra.size() / 64 + 1;
    Buffer<std::uint64_t> bits(view.allocator);
    bits.resize(words, 0);
    Buffer<TetId> ghosts = ghosts_of(view.mesh, view.allocator, [&](TetId t) {
        const std::uint64_t bit = std::uint64_t{1} << (t & 63);
        const bool is_new = (bits[t >> 6] & bit) == 0;
        bits[t >> 6] |= bit;
        return is_new;
    });
    ghosts.clear();
    for (std::size_t word = 0; word < words; ++word)
        for (std::uint64_t left = bits[word]; left != 0; left &= left - 1)
            ghosts.push_back(static_cast<TetId>(word * 64) + lowest_bit(left));
    return ghosts;
}

// The values of rows. The operators are inlined, since calls would take a quarter of the export's
// time.
template <class Int>
struct VertexIndex {
    MGDT_ALWAYS_INLINE Int operator()(const Tetrahedron& t, unsigned i) const {
        return static_cast<Int>(indices[t.v[i]]) + base;
    }
    const std::uint32_t* indices;
    Int base;
};
template <class Int, class Number>
struct NeighborNumber {
    MGDT_ALWAYS_INLINE Int operator()(const Tetrahedron& t, unsigned i) const {
        return static_cast<Int>(number(tetrahedron_of(t.n[i]))) + base;
    }
    Number number;
    Int base;
};

struct HullFacet {
    std::uint32_t v[3];
    bool operator<(const HullFacet& other) const {
        return v[1] != other.v[1] ? v[1] < other.v[1] : v[2] < other.v[2];
    }
};

// The vertices of a hull facet, counter-clockwise as seen from outside, the least index first:
// (q, a, b, c) is positively oriented for q inside the hull.
HullFacet hull_facet(const Mesh& mesh, TetId ghost) {
    const Tetrahedron& t = mesh.tetrahedra[ghost];
    const unsigned char* const face = outer_face[t.infinite_slot()];
    HullFacet f;
    for (int i = 0; i < 3; ++i) f.v[i] = mesh.vertices[t.v[face[i]]].index;
    turn_to_least(f.v);
    return f;
}

}  // namespace

template <class Int>
void export_tetrahedra(const MeshView& view, Int* out) {
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    export_rows(view, indices, out, VertexIndex<Int>{indices.data(), static_cast<Int>(view.base)});
}

namespace {

template <class Int, class Indices>
void export_neighbors(const MeshView& view, const Indices& indices, Int* out) {
    const Numbering& numbering = *view.numbering;
    const Int base = static_cast<Int>(view.base);
    if (numbering.is_by_slot())
        export_rows(view, indices, out,
                    NeighborNumber<Int, Numbering::BySlot>{numbering.by_slot(), base});
    else
        export_rows(view, indices, out,
                    NeighborNumber<Int, Numbering::ByBits>{numbering.by_bits(), base});
}

}  // namespace

template <class Int>
void export_neighbors(const MeshView& view, Int* out) {
    if (view.canonical)
        export_neighbors(view, VertexIndices(view.team, view.mesh, view.allocator), out);
    else
        export_neighbors(view, IndicesInPlace{view.mesh}, out);
}

template <class Int>
void export_hull_facets(const MeshView& view, Int* out) {
    const Buffer<TetId> ghosts = ghosts_by_slot(view);
    constexpr std::size_t min_items_per_thread = 32768;
    const auto write = [&](std::size_t position, const HullFacet& f) {
        for (unsigned i = 0; i < 3; ++i)
            out[3 * position + i] = static_cast<Int>(f.v[i]) + static_cast<Int>(view.base);
    };
    if (!view.canonical) {
        view.team.split(ghosts.size(), min_items_per_thread,
                        [&](std::size_t begin, std::size_t end, unsigned) {
                            for (std::size_t k = begin; k < end; ++k)
                                write(k, hull_facet(view.mesh, ghosts[k]));
                        });
        return;
    }
    const auto each = [&](std::size_t begin, std::size_t end, auto f) {
        for (std::size_t k = begin; k < end; ++k) {
            const HullFacet facet = hull_facet(view.mesh, ghosts[k]);
            f(facet.v[0], facet);
        }
    };
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    canonical_sort<HullFacet>(
        view.team, view.allocator, ghosts.size(), min_items_per_thread, indices.end(), each,
        [&](std::size_t, std::size_t position, const HullFacet& f) { write(position, f); });
}

template <class Int>
void export_point_map(const MeshView& view, const Buffer<VertexId>& point_map, Int* out) {
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    constexpr std::size_t min_items_per_thread = 65536;
    view.team.split(
        point_map.size(), min_items_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::uint32_t index = indices[point_map[k]];
                out[k] = index == no_index ? static_cast<Int>(view.base - 1)
                                           : static_cast<Int>(index) + static_cast<Int>(view.base);
            }
        });
}

template <class Int>
void export_vertex_tetrahedra(const MeshView& view, std::size_t points, Int* offsets, Int* list) {
    const Mesh& mesh = view.mesh;
    const Numbering& numbering = *view.numbering;
    const Int base = static_cast<Int>(view.base);
    const VertexIndices indices(view.team, mesh, view.allocator);
    const auto each = [&](std::size_t begin, std::size_t end, auto f) {
        numbering.for_each(begin, end, [&](TetId id, std::size_t number) {
            const Tetrahedron& t = mesh.tetrahedra[id];
            mesh.tetrahedra.prefetch(id + ahead);
            for (const VertexId v : t.v) f(indices[v], static_cast<Int>(number) + base);
        });
    };
    make_lists(
        view.team, view.allocator, numbering.stretches(), stretches_per_thread, points, offsets,
        each, [](std::size_t) {},
        [&](std::size_t position, Int number) { list[position] = number; });
    // Each list is in the order of storage, so lists of canonical numbers are not sorted yet.
    constexpr std::size_t min_items_per_thread = 16384;
    if (numbering.is_canonical())
        view.team.split(points, min_items_per_thread,
                        [&](std::size_t begin, std::size_t end, unsigned) {
                            for (std::size_t k = begin; k < end; ++k)
                                std::sort(list + offsets[k], list + offsets[k + 1]);
                        });
    for (std::size_t k = 0; k <= points; ++k) offsets[k] += base;
}

#define MGDT_INSTANTIATE(Int)                                                       \
    template void export_tetrahedra(const MeshView&, Int*);                         \
    template void export_neighbors(const MeshView&, Int*);                          \
    template void export_hull_facets(const MeshView&, Int*);                        \
    template void export_point_map(const MeshView&, const Buffer<VertexId>&, Int*); \
    template void export_vertex_tetrahedra(const MeshView&, std::size_t, Int*, Int*);
MGDT_INSTANTIATE(std::int64_t)
MGDT_INSTANTIATE(std::int32_t)
#undef MGDT_INSTANTIATE

}  // namespace mgdt
