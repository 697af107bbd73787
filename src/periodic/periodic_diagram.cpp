// SPDX-License-Identifier: MIT
#include "periodic/periodic_diagram.hpp"

#include <algorithm>
#include <cassert>

#include "mesh/facet_turns.hpp"
#include "mesh/scale.hpp"
#include "periodic/periodic_cells.hpp"
#include "platform/hash.hpp"
#include "predicates/circumcenter.hpp"
#include "predicates/predicates.hpp"
#include "voronoi/voronoi.hpp"

namespace mgdt {
namespace {

// A vertex or a ray of the halo's diagram, translated by multiples of the basis.
struct Translated {
    std::uint32_t number;
    Multiples shift;
    friend bool operator==(const Translated& a, const Translated& b) {
        return a.number == b.number && a.shift == b.shift;
    }
};

// The numbers in the result of translated vertices, or rays. Most cells have the same shift; for
// this shift, an array has the numbers.
class TranslatedNumbers {
  public:
    TranslatedNumbers(Allocator& allocator, const Multiples& common)
        : common_(common),
          of_common_(allocator),
          table_(allocator),
          keys_(allocator),
          of_key_(allocator) {}

    void start(std::size_t count) { of_common_.resize(count, no_index); }
    // A reference to the number, which is `no_index` until it is set. The next call invalidates the
    // reference.
    std::uint32_t& operator[](const Translated& key) {
        if (key.shift == common_) return of_common_[key.number];
        table_.reserve(keys_.size() + 1);
        const std::uint32_t i =
            table_.number(hash_of(key), [&](std::uint32_t k) { return keys_[k] == key; });
        if (i == keys_.size()) {
            keys_.push_back(key);
            of_key_.push_back(no_index);
        }
        return of_key_[i];
    }

  private:
    static std::uint32_t hash_of(const Translated& key) {
        return hash_of_words(key.number, key.shift[0], key.shift[1], key.shift[2]);
    }

    const Multiples common_;
    Buffer<std::uint32_t> of_common_;
    NumberTable table_;
    Buffer<Translated> keys_;
    Buffer<std::uint32_t> of_key_;
};

// Copies the cells of the points in the box from the diagram of the points and their halo, and
// translates them to where the caller has put the points. In `from`, centroids are relative to the
// points.
class Extraction {
  public:
    Extraction(const Periodic& periodic, const VoronoiDiagram& from, const VoronoiSources& sources,
               VoronoiDiagram& to)
        : periodic_(periodic),
          halo_(periodic.halo()),
          mesh_(halo_.triangulation().mesh()),
          from_(from),
          sources_(sources),
          to_(to),
          common_(periodic.wrap_of(0)),
          order_(periodic.allocator()),
          number_of_face_(periodic.allocator()),
          vertices_(periodic.allocator(), common_),
          rays_(periodic.allocator(), common_),
          by_place_(periodic.allocator()),
          vertex_at_(periodic.allocator()),
          by_vertex_(periodic.allocator()),
          ray_from_(periodic.allocator()) {}

    void run(StageProgress& progress) {
        const auto n = static_cast<std::uint32_t>(halo_.own_count());
        to_.points.resize(3 * std::size_t{n});
        to_.is_bounded.resize(n);
        to_.volumes.resize(n);
        to_.cell_centroids.resize(3 * std::size_t{n});
        number_of_face_.resize(from_.face_count(), no_index);
        vertices_.start(from_.vertices.size() / 3);
        rays_.start(from_.ray_vertices.size());
        to_.face_begin.push_back(0);
        to_.cell_begin.push_back(0);
        for (std::uint32_t p = 0; p < n; ++p) {
            progress.step(p, 0, n);
            add_cell(p);
        }
    }

