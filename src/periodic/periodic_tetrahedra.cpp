// SPDX-License-Identifier: MIT
#include "periodic/periodic_tetrahedra.hpp"

#include <algorithm>
#include <cstring>

#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

using Tetrahedron = PeriodicTetrahedra::Tetrahedron;
using Neighbor = PeriodicTetrahedra::Neighbor;

int compare(const Image& a, const Image& b) {
    return is_before(a, b) ? -1 : is_before(b, a) ? 1 : 0;
}

// A tetrahedron and where the mesh has it.
struct Member {
    Tetrahedron tetrahedron;
    TetId slot;

    bool operator<(const Member& other) const {
        for (unsigned i = 0; i < 4; ++i)
            if (const int c = compare(tetrahedron.corners[i], other.tetrahedron.corners[i]); c != 0)
                return c < 0;
        return false;
    }
};

// A side whose neighbour is not in the mesh as a listed tetrahedron: another one of its class is.
// It has the same facet, moved.
struct OpenSide {
    Image corners[3];  // sorted, and moved such that the multiples of the first are 0
    std::int8_t moved[4];
    std::uint32_t tetrahedron, corner;

    bool has_facet_of(const OpenSide& other) const {
        for (unsigned i = 0; i < 3; ++i)
            if (compare(corners[i], other.corners[i]) != 0) return false;
        return true;
    }
    bool operator<(const OpenSide& other) const {
        for (unsigned i = 0; i < 3; ++i)
            if (const int c = compare(corners[i], other.corners[i]); c != 0) return c < 0;
        return tetrahedron != other.tetrahedron ? tetrahedron < other.tetrahedron
                                                : corner < other.corner;
    }
};

OpenSide side_of(const Tetrahedron& t, std::uint32_t number, unsigned corner) {
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

}  // namespace

// The position of the lexicographically least corner, if the tetrahedron is the representative of
// its class; 4 otherwise.
unsigned PeriodicTetrahedra::first_position(TetId slot) const {
    const mgdt::Tetrahedron& t = mesh().tetrahedra[slot];
    if (t.is_dead() || t.is_ghost()) return 4;
    bool has_own = false;
    for (const VertexId v : t.v) has_own = has_own || halo_.is_own(mesh().vertices[v].index);
    if (!has_own) return 4;
    unsigned least = 0;
    for (unsigned i = 1; i < 4; ++i)
        if (compare_lexicographic(mesh().point(t.v[i]), mesh().point(t.v[least])) < 0) least = i;
    return halo_.is_own(mesh().vertices[t.v[least]].index) ? least : 4;
}

