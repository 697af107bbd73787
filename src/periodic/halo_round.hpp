// SPDX-License-Identifier: MIT
// One round of the construction of a halo: looks at tetrahedra, collects their balls and finds the
// images in the balls. docs/theory.md, "Periodic boxes", says why these are enough.
#pragma once

#include <cmath>

#include "periodic/halo.hpp"

namespace mgdt {

class Halo::Round {
  public:
    Round(Halo& halo, std::size_t most_requests, const StopRequest& stop);

    // Looks at all ghosts and tetrahedra that have points of the box as corners and whose balls
    // leave the shell, where all images are known.
    void look_at_all();
    // Of these, looks at those that also have a point with an index of at least `first`.
    void look_at_stars(std::size_t first);
    // Whether tetrahedra were not looked at, since their points had to get their basic images
    // first.
    bool is_preliminary() const { return is_preliminary_; }

    // Adds the images of a point that bound the cell of a lattice point.
    void add_basic_images(std::uint32_t point);
    // Adds the images in the balls to the halo's list.
    void find_images();

  private:
    struct Ball {
        TetId tetrahedron;
        std::uint32_t of;     // its class
        std::uint32_t point;  // a corner in the box
        double offset[3];     // of the centre from the tetrahedron's first corner
        double center[3], radius;
    };
    const BoxLattice& lattice() const { return halo_.grid_->lattice(); }
    const double* corner(TetId t, unsigned i) const {
        return halo_.point(mesh_.vertices[mesh_.tetrahedra[t].v[i]].index);
    }

    // A tetrahedron whose class is being looked at.
    struct Deferred {
        TetId tetrahedron;
        std::uint32_t of;
    };
    // The corners in the box. Returns their number.
    unsigned find_own(const Tetrahedron& tetrahedron, std::uint32_t (&own)[4]) const;
    // Looks at a ghost or at a tetrahedron whose ball leaves the shell.
    void look_at(TetId t);
    void look_at_ghost(const Tetrahedron& tetrahedron);
    // Puts the ball of a tetrahedron on the list unless its points have to get their basic images
    // first.
    bool queue(TetId t, std::uint32_t of);
    bool request_basic_images(const std::uint32_t* points, unsigned count);
    // Whether the basic images of a point were known before this round. A few points get theirs if
    // they were not; the others may not need them after that.
    bool request_basic_images(std::uint32_t point);
    // Whether the ball of a tetrahedron, which is no ghost, may leave the shell.
    bool leaves_shell(TetId t) const;
    bool leaves_shell(const double* center, double radius) const;
    static double size_of(const double* place) {
        return std::fabs(place[0]) + std::fabs(place[1]) + std::fabs(place[2]);
    }
    void set(Ball& ball) const;
    // A bound on the error of coordinate k of a centre, or of its difference from that of a point.
    double error_at(const Ball& ball, unsigned k) const {
        return error_[k] + lattice().error_of(k, size_of(ball.center));
    }
    // Whether the centre may be in the cell that the basic images leave to the point, or above that
    // cell in a slab or beside a wire. False for a centre so far away that its coordinates are
    // rough.
    bool is_above_cell(const Ball& ball) const;

    // The range of coordinates along the vectors in which images of a ball are looked for: in the
    // ball, and near enough to its centre to be the nearest image of a point.
    void range_of(const Ball& ball, double (&low)[3], double (&high)[3]) const;
    void find_in_balls();
    // Calls visit(low, high) for ranges whose union is the part of a ball's range outside of the
    // shell.
    template <class Visit>
    void each_range(const Ball& ball, const Visit& visit) const;
    // Makes the halo's candidates those that were and all points of the box with images in the
    // range of a ball, but not in the shell.
    void collect_candidates();

    // Calls visit(k, power) for the multiples by which images may be in the ball. `power` is that
    // of points of the box with respect to the ball moved back by these multiples.
    template <class Visit>
    void each_shift(const Ball& ball, const Visit& visit) const;
    // Adds the image that is deepest in the ball, if there is one. Then those that are in the ball
    // with it can wait for a later round. If there is none, adds those on the sphere. Where doubles
    // leave a power uncertain, the exact predicate decides. Returns whether the triangulation has
    // all images in the closed ball, so that the tetrahedron is right.
    bool find_in(const Ball& ball);
    int side_of(const Ball& ball, std::uint32_t point, const Multiples& k) const;

    Halo& halo_;
    const Mesh& mesh_;
    const StopRequest& stop_;
    Buffer<Ball> balls_;
    Buffer<Deferred> deferred_;
    Buffer<Image> unsure_;
    const std::size_t inserted_;  // points in the triangulation
    const std::size_t most_requests_;
    std::size_t requests_ = 0;
    double error_[3], low_[3], high_[3];
    bool is_preliminary_ = false;
};

}  // namespace mgdt
