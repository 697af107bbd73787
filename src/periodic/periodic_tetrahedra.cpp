// SPDX-License-Identifier: MIT
#include "periodic/periodic_tetrahedra.hpp"

#include <algorithm>

#include "parallel/team_lists.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The even permutations of four corners. Permutation 3 i + k puts corner i first; the other three
// follow in cyclic order, starting at the k-th of them.
struct Orders {
    std::uint8_t of[12][4] = {};
    constexpr Orders() {
        constexpr std::uint8_t first[4][4] = {
            {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
        for (unsigned i = 0; i < 4; ++i)
            for (unsigned k = 0; k < 3; ++k) {
                of[3 * i + k][0] = first[i][0];
                for (unsigned j = 0; j < 3; ++j) of[3 * i + k][1 + j] = first[i][1 + (k + j) % 3];
            }
    }
};
constexpr Orders orders;

// A side whose neighbour in the mesh is not a listed tetrahedron, although another tetrahedron of
// its class is listed. The listed one has the same facet, translated.
struct OpenSide {
    Image corners[3];  // sorted, and moved such that the multiples of the first are 0
    std::int8_t moved[4];
    std::uint32_t tetrahedron, corner;

    bool has_facet_of(const OpenSide& other) const {
        for (unsigned i = 0; i < 3; ++i)
            if (order_of(corners[i]) != order_of(other.corners[i])) return false;
        return true;
    }
    bool operator<(const OpenSide& other) const {
        for (unsigned i = 0; i < 3; ++i)
            if (const std::uint64_t a = order_of(corners[i]), b = order_of(other.corners[i]);
                a != b)
                return a < b;
        return tetrahedron != other.tetrahedron ? tetrahedron < other.tetrahedron
                                                : corner < other.corner;
    }
};

OpenSide side_of(const PeriodicTetrahedra::Tetrahedron& t, std::uint32_t number, unsigned corner) {
    OpenSide side = {{}, {}, number, corner};
    for (unsigned i = 0, k = 0; i < 4; ++i)
        if (i != corner) side.corners[k++] = t.corners[i];
    std::sort(side.corners, side.corners + 3, is_before);
    std::copy_n(side.corners[0].of, 3, side.moved);
    for (Image& image : side.corners)
        for (unsigned c = 0; c < 3; ++c)
            image.of[c] = static_cast<std::int8_t>(image.of[c] - side.moved[c]);
    return side;
}

// Lists the tetrahedra of the mesh of a halo.
class Listing {
    using Neighbor = PeriodicTetrahedra::Neighbor;
    using Record = PeriodicTetrahedra::Record;

  public:
    Listing(Allocator& allocator, const Halo& halo, Buffer<Record>& records)
        : halo_(halo),
          mesh_(halo.triangulation().mesh()),
          team_(halo.triangulation().threads_for(halo.triangulation().vertex_count(),
                                                 vertices_per_thread)),
          records_(records),
          begin_(allocator),
          order_(allocator),
          slots_begin_(allocator),
          slots_(allocator),
          number_of_slot_(allocator) {}

    void run() {
        find();
        sort();
        set_neighbors();
        join_crossings();
    }

  private:
    struct Member {
        std::uint64_t orders[3];  // of corners 1 to 3
        TetId slot;
        bool operator<(const Member& other) const {
            return std::lexicographical_compare(orders, orders + 3, other.orders, other.orders + 3);
        }
    };
    static constexpr std::uint8_t is_no_representative = 0xFF;
    static constexpr std::size_t slots_per_thread = 65536, vertices_per_thread = 8192;

    std::uint32_t index_of(VertexId v) const { return mesh_.vertices[v].index; }
    // The permutation that puts the corners of a tetrahedron into the order of the list.
    std::uint8_t order_in_list(TetId slot) const {
        const Tetrahedron& t = mesh_.tetrahedra[slot];
        if (t.is_dead() || t.is_ghost()) return is_no_representative;
        bool has_own = false;
        for (const VertexId v : t.v) has_own = has_own || halo_.is_own(index_of(v));
        if (!has_own) return is_no_representative;
        unsigned least = 0;
        for (unsigned i = 1; i < 4; ++i)
            if (compare_lexicographic(mesh_.point(t.v[i]), mesh_.point(t.v[least])) < 0) least = i;
        if (!halo_.is_own(index_of(t.v[least]))) return is_no_representative;
        const auto order_at = [&](unsigned k) {
            return order_of(halo_.image(index_of(t.v[orders.of[3 * least][k]])));
        };
        const std::uint64_t a = order_at(1), b = order_at(2), c = order_at(3);
        const unsigned turn = b < a ? (c < b ? 2 : 1) : (c < a ? 2 : 0);
        return static_cast<std::uint8_t>(3 * least + turn);
    }
    // Finds the tetrahedra, and lists them by their first corners.
    void find() {
        const std::size_t slots = mesh_.tetrahedra.size();
        order_.resize(slots);
        team_.split(slots, slots_per_thread, [&](std::size_t from, std::size_t to, unsigned) {
            for (std::size_t t = from; t < to; ++t)
                order_[t] = order_in_list(static_cast<TetId>(t));
        });
        slots_begin_.resize(mesh_.vertices.size() + 1);
        make_lists(
            team_, slots_.allocator(), slots, slots_per_thread, mesh_.vertices.size(),
            slots_begin_.data(),
            [&](std::size_t from, std::size_t to, auto f) {
                for (std::size_t t = from; t < to; ++t)
                    if (order_[t] != is_no_representative)
                        f(mesh_.tetrahedra[t].v[orders.of[order_[t]][0]], static_cast<TetId>(t));
            },
            [&](std::size_t size) { slots_.resize(size); },
            [&](std::size_t position, TetId slot) { slots_[position] = slot; });
        begin_.resize(halo_.own_count() + 1, 0u);
        each_first_corner([&](std::size_t v, std::uint32_t p) {
            begin_[p + std::size_t{1}] = slots_begin_[v + 1] - slots_begin_[v];
        });
        for (std::size_t p = 0; p < halo_.own_count(); ++p) begin_[p + 1] += begin_[p];
    }
    // Calls f(vertex, point) for each point of the box that is the first corner of a tetrahedron,
    // in the order of the vertices: vertices with near numbers have near tetrahedra in memory.
    template <class F>
    void each_first_corner(const F& f) {
        team_.split(mesh_.vertices.size(), vertices_per_thread,
                    [&](std::size_t from, std::size_t to, unsigned) {
                        for (std::size_t v = std::max<std::size_t>(from, 1); v < to; ++v)
                            if (slots_begin_[v] < slots_begin_[v + 1])
                                f(v, index_of(static_cast<VertexId>(v)));
                    });
    }
    // Sorts the tetrahedra of each first corner, and writes their corners.
    void sort() {
        records_.resize(slots_.size());
        records_.prefault(0, records_.size());
        number_of_slot_.resize(mesh_.tetrahedra.size(), no_index);
        each_first_corner([&](std::size_t v, std::uint32_t p) {
            constexpr std::size_t most = 64;  // on the stack; few points have more
            Member few[most];
            TetId* const slots = slots_.begin() + slots_begin_[v];
            const std::size_t size = slots_begin_[v + 1] - slots_begin_[v];
            Buffer<Member> many(records_.allocator(), size > most ? size : 0);
            Member* const group = size > most ? many.begin() : few;
            for (std::size_t i = 0; i < size; ++i) {
                group[i].slot = slots[i];
                const Tetrahedron& t = mesh_.tetrahedra[slots[i]];
                const std::uint8_t* const order = orders.of[order_[slots[i]]];
                for (unsigned k = 0; k < 3; ++k)
                    group[i].orders[k] = order_of(halo_.image(index_of(t.v[order[1 + k]])));
            }
            std::sort(group, group + size);
            for (std::uint32_t i = 0; i < size; ++i) {
                Image* const corners = records_[begin_[p] + i].tetrahedron.corners;
                corners[0] = {p, {}};
                for (unsigned k = 0; k < 3; ++k)
                    corners[1 + k] = image_of_order(group[i].orders[k]);
                slots[i] = group[i].slot;
                number_of_slot_[slots[i]] = begin_[p] + i;
            }
        });
    }
    void set_neighbors() {
        each_first_corner([&](std::size_t v, std::uint32_t p) {
            Record* record = records_.begin() + begin_[p];
            for (std::uint32_t i = slots_begin_[v]; i < slots_begin_[v + 1]; ++i, ++record) {
                const Tetrahedron& t = mesh_.tetrahedra[slots_[i]];
                const std::uint8_t* const order = orders.of[order_[slots_[i]]];
                for (unsigned k = 0; k < 4; ++k)
                    record->neighbors[k] = {number_of_slot_[tetrahedron_of(t.n[order[k]])], {}};
            }
        });
    }
    // Finds the neighbours whose representatives are elsewhere in the mesh.
    void join_crossings() {
        Buffer<OpenSide> sides(records_.allocator());
        for (std::uint32_t i = 0; i < records_.size(); ++i)
            for (unsigned k = 0; k < 4; ++k)
                if (records_[i].neighbors[k].number == no_index)
                    sides.push_back(side_of(records_[i].tetrahedron, i, k));
        std::sort(sides.begin(), sides.end());
        const auto join = [&](const OpenSide& side, const OpenSide& other) {
            Neighbor& n = records_[side.tetrahedron].neighbors[side.corner];
            n.number = other.tetrahedron;
            for (unsigned c = 0; c < 3; ++c)
                n.of[c] = static_cast<std::int8_t>(side.moved[c] - other.moved[c]);
        };
        for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
            if (!sides[k].has_facet_of(sides[k + 1])) continue;
            join(sides[k], sides[k + 1]);
            join(sides[k + 1], sides[k]);
            ++k;
        }
    }

    const Halo& halo_;
    const Mesh& mesh_;
    Team team_;
    Buffer<Record>& records_;
    Buffer<std::uint32_t> begin_;  // where the tetrahedra of each first corner begin in the list
    Buffer<std::uint8_t> order_;   // of each slot
    // The slots of each vertex that is a first corner, in the order of the list.
    Buffer<std::uint32_t> slots_begin_;
    Buffer<TetId> slots_;
    Buffer<std::uint32_t> number_of_slot_;
};

}  // namespace

PeriodicTetrahedra::PeriodicTetrahedra(Allocator& allocator, const Halo& halo)
    : records_(allocator) {
    if (halo.own_count() > 0) Listing(allocator, halo, records_).run();
}

}  // namespace mgdt
