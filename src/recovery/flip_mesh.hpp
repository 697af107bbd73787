// SPDX-License-Identifier: MIT
// A mesh whose tetrahedra are replaced a few at a time. What was done can be undone.
#pragma once

#include "solid/linked_tetrahedra.hpp"

namespace mgdt {

class FlipMesh : public LinkedTetrahedra {
  public:
    struct Corners {
        std::uint32_t v[4];  // positively oriented
    };

    // The points may grow while the mesh exists.
    FlipMesh(Buffer<double>& points, Allocator& allocator)
        : LinkedTetrahedra(allocator),
          points_(points),
          journal_(allocator),
          slots_(allocator),
          faces_(allocator),
          links_(allocator),
          table_(allocator),
          leaves_(allocator),
          removed_(allocator),
          added_(allocator) {}

    const double* point(std::uint32_t v) const noexcept {
        return points_.begin() + 3 * std::size_t{v};
    }
    Buffer<double>& points() noexcept { return points_; }
    std::size_t point_count() const noexcept { return points_.size() / 3; }
    // Adds a point. It has no tetrahedron yet.
    std::uint32_t add_point(const double (&x)[3]);
    // Moves a point that has no tetrahedron yet.
    void move_point(std::uint32_t v, const double (&x)[3]) noexcept {
        for (unsigned k = 0; k < 3; ++k) points_[3 * std::size_t{v} + k] = x[k];
    }

    bool is_positive(const Corners& t) const noexcept;
    // Whether the tetrahedra of a list from element `first` on are positive.
    bool are_positive(const Buffer<Corners>& list, std::size_t first = 0) const noexcept;
    // Lists the tetrahedra at a vertex.
    void collect_star(std::uint32_t v, Buffer<std::uint32_t>& star);

    // Replaces tetrahedra by others that fill the same place. Returns false, and changes nothing,
    // if the others have different outer faces, or if two are on the same side of a face.
    bool replace(const Buffer<std::uint32_t>& removed, const Buffer<Corners>& added);

    // Adds a point that is inside of a tetrahedron, and divides this into four. Returns the point,
    // or no_index if it is not inside.
    std::uint32_t split(std::uint32_t t, const double (&x)[3]);

    // A tetrahedron at vertex a in which the direction to another vertex b runs, or on whose
    // boundary it runs. If a and b are the ends of an edge, the tetrahedron has both.
    std::uint32_t tetrahedron_towards(std::uint32_t a, std::uint32_t b);

    // The state of the mesh, to which undo() returns. It is valid until forget().
    std::size_t state() const noexcept { return journal_.size(); }
    // Takes back all replacements since a state, and the points that were added.
    void undo(std::size_t state) noexcept;
    // States before this call cannot be returned to.
    void forget() noexcept { journal_.clear(); }

  private:
    // What a step has changed: a tetrahedron that was different before, a slot that came from the
    // list of free ones, one that went there, or one at the end of the array; or a new point.
    enum class Step : std::uint32_t { write, take, give, append, add_point };
    struct Entry {
        Step step;
        std::uint32_t slot;
        Tetrahedron before;
    };
    struct Face {
        std::uint32_t v[3];  // ascending
        // The face behind an outer face, or the number of the new tetrahedron times 4, plus that of
        // the face.
        std::uint32_t code;
        bool is_odd;  // the side of the tetrahedron; that of what is behind, for an outer face
        bool is_paired;
    };

    void note(Step step, std::uint32_t slot) {
        journal_.grow(journal_.size() + 1);
        journal_.push_back(
            {step, slot, slot < tetrahedra.size() ? tetrahedra[slot] : Tetrahedron{}});
    }
    bool pair_faces(const Buffer<std::uint32_t>& removed, const Buffer<Corners>& added);
    bool contains_direction(std::uint32_t t, std::uint32_t a, std::uint32_t b,
                            std::uint32_t& next) const noexcept;
    std::uint32_t new_slot();
    static Face make_face(const std::uint32_t (&v)[4], unsigned position) noexcept;
    std::uint32_t& place_of(const Face& face) noexcept;

    Buffer<double>& points_;
    Buffer<Entry> journal_;
    Buffer<std::uint32_t> slots_;
    Buffer<Face> faces_;           // outer faces of what leaves, then faces of new tetrahedra
    Buffer<std::uint32_t> links_;  // for each face of a new tetrahedron, the earlier equal face
    std::size_t outer_faces_ = 0;
    Buffer<std::uint32_t> table_;    // a hash table of the faces: their numbers plus 1, or 0
    Buffer<std::uint8_t> leaves_;    // marks the tetrahedra that leave
    Buffer<std::uint32_t> removed_;  // those of split()
    Buffer<Corners> added_;
};

}  // namespace mgdt
