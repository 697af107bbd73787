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

// A tetrahedron that is to be listed, and where the mesh has it.
struct Found {
    Tetrahedron tetrahedron;
    TetId slot;
    std::uint8_t positions[4];  // of its corners in the mesh

    bool operator<(const Found& other) const {
        for (unsigned i = 0; i < 4; ++i)
            if (const int c = compare(tetrahedron.corners[i], other.tetrahedron.corners[i]); c != 0)
                return c < 0;
        return false;
    }
};

// A side whose neighbour is not in the mesh as a listed tetrahedron: another one of its class is.
// It has the same facet, moved.
struct Side {
    Image corners[3];  // sorted, and moved such that the multiples of the first are 0
    std::int8_t moved[4];
    std::uint32_t tetrahedron, corner;

    bool has_facet_of(const Side& other) const {
        for (unsigned i = 0; i < 3; ++i)
            if (compare(corners[i], other.corners[i]) != 0) return false;
        return true;
    }
    bool operator<(const Side& other) const {
        for (unsigned i = 0; i < 3; ++i)
            if (const int c = compare(corners[i], other.corners[i]); c != 0) return c < 0;
        return tetrahedron != other.tetrahedron ? tetrahedron < other.tetrahedron
                                                : corner < other.corner;
    }
};

Side side_of(const Tetrahedron& t, std::uint32_t number, unsigned corner) {
    Side side = {{}, {}, number, corner};
    for (unsigned i = 0, k = 0; i < 4; ++i)
        if (i != corner) side.corners[k++] = t.corners[i];
    std::sort(side.corners, side.corners + 3, is_before);
    std::copy_n(side.corners[0].of, 3, side.moved);
    for (Image& image : side.corners)
        for (unsigned c = 0; c < 3; ++c)
            image.of[c] = static_cast<std::int8_t>(image.of[c] - side.moved[c]);
    return side;
}

class Listing {
  public:
    Listing(const Halo& halo, Allocator& allocator, const StopRequest& stop)
        : halo_(halo),
          mesh_(halo.triangulation().mesh()),
          stop_(stop),
          found_(allocator),
          begin_(allocator),
          number_of_slot_(allocator),
          sides_(allocator) {}

    void list(Buffer<Tetrahedron>& tetrahedra, Buffer<Neighbor>& neighbors) {
        find();
        sort();
        tetrahedra.resize(found_.size());
        for (std::size_t i = 0; i < found_.size(); ++i) tetrahedra[i] = found_[i].tetrahedron;
        find_neighbors(tetrahedra, neighbors);
        join_sides(neighbors);
    }

  private:
    static constexpr std::uint32_t none = PeriodicTetrahedra::none;

    // Sets `found` if the tetrahedron is the representative of its class.
    bool is_listed(TetId slot, Found& found) const {
        const mgdt::Tetrahedron& t = mesh_.tetrahedra[slot];
        if (t.is_dead() || t.is_ghost()) return false;
        std::uint32_t index[4];
        bool has_own = false;
        for (unsigned i = 0; i < 4; ++i) {
            index[i] = mesh_.vertices[t.v[i]].index;
            has_own = has_own || halo_.is_own(index[i]);
        }
        if (!has_own) return false;
        unsigned least = 0;
        for (unsigned i = 1; i < 4; ++i)
            if (compare_lexicographic(mesh_.point(t.v[i]), mesh_.point(t.v[least])) < 0) least = i;
        if (!halo_.is_own(index[least])) return false;
        found.slot = slot;
        // Even permutations that bring a corner to the front.
        static constexpr unsigned char orders[4][4] = {
            {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
        const unsigned char* const order = orders[least];
        Image rest[3];
        unsigned turn = 0;
        for (unsigned i = 0; i < 3; ++i) {
            rest[i] = halo_.image(index[order[i + 1]]);
            if (is_before(rest[i], rest[turn])) turn = i;
        }
        found.tetrahedron.corners[0] = halo_.image(index[least]);
        found.positions[0] = static_cast<std::uint8_t>(least);
        for (unsigned i = 0; i < 3; ++i) {
            const unsigned k = (turn + i) % 3;
            found.tetrahedron.corners[i + 1] = rest[k];
            found.positions[i + 1] = order[k + 1];
        }
        return true;
    }
    // Finds the tetrahedra and puts them in the order of their first corners.
    void find() {
        begin_.resize(halo_.own_count() + 1, 0u);
        Found found;
        for (TetId t = 0; t < mesh_.tetrahedra.size(); ++t) {
            stop_.poll_in_step(t);
            if (is_listed(t, found)) ++begin_[found.tetrahedron.corners[0].point + 1];
        }
        for (std::size_t p = 0; p < halo_.own_count(); ++p) begin_[p + 1] += begin_[p];
        found_.resize(begin_[halo_.own_count()]);
        for (TetId t = 0; t < mesh_.tetrahedra.size(); ++t) {
            stop_.poll_in_step(t);
            if (is_listed(t, found)) found_[begin_[found.tetrahedron.corners[0].point]++] = found;
        }
    }
    void sort() {
        std::size_t from = 0;
        for (std::size_t p = 0; p < halo_.own_count(); ++p) {
            std::sort(found_.begin() + from, found_.begin() + begin_[p]);
            from = begin_[p];
        }
        number_of_slot_.resize(mesh_.tetrahedra.size(), none);
        for (std::uint32_t i = 0; i < found_.size(); ++i) number_of_slot_[found_[i].slot] = i;
    }
    void find_neighbors(const Buffer<Tetrahedron>& tetrahedra, Buffer<Neighbor>& neighbors) {
        neighbors.resize(4 * tetrahedra.size());
        for (std::uint32_t i = 0; i < found_.size(); ++i) {
            stop_.poll_in_step(i);
            for (unsigned corner = 0; corner < 4; ++corner) {
                const FacetCode across =
                    mesh_.tetrahedra[found_[i].slot].n[found_[i].positions[corner]];
                const std::uint32_t number = number_of_slot_[tetrahedron_of(across)];
                neighbors[4 * std::size_t{i} + corner] = {number, {}};
                if (number == none) sides_.push_back(side_of(tetrahedra[i], i, corner));
            }
        }
    }
    void join_sides(Buffer<Neighbor>& neighbors) {
        std::sort(sides_.begin(), sides_.end());
        for (std::size_t k = 0; k + 1 < sides_.size(); ++k) {
            const Side &a = sides_[k], &b = sides_[k + 1];
            if (!a.has_facet_of(b)) continue;
            set_neighbor(a, b, neighbors);
            set_neighbor(b, a, neighbors);
            ++k;
        }
    }
    static void set_neighbor(const Side& side, const Side& other, Buffer<Neighbor>& neighbors) {
        Neighbor& n = neighbors[4 * std::size_t{side.tetrahedron} + side.corner];
        n.number = other.tetrahedron;
        for (unsigned c = 0; c < 3; ++c)
            n.of[c] = static_cast<std::int8_t>(side.moved[c] - other.moved[c]);
    }

    const Halo& halo_;
    const Mesh& mesh_;
    const StopRequest stop_;
    Buffer<Found> found_;
    Buffer<std::uint32_t> begin_;  // where the tetrahedra of each first corner begin, then end
    Buffer<std::uint32_t> number_of_slot_;
    Buffer<Side> sides_;
};

}  // namespace

void PeriodicTetrahedra::list(const Halo& halo, const StopRequest& stop) {
    clear();
    if (halo.own_count() == 0) return;
    Listing(halo, allocator_, stop).list(tetrahedra_, neighbors_);
}

}  // namespace mgdt
