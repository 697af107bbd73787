// SPDX-License-Identifier: MIT
// A mesh that is refined: tetrahedra, sizes, and what is known of each tetrahedron.
#pragma once

#include <cmath>

#include "refinement/element.hpp"
#include "refinement/place_sizes.hpp"
#include "refinement/walled_mesh.hpp"

namespace mgdt {

// Why a tetrahedron is not divided.
enum class Refusal : std::uint8_t {
    none,
    hidden,       // a wall is between it and the point that would divide it
    near_vertex,  // that point is too near to a vertex
    near_wall,    // that point is near a wall, and would leave as many bad tetrahedra
    shapeless,    // there is no cavity whose facets the point sees
    no_points_left
};

// Whether a tetrahedron is to be divided.
class Verdict {
  public:
    static constexpr std::uint8_t n_classes = 16;

    Verdict() noexcept : bits_(good) {}
    explicit Verdict(Refusal refusal) noexcept
        : bits_(static_cast<std::uint8_t>(refused + static_cast<unsigned>(refusal))) {}
    // The verdict on a tetrahedron with this excess. Those above 1 are bad, and those that differ
    // by less than a factor of 4 are about equally bad: then the newest one is the next, which is
    // in the cache.
    explicit Verdict(double excess) noexcept : bits_(good) {
        if (excess <= 1) return;
        int exponent = 2 * n_classes;
        if (excess < 0x1p30) static_cast<void>(std::frexp(excess, &exponent));
        bits_ = static_cast<std::uint8_t>((exponent - 1) / 2);
    }
    bool is_bad() const noexcept { return bits_ < good; }
    unsigned class_of() const noexcept { return bits_ & (n_classes - 1); }
    // How many points were refused for a bad tetrahedron: at most 3 are counted.
    unsigned tries() const noexcept { return bits_ / n_classes; }
    void count_try() noexcept { bits_ = static_cast<std::uint8_t>(bits_ + n_classes); }
    Refusal refusal() const noexcept {
        return bits_ > refused ? static_cast<Refusal>(bits_ - refused) : Refusal::none;
    }

  private:
    static constexpr std::uint8_t good = 128, refused = 128;
    std::uint8_t bits_;
};

struct RefinedMesh {
    RefinedMesh(const LinkedMesh& from, Team& team, Allocator& allocator)
        : walled(from, team, allocator),
          sizes(allocator),
          interpolated(allocator),
          spacings(allocator),
          verdicts(allocator),
          free_vertices(allocator),
          places(allocator) {}

    double mean_size(const VertexId (&v)[4]) const noexcept {
        return 0.25 * ((sizes[v[0]] + sizes[v[1]]) + (sizes[v[2]] + sizes[v[3]]));
    }
    ElementShape element(const VertexId (&v)[4]) const noexcept {
        return element_of(walled.point(v[0]), walled.point(v[1]), walled.point(v[2]),
                          walled.point(v[3]));
    }
    // By how much a tetrahedron exceeds the bounds, squared.
    double excess(const VertexId (&v)[4]) const noexcept {
        return bounds.excess(element(v), mean_size(v));
    }

    // Makes arrays as long as the mesh.
    void resize();
    // Makes sure that this many slots, and vertices, are free, and that as many slots may become
    // free.
    void reserve(std::size_t slots, std::size_t vertices);
    void find_spacings();
    void set_sizes(VertexId v, double size, double part, double spacing) noexcept {
        sizes[v] = size;
        if (!interpolated.empty()) interpolated[v] = part;
        if (!spacings.empty()) spacings[v] = spacing;
    }

    // Roughly, how many points divide a tetrahedron until its parts have the wanted sizes.
    double wanted_points(const VertexId (&v)[4]) const noexcept {
        constexpr double points_in_cube = 1.6, most = 1e15;
        const double size = mean_size(v), volume = std::max(volume_of(v), 0.0);
        const double wanted =
            points_in_cube * (volume / size / size / size) + volume / bounds.volume;
        return 1 + (wanted < most ? wanted : most);
    }
    double volume_of(const VertexId (&v)[4]) const noexcept {
        double unused;
        const double* const a = walled.point(v[0]);
        return rounded_volume(difference<double>(walled.point(v[1]), a),
                              difference<double>(walled.point(v[2]), a),
                              difference<double>(walled.point(v[3]), a), unused) /
               6;
    }

    WalledMesh walled;
    Buffer<double> sizes;  // of edges, as they are wanted at each vertex
    // Empty, or the sizes that are wanted at given vertices alone: a new vertex gets a size between
    // those of the vertices around it.
    Buffer<double> interpolated;
    // Empty, or the length of the shortest edge at each vertex of the given mesh, which grows from
    // there by half of the distance. Edges of divided walls are at least a quarter as long, unless
    // the sizes want shorter ones.
    Buffer<double> spacings;
    Buffer<Verdict> verdicts;  // for each slot
    Buffer<VertexId> free_vertices;
    PlaceSizes places;
    double gradation = 0.3;
    ElementBounds bounds;
};

// Finds the centroid of a tetrahedron without a mark.
inline void find_centroid(const Mesh& mesh, TetId t, double (&x)[3]) noexcept {
    const VertexId(&v)[4] = mesh.tetrahedra[t].v;
    for (int k = 0; k < 3; ++k)
        x[k] = 0.25 * ((mesh.point(v[0])[k] + mesh.point(v[1])[k]) +
                       (mesh.point(v[2])[k] + mesh.point(v[3])[k]));
}

// The corners of a tetrahedron that may be marked.
struct Corners4 {
    explicit Corners4(const Tetrahedron& t) noexcept
        : v{t.v[0], unmarked(t.v[1]), t.v[2], t.v[3]} {}
    VertexId v[4];
};

}  // namespace mgdt
