// SPDX-License-Identifier: MIT
//
// The owner of a tetrahedron sends the tetrahedron's number to the other parts that have it. The
// owners of two adjacent tetrahedra need not know each other: both owners send the numbers of their
// tetrahedra to the home of the least vertex of the shared facet.
#include "parts/part_tetrahedra.hpp"

#include <algorithm>
#include <functional>

#include "parts/post.hpp"
#include "platform/random.hpp"

namespace mgdt {
namespace {

// The sorted vertices of a tetrahedron or of a facet, by which parts identify it.
template <int n>
struct Key {
    std::int64_t v[n];

    friend bool operator<(const Key& a, const Key& b) {
        return std::lexicographical_compare(a.v, a.v + n, b.v, b.v + n);
    }
    friend bool operator==(const Key& a, const Key& b) { return std::equal(a.v, a.v + n, b.v); }
};

struct Numbered {
    Key<4> key;
    std::int64_t number;
    std::uint64_t coordinates;  // a hash of the corners' coordinates, to verify that numbers agree
};

// One side of a facet: the vertices of the facet, and the number of the tetrahedron on this side.
struct FacetSide {
    Key<3> key;
    std::int64_t tetrahedron;
};

}  // namespace

void PartTetrahedra::get_vertices(const Part& part, std::int64_t* vertices) const {
    const auto own = static_cast<std::uint32_t>(part.own_count());
    const std::int64_t first = own > 0 ? part.point(0).number : 0;
    for (std::size_t i = 0; i < size(); ++i) {
        std::uint32_t v[4];
        corners(part, i, v);
        for (const std::uint32_t k : v) *vertices++ = k < own ? first + k : part.point(k).number;
    }
}

void PartTetrahedra::get_positions(const Part& part, std::int64_t* positions) const {
    Buffer<std::uint32_t> position(slots_.allocator(), part.point_count());
    const auto own = static_cast<std::uint32_t>(part.own_count());
    for (std::uint32_t i = 0; i < own; ++i) position[i] = i;
    for (std::size_t i = 0; i < ghosts_.size(); ++i)
        position[ghosts_[i]] = own + static_cast<std::uint32_t>(i);
    for (std::size_t i = 0; i < size(); ++i) {
        std::uint32_t v[4];
        corners(part, i, v);
        for (const std::uint32_t k : v) *positions++ = position[k];
    }
}

void PartTetrahedra::get_neighbors(const Part& part, std::int64_t* neighbors) const {
    const Mesh& mesh = part.triangulation().mesh();
    Buffer<std::uint32_t> position(slots_.allocator());
    position.resize(mesh.tetrahedra.size(), no_index);
    for (std::size_t i = 0; i < owned_; ++i) position[slots_[i]] = static_cast<std::uint32_t>(i);
    const Across* next = across_.begin();
    for (std::size_t side = 0; side < 4 * owned_; ++side) {
        const TetId beyond = tetrahedron_of(mesh.tetrahedra[slots_[side / 4]].n[side % 4]);
        if (position[beyond] != no_index)
            neighbors[side] = number(position[beyond]);
        else if (next != across_.end() && next->side == side)
            neighbors[side] = (next++)->number;
        else
            neighbors[side] = -1;  // on the hull
    }
}

// The slots of owned tetrahedra are sorted, which allows a binary search.
std::size_t PartTetrahedra::index_of_owned(TetId slot) const {
    return static_cast<std::size_t>(
        std::lower_bound(slots_.begin(), slots_.begin() + owned_, slot) - slots_.begin());
}

std::size_t PartTetrahedra::list(const Part& part, PartId self, std::int64_t first,
                                 Buffer<std::size_t>* at_border) {
    Buffer<TetId> of_others(slots_.allocator());
    Buffer<unsigned char> is_corner(slots_.allocator());
    is_corner.resize(part.point_count(), 0);
    self_ = self;
    first_ = first;
    slots_.reserve(part.triangulation().mesh().live_count());
    part.each_tetrahedron([&](TetId slot, const std::uint32_t(&v)[4], unsigned own, bool is_owned) {
        for (const std::uint32_t k : v) is_corner[k] = 1;
        if (at_border && is_owned && own < 4) at_border->push_back(slots_.size());
        (is_owned ? slots_ : of_others).push_back(slot);
    });
    owned_ = slots_.size();
    for (const TetId slot : of_others) slots_.push_back(slot);
    numbers_.resize(of_others.size());
    owners_.resize(of_others.size());
    for (std::size_t k = part.own_count(); k < part.point_count(); ++k)
        if (is_corner[k]) ghosts_.push_back(static_cast<std::uint32_t>(k));
    std::sort(ghosts_.begin(), ghosts_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return part.point(a).number < part.point(b).number;
    });
    return owned_;
}

