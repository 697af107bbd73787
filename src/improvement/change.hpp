// SPDX-License-Identifier: MIT
// A change of a mesh that is proposed: tetrahedra that leave, and those that fill their place.
#pragma once

#include "platform/memory.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

struct Change {
    // Stands for the vertex that comes with the change.
    static constexpr std::uint32_t new_vertex = 0xFFFFFFFEu;

    struct Tetrahedron {
        std::uint32_t v[4];  // corners, positively oriented
        std::uint32_t region;
        double quality;
    };
    // A face that becomes a part of a facet. Its corners appear counter-clockwise from the
    // tetrahedron on the first side.
    struct Face {
        std::uint32_t v[3];
        std::uint32_t label;
    };

    explicit Change(Allocator& allocator)
        : removed(allocator), added(allocator), faces(allocator) {}

    void clear() noexcept {
        removed.clear();
        added.clear();
        faces.clear();
        more = {};
    }
    bool empty() const noexcept { return removed.empty(); }

    Buffer<std::uint32_t> removed;
    Buffer<Tetrahedron> added;
    Buffer<Face> faces;
    struct More {
        std::uint32_t lost_faces = 0;          // how many faces of facets more leave than come
        std::uint32_t lost_vertex = no_index;  // the vertex that leaves the mesh, or no_index
        // The ends of the kept edge that takes the place of two at the vertex that leaves.
        std::uint32_t ends[2] = {no_index, no_index};
        double place[3] = {0, 0, 0};  // of the new vertex, if corners name it
    };
    More more;
    double before = 0, after = 0;  // the worst qualities of the tetrahedra that leave and that come
};

// Many changes. Each has a number.
class ChangeList {
  public:
    explicit ChangeList(Allocator& allocator)
        : entries_(allocator), removed_(allocator), added_(allocator), faces_(allocator) {}

    std::size_t size() const noexcept { return entries_.size(); }
    void clear() noexcept {
        entries_.clear();
        removed_.clear();
        added_.clear();
        faces_.clear();
    }
    void add(const Change& change) {
        entries_.push_back({removed_.size(), added_.size(), faces_.size(), change.more,
                            change.before, change.after});
        for (const std::uint32_t t : change.removed) removed_.push_back(t);
        for (const Change::Tetrahedron& t : change.added) added_.push_back(t);
        for (const Change::Face& f : change.faces) faces_.push_back(f);
    }
    double before(std::size_t i) const noexcept { return entries_[i].before; }
    void get(std::size_t i, Change& change) const {
        const bool is_last = i + 1 == entries_.size();
        const Entry& from = entries_[i];
        change.clear();
        const std::size_t removed_end = is_last ? removed_.size() : entries_[i + 1].removed,
                          added_end = is_last ? added_.size() : entries_[i + 1].added,
                          faces_end = is_last ? faces_.size() : entries_[i + 1].faces;
        for (std::size_t k = from.removed; k < removed_end; ++k)
            change.removed.push_back(removed_[k]);
        for (std::size_t k = from.added; k < added_end; ++k) change.added.push_back(added_[k]);
        for (std::size_t k = from.faces; k < faces_end; ++k) change.faces.push_back(faces_[k]);
        change.more = from.more;
        change.before = from.before;
        change.after = from.after;
    }

  private:
    // Where the lists of a change begin.
    struct Entry {
        std::size_t removed, added, faces;
        Change::More more;
        double before, after;
    };
    Buffer<Entry> entries_;
    Buffer<std::uint32_t> removed_;
    Buffer<Change::Tetrahedron> added_;
    Buffer<Change::Face> faces_;
};

}  // namespace mgdt