  private:
    void add_cell(std::uint32_t p) {
        point_ = p;
        shift_ = periodic_.wrap_of(p);
        periodic_.place_of(p, place_);
        periodic_.rounded(p, to_.points.begin() + 3 * std::size_t{p});
        to_.is_bounded[p] = from_.is_bounded[p];
        to_.volumes[p] = periodic_.to_callers(from_.volumes[p], 3);
        double* const centroid = to_.cell_centroids.begin() + 3 * std::size_t{p};
        if (periodic_.vertex_of(p) == p)
            write_translated(from_.cell_centroids.begin() + 3 * std::size_t{p}, centroid);
        else
            std::fill_n(centroid, 3, 0.0);
        // Sorts the faces by their neighbours, so that their order does not depend on the halo.
        order_.clear();
        for (std::uint64_t i = from_.cell_begin[p]; i < from_.cell_begin[p + std::size_t{1}]; ++i)
            order_.push_back({halo_.image(other_side(from_.cell_faces[i])), from_.cell_faces[i]});
        std::sort(order_.begin(), order_.end(),
                  [](const Neighbor& a, const Neighbor& b) { return is_before(a.image, b.image); });
        for (const Neighbor& neighbor : order_) to_.cell_faces.push_back(number_of(neighbor));
        to_.cell_begin.push_back(to_.cell_faces.size());
    }
    struct Neighbor {
        Image image;
        std::uint32_t face;
    };
    std::uint32_t other_side(std::uint32_t face) const {
        const std::uint32_t* const sides = from_.face_sides.begin() + 2 * std::size_t{face};
        return sides[0] == point_ ? sides[1] : sides[0];
    }
    // The number of a face of the cell. A face that two cells share is added with the first one.
    std::uint32_t number_of(const Neighbor& neighbor) {
        const auto number = static_cast<std::uint32_t>(to_.face_count());
        const std::uint32_t other = neighbor.image.point;
        // The two cells meet where the caller has put their points if the image of the neighbour
        // has the wrap of the neighbour's own cell.
        const bool is_shared =
            neighbor.image.multiples() + shift_ == periodic_.wrap_of(other) && other != point_;
        if (is_shared && other < point_) return shared_face(neighbor);
        if (is_shared) number_of_face_[neighbor.face] = number;
        add_face(neighbor);
        return number;
    }
    // The face that the cell shares with that of a lesser point.
    std::uint32_t shared_face(const Neighbor& neighbor) const {
        // If no translation is involved, both sides have the same face in the diagram of the halo.
        if (neighbor.image.multiples() == Multiples{}) return number_of_face_[neighbor.face];
        const std::uint32_t other = neighbor.image.point;
        const std::uint32_t* const begin = to_.cell_faces.begin() + to_.cell_begin[other];
        const std::uint32_t* const end =
            to_.cell_faces.begin() + to_.cell_begin[other + std::size_t{1}];
        const std::uint32_t* const found = std::find_if(begin, end, [&](std::uint32_t face) {
            const std::int64_t* const of = to_.face_shifts.begin() + 3 * std::size_t{face};
            return to_.face_sides[2 * std::size_t{face}] == other &&
                   to_.face_sides[2 * std::size_t{face} + 1] == point_ && of[0] == 0 &&
                   of[1] == 0 && of[2] == 0;
        });
        assert(found != end && "two cells disagree about a face");
        return *found;
    }
    void add_face(const Neighbor& neighbor) {
        const std::size_t face = neighbor.face;
        const std::uint32_t other = other_side(neighbor.face);
        to_.face_sides.push_back(point_);
        to_.face_sides.push_back(neighbor.image.point);
        for (const std::int64_t k : periodic_.shift_from(point_, neighbor.image))
            to_.face_shifts.push_back(k);
        double way[3], normal[3], centroid[3];
        for (unsigned c = 0; c < 3; ++c) way[c] = halo_.point(other)[c] - halo_.point(point_)[c];
        write_unit_vector(way, normal);
        to_.face_distances.push_back(periodic_.to_callers(length_in_range(way)));
        for (const double c : normal) to_.face_normals.push_back(c);
        to_.areas.push_back(periodic_.to_callers(from_.areas[face], 2));
        const bool is_reversed = from_.face_sides[2 * face] != point_;
        for (unsigned c = 0; c < 3; ++c)
            centroid[c] = from_.face_centroids[3 * face + c] + (is_reversed ? way[c] : 0);
        write_translated(centroid, centroid);
        for (const double c : centroid) to_.face_centroids.push_back(c);
        const std::uint32_t* const begin = from_.face_corners.begin() + from_.face_begin[face];
        const std::uint32_t* const end = from_.face_corners.begin() + from_.face_begin[face + 1];
        // The corners are in counter-clockwise order about the direction away from the point. Rays
        // come last.
        const std::uint32_t* const rays = std::find_if(begin, end, is_ray);
        if (is_reversed) {
            for (const std::uint32_t* c = rays; c != begin;) add_corner(*--c);
            for (const std::uint32_t* c = end; c != rays;) add_corner(*--c);
        } else {
            for (const std::uint32_t* c = begin; c != end; ++c) add_corner(*c);
        }
        to_.face_begin.push_back(to_.face_corners.size());
    }
    static bool is_ray(std::uint32_t corner) { return (corner & VoronoiDiagram::ray) != 0; }
    void add_corner(std::uint32_t corner) {
        to_.face_corners.push_back(is_ray(corner)
                                       ? ray(corner & ~VoronoiDiagram::ray) | VoronoiDiagram::ray
                                       : vertex(corner));
    }
    // Converts coordinates that are relative to the point to coordinates where the caller has put
    // the point.
    void write_translated(const double* x, double* to) const {
        for (unsigned c = 0; c < 3; ++c) to[c] = periodic_.to_callers(place_[c] + x[c]);
    }