bool PartTetrahedra::is_like(const PartTetrahedra& other) const {
    const auto equal = [](const auto& a, const auto& b) {
        return a.size() == b.size() &&
               (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
    };
    return owned_ == other.owned_ && first_ == other.first_ && equal(slots_, other.slots_) &&
           equal(numbers_, other.numbers_) && equal(owners_, other.owners_) &&
           equal(across_, other.across_) && equal(ghosts_, other.ghosts_);
}

void PartTetrahedra::forget() {
    owned_ = 0;
    slots_.reset();
    numbers_.reset();
    owners_.reset();
    across_.reset();
    ghosts_.reset();
}

class TetrahedraFinder {
  public:
    TetrahedraFinder(Collective& all, const Homes& homes, const Objects<Part>& parts,
                     Objects<PartTetrahedra>& found, Buffer<std::int64_t>& first,
                     Allocator& allocator)
        : all_(all),
          homes_(homes),
          parts_(parts),
          found_(found),
          first_(first),
          allocator_(allocator),
          at_border_(allocator, parts.size(), std::ref(allocator)),
          out_(allocator, parts.size(), std::ref(allocator)),
          in_(allocator, parts.size(), std::ref(allocator)) {}

    void find() {
        all_.each_local([&](PartId p) {
            found_[p].list(parts_[p], all_.first_local() + p, 0, &at_border_[p]);
        });
        number();
        tell_numbers();
        find_neighbors();
    }

  private:
    void number() {
        Buffer<std::uint64_t> mine(allocator_, parts_.size()), counts(allocator_);
        for (PartId p = 0; p < parts_.size(); ++p) mine[p] = found_[p].owned_;
        all_.gather(mine, counts);
        first_.clear();
        first_.push_back(0);
        for (const std::uint64_t count : counts)
            first_.push_back(first_.back() + static_cast<std::int64_t>(count));
        for (PartId p = 0; p < parts_.size(); ++p)
            found_[p].first_ = first_[all_.first_local() + p];
    }
    // The key of tetrahedron i, or of its facet without the corner `left_out`.
    template <int n>
    Key<n> key(PartId p, std::size_t i, int left_out) const {
        std::uint32_t v[4];
        found_[p].corners(parts_[p], i, v);
        Key<n> key;
        int k = 0;
        for (int corner = 0; corner < 4; ++corner)
            if (corner != left_out) key.v[k++] = parts_[p].point(v[corner]).number;
        std::sort(key.v, key.v + n);
        return key;
    }
    // A hash of the coordinates, which does not depend on the order of the corners.
    std::uint64_t mixed_coordinates(PartId p, std::size_t i) const {
        std::uint32_t v[4];
        found_[p].corners(parts_[p], i, v);
        std::uint64_t sum = 0;
        for (const std::uint32_t k : v) {
            std::uint64_t mixed = 0;
            for (const double x : parts_[p].point(k).x) {
                std::uint64_t bits;
                std::memcpy(&bits, &x, sizeof bits);
                mixed = Random::at(mixed ^ bits, 0);
            }
            sum += mixed;
        }
        return sum;
    }
    // Sends the number of each owned tetrahedron at the border to the homes of its corners that
    // belong to other parts.
    void tell_numbers() {
        for (PartId p = 0; p < parts_.size(); ++p) {
            const PartTetrahedra& t = found_[p];
            Post<Numbered> post(allocator_);
            for (const std::size_t i : at_border_[p]) {
                std::uint32_t v[4];
                t.corners(parts_[p], i, v);
                PartId told[4];
                unsigned count = 0;
                for (const std::uint32_t k : v) {
                    if (k < parts_[p].own_count()) continue;
                    const PartId to = homes_.of(parts_[p].point(k).x);
                    if (std::find(told, told + count, to) != told + count) continue;
                    told[count++] = to;
                    post.add(to, {key<4>(p, i, -1), t.number(i), mixed_coordinates(p, i)});
                }
            }
            post.put(all_.parts(), out_[p], nullptr);
        }
        all_.exchange<Numbered>(out_, in_);
        all_.each_local([&](PartId p) { hear_numbers(p); });
    }
    void hear_numbers(PartId p) {
        struct Told {
            Key<4> key;
            std::int64_t number;
            std::uint64_t coordinates;
            PartId owner;
        };
        const Numbered* const told = in_[p].records<Numbered>();
        Buffer<Told> sorted(allocator_);
        sorted.reserve(in_[p].count());
        for (PartId from = 0; from < all_.parts(); ++from)
            for (std::uint64_t k = in_[p].begin[from]; k < in_[p].begin[std::size_t{from} + 1]; ++k)
                sorted.push_back({told[k].key, told[k].number, told[k].coordinates, from});
        std::sort(sorted.begin(), sorted.end(),
                  [](const Told& a, const Told& b) { return a.key < b.key; });
        PartTetrahedra& t = found_[p];
        if (sorted.size() > t.size() - t.owned_)
            fail(MGDT_ERR_CHECK_FAILED, "a tetrahedron is not in this part, where it has a corner");
        for (std::size_t i = t.owned_; i < t.size(); ++i) {
            const Key<4> wanted = key<4>(p, i, -1);
            const Told* const found =
                std::lower_bound(sorted.begin(), sorted.end(), wanted,
                                 [](const Told& a, const Key<4>& b) { return a.key < b; });
            if (found == sorted.end() || !(found->key == wanted))
                fail(MGDT_ERR_CHECK_FAILED, "a tetrahedron here is owned by no part");
            if (found->coordinates != mixed_coordinates(p, i))
                fail(MGDT_ERR_CHECK_FAILED,
                     "a tetrahedron has other coordinates here than in part %u, which owns it",
                     found->owner);
            t.numbers_[i - t.owned_] = found->number;
            t.owners_[i - t.owned_] = found->owner;
        }
    }
    // Lists the facets of owned tetrahedra beyond which this part owns no tetrahedron. The hull
    // facets of a tetrahedron with four own corners are left out: the part has all tetrahedra at
    // these corners, so it knows that there is none beyond the facet.
    void list_across(PartId p) {
        PartTetrahedra& t = found_[p];
        const Part& part = parts_[p];
        const Mesh& mesh = part.triangulation().mesh();
        t.across_.clear();
        for (const std::size_t i : at_border_[p])
            for (unsigned face = 0; face < 4; ++face)
                if (!part.owns(tetrahedron_of(mesh.tetrahedra[t.slots_[i]].n[face])))
                    t.across_.push_back({4 * i + face, -1});
        for (std::size_t i = t.owned_; i < t.size(); ++i)
            for (const auto link : mesh.tetrahedra[t.slots_[i]].n)
                if (part.owns(tetrahedron_of(link)))
                    t.across_.push_back(
                        {4 * t.index_of_owned(tetrahedron_of(link)) + face_of(link), -1});
        const auto less = [](const PartTetrahedra::Across& a, const PartTetrahedra::Across& b) {
            return a.side < b.side;
        };
        std::sort(t.across_.begin(), t.across_.end(), less);
        const auto* const end =
            std::unique(t.across_.begin(), t.across_.end(),
                        [](const PartTetrahedra::Across& a, const PartTetrahedra::Across& b) {
                            return a.side == b.side;
                        });
        t.across_.resize(static_cast<std::size_t>(end - t.across_.begin()));
    }
    void find_neighbors() {
        Objects<Buffer<std::uint64_t>> positions(allocator_, parts_.size(), std::ref(allocator_));
        for (PartId p = 0; p < parts_.size(); ++p) {
            PartTetrahedra& t = found_[p];
            Post<FacetSide> post(allocator_);
            list_across(p);
            for (const PartTetrahedra::Across& a : t.across_) {
                const auto i = static_cast<std::size_t>(a.side / 4);
                const int face = static_cast<int>(a.side % 4);
                post.add(meeting_place(p, i, face), {key<3>(p, i, face), t.number(i)});
            }
            post.put(all_.parts(), out_[p], &positions[p]);
        }
        all_.exchange<FacetSide>(out_, in_);
        all_.each_local([&](PartId p) { answer_sides(in_[p], out_[p]); });
        all_.exchange<std::int64_t>(out_, in_);
        for (PartId p = 0; p < parts_.size(); ++p)
            for (std::size_t k = 0; k < positions[p].size(); ++k)
                found_[p].across_[k].number = in_[p].records<std::int64_t>()[positions[p][k]];
    }
    // Replies to each record with the tetrahedron on the other side of the facet, or -1.
    void answer_sides(const Mail& asked, Mail& reply) {
        const FacetSide* const sides = asked.records<FacetSide>();
        const std::size_t n = asked.count();
        Buffer<std::size_t> order(allocator_, n);
        for (std::size_t k = 0; k < n; ++k) order[k] = k;
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return sides[a].key < sides[b].key; });
        std::int64_t* const beyond = begin_replies<std::int64_t>(asked, reply);
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t here = order[k];
            beyond[here] = -1;
            if (k + 1 == n || !(sides[here].key == sides[order[k + 1]].key)) continue;
            const std::size_t there = order[++k];
            beyond[here] = sides[there].tetrahedron;
            beyond[there] = sides[here].tetrahedron;
        }
    }
    // The home of a facet's least vertex.
    PartId meeting_place(PartId p, std::size_t i, int face) const {
        std::uint32_t v[4];
        found_[p].corners(parts_[p], i, v);
        const double* least = nullptr;
        for (int k = 0; k < 4; ++k) {
            const double* const x = parts_[p].point(v[k]).x;
            if (k != face && (!least || precedes(x, least))) least = x;
        }
        return homes_.of(least);
    }

    Collective& all_;
    const Homes& homes_;
    const Objects<Part>& parts_;
    Objects<PartTetrahedra>& found_;
    Buffer<std::int64_t>& first_;
    Allocator& allocator_;
    Objects<Buffer<std::size_t>> at_border_;  // owned tetrahedra with corners of other parts
    Objects<Mail> out_, in_;
};

void find_tetrahedra(Collective& all, const Homes& homes, const Objects<Part>& parts,
                     Objects<PartTetrahedra>& found, Buffer<std::int64_t>& first,
                     Allocator& allocator) {
    TetrahedraFinder(all, homes, parts, found, first, allocator).find();
}

}  // namespace mgdt
