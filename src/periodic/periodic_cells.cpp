// SPDX-License-Identifier: MIT
#include "periodic/periodic_cells.hpp"

#include <algorithm>

#include "voronoi/voronoi.hpp"

namespace mgdt {
namespace {

ExportView view_of(const Periodic& periodic, Team& team) {
    return {team, periodic.halo().triangulation().mesh(), nullptr, periodic.allocator(), 0, false};
}

Team team_of(const Periodic& periodic) {
    constexpr std::size_t vertices_per_thread = 4096;
    const Triangulation& t = periodic.halo().triangulation();
    return Team(t.threads_for(t.vertex_count(), vertices_per_thread));
}

// A length, an area or a volume.
double in_callers_unit(const Periodic& periodic, double x, unsigned powers) {
    for (unsigned i = 0; i < powers; ++i) x = periodic.to_callers(x);
    return x;
}

// Takes the cells of the points in the box out of the diagram of them and their halo, and moves
// them to where the caller has put the points.
class Extraction {
  public:
    Extraction(const Periodic& periodic, const VoronoiDiagram& from, VoronoiDiagram& to)
        : periodic_(periodic),
          halo_(periodic.halo()),
          from_(from),
          to_(to),
          order_(periodic.allocator()),
          number_of_face_(periodic.allocator()),
          vertices_(periodic.allocator()),
          vertex_keys_(periodic.allocator()),
          rays_(periodic.allocator()),
          ray_keys_(periodic.allocator()) {}

    void run(const StopRequest& stop) {
        const std::size_t n = halo_.own_count();
        to_.points.resize(3 * n);
        to_.is_bounded.resize(n);
        to_.volumes.resize(n);
        to_.cell_centroids.resize(3 * n);
        number_of_face_.resize(from_.face_count(), none);
        to_.face_begin.push_back(0);
        to_.cell_begin.push_back(0);
        for (std::uint32_t p = 0; p < n; ++p) {
            stop.poll_in_step(p);
            add_cell(p);
        }
    }

  private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    // A vertex or a ray, and the cell's shift with which it appears.
    struct Key {
        std::uint32_t number;
        Multiples shift;
        friend bool operator==(const Key& a, const Key& b) {
            return a.number == b.number && a.shift == b.shift;
        }
    };
    static std::uint32_t hash_of(const Key& key) {
        std::uint64_t h = key.number * 0x9E3779B97F4A7C15u;
        for (const std::int32_t k : key.shift)
            h = (h ^ static_cast<std::uint32_t>(k)) * 0xBF58476D1CE4E5B9u;
        return static_cast<std::uint32_t>(h >> 32);
    }
    // The number of a key in a table; `is_new` says whether it got its number now.
    static std::uint32_t number_of(const Key& key, NumberTable& table, Buffer<Key>& keys,
                                   bool& is_new) {
        table.reserve(keys.size() + 1);
        const std::uint32_t number =
            table.number(hash_of(key), [&](std::uint32_t i) { return keys[i] == key; });
        is_new = number == keys.size();
        if (is_new) keys.push_back(key);
        return number;
    }

