// SPDX-License-Identifier: MIT
// One round of the construction of a halo: checks tetrahedra, collects the balls of those that need
// images, and finds these images. docs/theory.md, "Periodic boxes", shows why the images suffice.
#pragma once

#include <cmath>

#include "periodic/halo.hpp"
#include "periodic/image_cells.hpp"
#include "periodic/point_tree.hpp"
#include "periodic/tetrahedron_classes.hpp"

namespace mgdt {

// What the rounds of one construction share.
struct HaloSearch {
    HaloSearch(Allocator& allocator, unsigned dimensions, std::size_t points)
        : basic_round(allocator),
          candidate_cells(allocator),
          candidates(allocator),
          classes(allocator) {
        basic_round.resize(points, 0u);
        candidate_cells.make(dimensions, points);
    }

    // For each point of the box, the round, counted from 1, in which its basic images were added:
    // the images that bound the Voronoi cell of a lattice point. 0 if they were not added.
    Buffer<std::uint32_t> basic_round;
    // The points of the box that have images in the marked cells. Only their images may be needed.
    ImageCells candidate_cells;
    PointTree candidates;
    TetrahedronClasses classes;  // of tetrahedra whose balls leave the shell
};

// A round adds images to the halo and changes nothing else of it.
class Halo::Round {
  public:
    Round(Halo& halo, HaloSearch& search, std::size_t most_requests, const StopRequest& stop);

    // Checks all ghosts, and all tetrahedra that have a point of the box as a corner and whose
    // balls leave the shell. Within the shell all images are known.
    void look_at_all();
    // Checks those of them that also have a corner with an index of at least `first`.
    void look_at_stars(std::size_t first);
    // Returns true if some tetrahedra were skipped, because their corners had to get their basic
    // images first. Another round is needed then.
    bool is_preliminary() const { return is_preliminary_; }

    // Adds the basic images of a point: the images that bound the Voronoi cell of a lattice point.
    void add_basic_images(std::uint32_t point);
    // Adds the images that are in the balls to the list of images of the halo.
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

    // A tetrahedron that waits because another one of its class is being checked.
    struct Deferred {
        TetId tetrahedron;
        std::uint32_t of;
    };
    std::uint32_t class_of(const Tetrahedron& tetrahedron);
    // Writes the corners that are points of the box. Returns their number.
    unsigned find_own(const Tetrahedron& tetrahedron, std::uint32_t (&own)[4]) const;
    // Checks a ghost, or a tetrahedron whose ball leaves the shell.
    void look_at(TetId t);
    void look_at_ghost(const Tetrahedron& tetrahedron);
    // Appends the ball of a tetrahedron to the list. Returns false, and appends nothing, if its
    // corners have to get their basic images first.
    bool queue(TetId t, std::uint32_t of);
    bool request_basic_images(const std::uint32_t* points, unsigned count);
    // Returns whether the basic images of a point were known before this round. If they were not,
    // requests them, but only for few points per round: the other points may not need them any more
    // after that.
    bool request_basic_images(std::uint32_t point);
    // Whether the ball of a tetrahedron may leave the shell. The tetrahedron is no ghost.
    bool leaves_shell(TetId t) const;
    bool leaves_shell(const double* center, double radius) const;
    static double size_of(const double* place) {
        return std::fabs(place[0]) + std::fabs(place[1]) + std::fabs(place[2]);
    }
    void set(Ball& ball) const;
    // An upper bound of the error of coordinate k of the centre of a ball, and of the error of its
    // difference from the coordinate of a point.
    double error_at(const Ball& ball, unsigned k) const {
        return error_[k] + lattice().error_of(k, size_of(ball.center));
    }
    // Whether the centre of a ball may be in the cell that the basic images of the corner leave to
    // it. In a slab or a wire, the cell extends beyond the points. False for a centre that is so
    // far away that its coordinates are rough.
    bool is_above_cell(const Ball& ball) const;

    // The range of coordinates in which images of a ball are searched: the range of the ball,
    // restricted to places that are near enough to its centre to be the nearest image of a point.
    void range_of(const Ball& ball, double (&low)[3], double (&high)[3]) const;
    void find_in_balls();
    // Divides the part of the range of a ball that is outside of the shell into ranges, and calls
    // visit(low, high) for each.
    template <class Visit>
    void each_range(const Ball& ball, const Visit& visit) const;
    // Adds all points of the box that have images in the range of a ball, but not in the shell, to
    // the candidates of the halo.
    void collect_candidates();

    // Calls visit(k, power) for all multiples k by which an image may be in the ball. `power` gives
    // the power of points of the box with respect to the ball moved back by k.
    template <class Visit>
    void each_shift(const Ball& ball, const Visit& visit) const;
    // Adds the image that is deepest in the ball, if one is inside: other images in the ball can
    // wait for a later round. If none is inside, adds those on the sphere. Where rounding leaves
    // the sign of a power open, the exact predicate decides. Returns whether the triangulation has
    // all images in the closed ball, so that the tetrahedron is final.
    bool find_in(const Ball& ball);
    int side_of(const Ball& ball, std::uint32_t point, const Multiples& k) const;

    Halo& halo_;
    HaloSearch& search_;
    const Mesh& mesh_;
    const StopRequest stop_;
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