// The corners of a representative, and their positions in the mesh.
PeriodicTetrahedra::Tetrahedron PeriodicTetrahedra::read(TetId slot,
                                                         std::uint8_t (&positions)[4]) const {
    const mgdt::Tetrahedron& t = mesh().tetrahedra[slot];
    const unsigned least = first_position(slot);
    // Even permutations that bring a corner to the front.
    static constexpr std::uint8_t orders[4][4] = {
        {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
    Image image[4];
    for (unsigned i = 0; i < 4; ++i)
        image[i] = halo_.image(mesh().vertices[t.v[orders[least][i]]].index);
    unsigned turn = 0;
    for (unsigned i = 1; i < 3; ++i)
        if (is_before(image[1 + i], image[1 + turn])) turn = i;
    Tetrahedron found;
    found.corners[0] = image[0];
    positions[0] = orders[least][0];
    for (unsigned i = 0; i < 3; ++i) {
        const unsigned k = 1 + (turn + i) % 3;
        found.corners[i + 1] = image[k];
        positions[i + 1] = orders[least][k];
    }
    return found;
}

PeriodicTetrahedra::PeriodicTetrahedra(Allocator& allocator, const Halo& halo)
    : halo_(halo), slots_(allocator), number_of_slot_(allocator), crossings_(allocator) {
    if (halo.own_count() == 0) return;
    Buffer<std::uint32_t> begin(allocator);
    find(begin);
    sort(begin);
    find_crossings();
}

// Finds the tetrahedra and puts them in the order of their first corners. begin[p] is where those
// of point p begin.
void PeriodicTetrahedra::find(Buffer<std::uint32_t>& begin) {
    struct Found {
        TetId slot;
        std::uint32_t first;  // the first corner
    };
    Buffer<Found> found(begin.allocator());
    const std::size_t n = halo_.own_count();
    begin.resize(n + 1, 0u);
    for (TetId t = 0; t < mesh().tetrahedra.size(); ++t) {
        const unsigned position = first_position(t);
        if (position == 4) continue;
        const std::uint32_t first = mesh().vertices[mesh().tetrahedra[t].v[position]].index;
        found.push_back({t, first});
        ++begin[first];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& count : begin) sum += std::exchange(count, sum);
    slots_.resize(found.size());
    for (const Found& f : found) slots_[begin[f.first]++] = f.slot;
    for (std::size_t p = n; p > 0; --p) begin[p] = begin[p - 1];
    begin[0] = 0;
}

// Tetrahedra with consecutive numbers are anywhere in memory.
void PeriodicTetrahedra::prefetch(std::size_t i) const {
    constexpr std::size_t far = 24, near = 8;
    if (i + far < slots_.size()) mesh().tetrahedra.prefetch(slots_[i + far]);
    if (i + near >= slots_.size()) return;
    for (const VertexId v : mesh().tetrahedra[slots_[i + near]].v)
        mgdt::prefetch(&mesh().vertices[v]);
}

// Sorts the tetrahedra of each first corner.
void PeriodicTetrahedra::sort(const Buffer<std::uint32_t>& begin) {
    number_of_slot_.resize(mesh().tetrahedra.size(), none);
    Buffer<Member> group(begin.allocator());
    for (std::size_t p = 0; p < halo_.own_count(); ++p) {
        group.clear();
        for (std::uint32_t i = begin[p]; i < begin[p + 1]; ++i) {
            prefetch(i);
            std::uint8_t positions[4];
            group.push_back({read(slots_[i], positions), slots_[i]});
        }
        std::sort(group.begin(), group.end());
        for (std::uint32_t k = 0; k < group.size(); ++k) {
            slots_[begin[p] + k] = group[k].slot;
            number_of_slot_[group[k].slot] = begin[p] + k;
        }
    }
}

void PeriodicTetrahedra::find_crossings() {
    Buffer<OpenSide> sides(crossings_.allocator());
    for (TetId slot = 0; slot < number_of_slot_.size(); ++slot) {
        const std::uint32_t number = number_of_slot_[slot];
        if (number == none) continue;
        bool is_inside = true;
        for (const FacetCode across : mesh().tetrahedra[slot].n)
            is_inside = is_inside && number_of_slot_[tetrahedron_of(across)] != none;
        if (is_inside) continue;
        std::uint8_t positions[4];
        const Tetrahedron t = read(slot, positions);
        for (unsigned corner = 0; corner < 4; ++corner)
            if (number_of_slot_[tetrahedron_of(mesh().tetrahedra[slot].n[positions[corner]])] ==
                none)
                sides.push_back(side_of(t, number, corner));
    }
    std::sort(sides.begin(), sides.end());
    const auto join = [&](const OpenSide& side, const OpenSide& other) {
        Neighbor n = {other.tetrahedron, {}};
        for (unsigned c = 0; c < 3; ++c)
            n.of[c] = static_cast<std::int8_t>(side.moved[c] - other.moved[c]);
        crossings_.push_back({std::uint64_t{4} * side.tetrahedron + side.corner, n});
    };
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        const OpenSide &a = sides[k], &b = sides[k + 1];
        if (!a.has_facet_of(b)) continue;
        join(a, b);
        join(b, a);
        ++k;
    }
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.side < b.side; });
}

PeriodicTetrahedra::Tetrahedron PeriodicTetrahedra::operator[](std::size_t i) const {
    std::uint8_t positions[4];
    return read(slots_[i], positions);
}

PeriodicTetrahedra::Record PeriodicTetrahedra::record(std::size_t i) const {
    Record record;
    std::uint8_t positions[4];
    record.tetrahedron = read(slots_[i], positions);
    for (unsigned corner = 0; corner < 4; ++corner) {
        const FacetCode across = mesh().tetrahedra[slots_[i]].n[positions[corner]];
        Neighbor& neighbor = record.neighbors[corner];
        neighbor = {number_of_slot_[tetrahedron_of(across)], {}};
        if (neighbor.number != none) continue;
        const std::uint64_t side = 4 * std::uint64_t{i} + corner;
        const Crossing* const found =
            std::lower_bound(crossings_.begin(), crossings_.end(), side,
                             [](const Crossing& c, std::uint64_t s) { return c.side < s; });
        if (found != crossings_.end() && found->side == side) neighbor = found->neighbor;
    }
    return record;
}

}  // namespace mgdt