    void add_cell(std::uint32_t p) {
        shift_ = periodic_.shift_of(p);
        periodic_.step_of(p, step_);
        double x[3];
        periodic_.rounded(p, x);
        std::copy_n(x, 3, to_.points.begin() + 3 * std::size_t{p});
        to_.is_bounded[p] = from_.is_bounded[p];
        to_.volumes[p] = in_callers_unit(periodic_, from_.volumes[p], 3);
        moved(from_.cell_centroids.begin() + 3 * std::size_t{p},
              to_.cell_centroids.begin() + 3 * std::size_t{p});
        // Faces in the order of the neighbours, which does not depend on the halo.
        order_.clear();
        for (std::uint64_t i = from_.cell_begin[p]; i < from_.cell_begin[p + std::size_t{1}]; ++i)
            order_.push_back(from_.cell_faces[i]);
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t f, std::uint32_t g) {
            const Image a = halo_.image(other_side(f, p)), b = halo_.image(other_side(g, p));
            return a.point != b.point ? a.point < b.point : a.multiples() < b.multiples();
        });
        for (const std::uint32_t face : order_) to_.cell_faces.push_back(number_of(face, p));
        to_.cell_begin.push_back(to_.cell_faces.size());
    }
    std::uint32_t other_side(std::uint32_t face, std::uint32_t p) const {
        const std::uint32_t* const sides = from_.face_sides.begin() + 2 * std::size_t{face};
        return sides[0] == p ? sides[1] : sides[0];
    }
    // The number of a face of the cell of p. A face that two cells share is added once.
    std::uint32_t number_of(std::uint32_t face, std::uint32_t p) {
        const std::uint32_t other = other_side(face, p);
        const bool is_shared = halo_.is_own(other) && periodic_.shift_of(other) == shift_;
        if (is_shared && number_of_face_[face] != none) return number_of_face_[face];
        const auto number = static_cast<std::uint32_t>(to_.face_count());
        if (is_shared) number_of_face_[face] = number;
        add_face(face, p, other);
        return number;
    }
    void add_face(std::uint32_t face, std::uint32_t p, std::uint32_t other) {
        const Image image = halo_.image(other);
        to_.face_sides.push_back(p);
        to_.face_sides.push_back(image.point);
        for (const std::int64_t k : periodic_.offset_from(p, image)) to_.face_images.push_back(k);
        double way[3], normal[3];
        for (unsigned c = 0; c < 3; ++c) way[c] = halo_.point(other)[c] - halo_.point(p)[c];
        write_unit_vector(way, normal);
        for (const double c : normal) to_.face_normals.push_back(c);
        to_.areas.push_back(in_callers_unit(periodic_, from_.areas[face], 2));
        double centroid[3];
        moved(from_.face_centroids.begin() + 3 * std::size_t{face}, centroid);
        for (const double c : centroid) to_.face_centroids.push_back(c);
        const std::uint32_t* const begin = from_.face_corners.begin() + from_.face_begin[face];
        const std::uint32_t* const end =
            from_.face_corners.begin() + from_.face_begin[face + std::size_t{1}];
        // Corners turn about the direction away from p. Rays come last.
        const bool is_reversed = from_.face_sides[2 * std::size_t{face}] != p;
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
        if (!is_ray(corner)) return to_.face_corners.push_back(vertex(corner));
        const std::uint32_t ray = corner & ~VoronoiDiagram::ray;
        bool is_new;
        const std::uint32_t number = number_of(Key{ray, shift_}, rays_, ray_keys_, is_new);
        if (is_new) {
            to_.ray_vertices.push_back(vertex(from_.ray_vertices[ray]));
            for (unsigned k = 0; k < 3; ++k)
                to_.ray_directions.push_back(from_.ray_directions[3 * std::size_t{ray} + k]);
        }
        to_.face_corners.push_back(number | VoronoiDiagram::ray);
    }
    std::uint32_t vertex(std::uint32_t of_halo) {
        bool is_new;
        const std::uint32_t number =
            number_of(Key{of_halo, shift_}, vertices_, vertex_keys_, is_new);
        if (is_new) {
            double x[3];
            moved(from_.vertices.begin() + 3 * std::size_t{of_halo}, x);
            for (const double c : x) to_.vertices.push_back(c);
        }
        return number;
    }
    // A place of the box, moved as the cell is, for the caller.
    void moved(const double* x, double* to) const {
        for (unsigned c = 0; c < 3; ++c) to[c] = periodic_.to_callers(x[c] + step_[c]);
    }

    const Periodic& periodic_;
    const Halo& halo_;
    const VoronoiDiagram& from_;
    VoronoiDiagram& to_;
    Multiples shift_ = {};
    double step_[3] = {};
    Buffer<std::uint32_t> order_, number_of_face_;
    NumberTable vertices_;
    Buffer<Key> vertex_keys_;
    NumberTable rays_;
    Buffer<Key> ray_keys_;
};

}  // namespace

void export_periodic_measures(const Periodic& periodic, Measure measure, double* out) {
    const Halo& halo = periodic.halo();
    const std::size_t width = measure == Measure::centroid ? 3 : 1;
    Team team = team_of(periodic);
    const ExportView view = view_of(periodic, team);
    const Region region(view.allocator, 0, nullptr, view.mesh, view.base);
    Buffer<double> all(view.allocator, width * halo.point_count());
    export_measures(view, region, measure, halo.point_count(), all.begin());
    const unsigned powers = measure == Measure::volume     ? 3
                            : measure == Measure::area     ? 2
                            : measure == Measure::centroid ? 1
                                                           : 0;
    for (std::uint32_t p = 0; p < halo.own_count(); ++p)
        for (std::size_t c = 0; c < width; ++c) {
            double x = all[width * p + c];
            if (measure == Measure::centroid)
                x = periodic.vertex_of(p) == p ? x - halo.point(p)[c] : 0;
            out[width * p + c] = in_callers_unit(periodic, x, powers);
        }
}

void build_periodic_diagram(const Periodic& periodic, const StopRequest& stop,
                            VoronoiDiagram& diagram) {
    Team team = team_of(periodic);
    const ExportView view = view_of(periodic, team);
    const Region region(view.allocator, 0, nullptr, view.mesh, view.base);
    // The diagram keeps its allocator, since it may outlive the box.
    Allocator& allocator = diagram.areas.allocator();
    VoronoiDiagram whole(allocator), built(allocator);
    build_voronoi(view, region, periodic.halo().point_count(), stop, whole);
    Extraction(periodic, whole, built).run(stop);
    diagram = std::move(built);
}

}  // namespace mgdt
