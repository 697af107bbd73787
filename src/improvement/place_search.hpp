// SPDX-License-Identifier: MIT
// Finds a place for a vertex where the worst tetrahedron at it is better.
#pragma once

#include "improvement/quality.hpp"
#include "improvement/vertex_class.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// How a vertex moves.
struct Moves {
    int most;       // the largest number of moves
    double enough;  // the worst quality at which the vertex stops
    double goal;    // below which tetrahedra are to be as few as possible
    bool push;      // whether moves may increase what qualities miss to the goal, all together
};

class PlaceSearch {
  public:
    explicit PlaceSearch(Allocator& allocator) : faces_(allocator), next_(allocator) {}

    // The faces opposite the vertex in its tetrahedra: with the vertex as a, abcd is positive.
    void clear() noexcept { faces_.clear(); }
    void add(const double* b, const double* c, const double* d, double quality = 0) {
        faces_.push_back({{b, c, d}, quality});
    }
    // Computes the qualities of the tetrahedra with the vertex at a place.
    void evaluate(const double (&place)[3]) noexcept;
    double quality(std::size_t face) const noexcept { return faces_[face].quality; }
    double worst() const noexcept;
    // Moves the vertex as its class allows, each time so that the worst tetrahedron becomes better.
    // The qualities are those at the place, before and afterwards. Returns whether the vertex has
    // moved.
    bool improve(const VertexClass& freedom, const Moves& moves, double (&place)[3]);
    // Moves the vertex towards the middle of the faces, if that makes the mean of the tetrahedra
    // better, and none of them worse than the goal or the worst one now. Returns whether the vertex
    // has moved.
    bool improve_mean(const VertexClass& freedom, double goal, double (&place)[3]);

  private:
    struct Face {
        const double* p[3];
        double quality;
    };
    // One of the worst tetrahedra, and how its quality changes with the place.
    struct Worst {
        double quality;
        double by[3];
        std::uint32_t face;
    };
    static constexpr unsigned most_worst = 16;

    double mean_at(const double (&place)[3]) const;
    void find_worst();
    void find_direction(unsigned active, double (&d)[3]) const;

    Buffer<Face> faces_;
    Buffer<double> next_;  // qualities at the place that is tried
    Worst worst_[most_worst];
    unsigned worst_count_ = 0;
};

}  // namespace mgdt