    // The number in the result of a vertex of the halo's diagram that is translated as the cell.
    std::uint32_t vertex(std::uint32_t of_halo) {
        const Translated key = {of_halo, shift_};
        std::uint32_t& number = vertices_[key];
        if (number != no_index) return number;
        double x[3];
        write_vertex(of_halo, x);
        const auto next = static_cast<std::uint32_t>(to_.vertices.size() / 3);
        number = next;
        if (!periodic_.has_one_wrap()) {
            by_place_.reserve(std::size_t{next} + 1);
            number = by_place_.number(hash_of_coordinates(x), [&](std::uint32_t i) {
                return std::equal(x, x + 3, to_.vertices.begin() + 3 * std::size_t{i}) &&
                       is_same_vertex(vertex_at_[i], key);
            });
            if (number == next) vertex_at_.push_back(key);
        }
        if (number == next)
            for (const double c : x) to_.vertices.push_back(c);
        return number;
    }
    // Writes the doubles nearest to a vertex of the cell.
    void write_vertex(std::uint32_t of_halo, double (&x)[3]) const {
        double in_box[3];
        std::copy_n(from_.vertices.begin() + 3 * std::size_t{of_halo}, 3, in_box);
        if (shift_ == Multiples{} && unscale(in_box, -periodic_.exponent(), x)) return;
        // A tetrahedron that has the point as its first corner.
        std::uint32_t corners[4];
        read_corners(sources_.of_vertex[of_halo], corners);
        if (std::find(corners, corners + 4, point_) == corners + 4) replace_corner(corners);
        const auto at = std::find(corners, corners + 4, point_) - corners;
        static constexpr std::uint8_t even[4][4] = {
            {0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
        const double* p[4];
        for (unsigned i = 0; i < 4; ++i) p[i] = halo_.point(corners[even[at][i]]);
        const Circumcenter center = translated_circumcenter(p, place_, -periodic_.exponent());
        std::copy_n(center.x, 3, x);
    }
    void read_corners(TetId slot, std::uint32_t (&corners)[4]) const {
        for (unsigned i = 0; i < 4; ++i)
            corners[i] = mesh_.vertices[mesh_.tetrahedra[slot].v[i]].index;
    }
    // Replaces a corner of a tetrahedron by the point, which is on the circumsphere of the
    // tetrahedron.
    void replace_corner(std::uint32_t (&corners)[4]) const {
        for (unsigned i = 0; i < 4; ++i) {
            std::uint32_t c[4];
            std::copy_n(corners, 4, c);
            c[i] = point_;
            const int sign = orientation(halo_.point(c[0]), halo_.point(c[1]), halo_.point(c[2]),
                                         halo_.point(c[3]));
            if (sign == 0) continue;
            if (sign < 0) std::swap(c[(i + 1) % 4], c[(i + 2) % 4]);
            std::copy_n(c, 4, corners);
            return;
        }
    }
    // Writes the place of a point of the halo after a translation by b.shift - a.shift. Returns
    // false if the place is too far away to meet anything in the halo.
    bool write_point(std::uint32_t index, const Translated& a, const Translated& b,
                     double (&x)[3]) const {
        constexpr std::int64_t most = 8;  // as far as images are exact
        const Image image = halo_.image(index);
        Multiples k;
        for (unsigned c = 0; c < 3; ++c) {
            const std::int64_t of = std::int64_t{image.of[c]} + b.shift[c] - a.shift[c];
            if (of < -most || of > most) return false;
            k[c] = static_cast<std::int32_t>(of);
        }
        periodic_.grid().image(halo_.point(image.point), k, x);
        return true;
    }
    // Whether two translated vertices are at one place. The centres of two empty balls are equal if
    // and only if the balls are.
    bool is_same_vertex(const Translated& a, const Translated& b) const {
        if (a.shift == b.shift) return a.number == b.number;
        std::uint32_t of_a[4], of_b[4];
        read_corners(sources_.of_vertex[a.number], of_a);
        read_corners(sources_.of_vertex[b.number], of_b);
        return std::all_of(of_b, of_b + 4, [&](std::uint32_t index) {
            double x[3];
            return write_point(index, a, b, x) &&
                   side_of_sphere(halo_.point(of_a[0]), halo_.point(of_a[1]), halo_.point(of_a[2]),
                                  halo_.point(of_a[3]), x) == 0;
        });
    }

    // The number in the result of a ray of the halo's diagram that is translated as the cell.
    std::uint32_t ray(std::uint32_t of_halo) {
        const Translated key = {of_halo, shift_};
        if (const std::uint32_t known = rays_[key]; known != no_index) return known;
        const std::uint32_t begin = vertex(from_.ray_vertices[of_halo]);
        const auto next = static_cast<std::uint32_t>(to_.ray_vertices.size());
        std::uint32_t number = next;
        if (!periodic_.has_one_wrap()) {
            by_vertex_.reserve(std::size_t{next} + 1);
            number = by_vertex_.number(begin * 0x9E3779B1u, [&](std::uint32_t i) {
                return to_.ray_vertices[i] == begin && is_same_ray(ray_from_[i], key);
            });
            if (number == next) ray_from_.push_back(key);
        }
        if (number == next) {
            to_.ray_vertices.push_back(begin);
            for (unsigned k = 0; k < 3; ++k)
                to_.ray_directions.push_back(from_.ray_directions[3 * std::size_t{of_halo} + k]);
        }
        rays_[key] = number;
        return number;
    }
    // Whether two translated rays that start at the same vertex are equal: whether their hull
    // facets are in one plane.
    bool is_same_ray(const Translated& a, const Translated& b) const {
        if (a.shift == b.shift) return a.number == b.number;
        std::uint32_t of_a[3], of_b[3];
        read_facet(sources_.of_ray[a.number], of_a);
        read_facet(sources_.of_ray[b.number], of_b);
        const double *const u = from_.ray_directions.begin() + 3 * std::size_t{a.number},
                            *const v = from_.ray_directions.begin() + 3 * std::size_t{b.number};
        return u[0] * v[0] + u[1] * v[1] + u[2] * v[2] > 0 &&
               std::all_of(of_b, of_b + 3, [&](std::uint32_t index) {
                   double x[3];
                   return write_point(index, a, b, x) &&
                          orientation(halo_.point(of_a[0]), halo_.point(of_a[1]),
                                      halo_.point(of_a[2]), x) == 0;
               });
    }
    void read_facet(TetId ghost, std::uint32_t (&corners)[3]) const {
        const Tetrahedron& t = mesh_.tetrahedra[ghost];
        const unsigned char* const at = outer_face[t.infinite_slot()];
        for (unsigned i = 0; i < 3; ++i) corners[i] = mesh_.vertices[t.v[at[i]]].index;
    }

    const Periodic& periodic_;
    const Halo& halo_;
    const Mesh& mesh_;
    const VoronoiDiagram& from_;
    const VoronoiSources& sources_;
    VoronoiDiagram& to_;
    const Multiples common_;
    // The point of the cell that is being added, and its wrap and place.
    std::uint32_t point_ = 0;
    Multiples shift_ = {};
    double place_[3] = {};
    Buffer<Neighbor> order_;
    Buffer<std::uint32_t> number_of_face_;
    TranslatedNumbers vertices_, rays_;
    // Used where cells have different shifts: finds the vertices of the result by their
    // coordinates, and the rays by their vertices, with the translated vertex or ray that each was
    // made from.
    NumberTable by_place_;
    Buffer<Translated> vertex_at_;
    NumberTable by_vertex_;
    Buffer<Translated> ray_from_;
};

}  // namespace

void build_periodic_diagram(const Periodic& periodic, StageProgress& progress,
                            VoronoiDiagram& diagram) {
    Team team = team_of_halo(periodic);
    const MeshView view = view_of_halo(periodic, team);
    const Region region(view.allocator, 0, nullptr, view.mesh, view.base);
    // The diagram keeps its allocator, since it may outlive the box.
    Allocator& allocator = diagram.areas.allocator();
    VoronoiDiagram whole(allocator), built(allocator);
    VoronoiSources sources(view.allocator);
    StageProgress of_whole = progress.within(0, 0.7);
    build_voronoi(view, region, periodic.halo().point_count(), 0, of_whole, whole, &sources);
    progress.enter(0.7, 1);
    Extraction(periodic, whole, sources, built).run(progress);
    diagram = std::move(built);
}

}  // namespace mgdt
