// SPDX-License-Identifier: MIT
#include "voronoi/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dual/cell_measurer.hpp"
#include "mesh/facet_turns.hpp"
#include "mesh/scale.hpp"
#include "parallel/team_lists.hpp"
#include "platform/error.hpp"
#include "voronoi/ray.hpp"

namespace mgdt {
namespace {

constexpr std::size_t faces_per_thread = 65536, cells_per_thread = 16384;
constexpr double unbounded = std::numeric_limits<double>::infinity();

// Sets the size of an array that is about to be written, and provides its pages.
template <class T>
void set_size(Buffer<T>& array, std::size_t size) {
    array.resize(size);
    array.prefault(0, size);
}

}  // namespace

Assembly::Assembly(const MeshView& view, const Buffer<VertexId>& vertex_of, const Region& region,
                   const Circumcenters& centers, CutCorners& cut, const Objects<FoundFaces>& found,
                   VoronoiDiagram& diagram, VoronoiSources* sources)
    : view_(view),
      mesh_(view.mesh),
      vertex_of_(vertex_of),
      region_(region),
      centers_(centers),
      cut_(cut),
      found_(found),
      diagram_(diagram),
      sources_(sources),
      ends_(view.allocator),
      order_(view.allocator) {
    std::size_t end = 0;
    for (const FoundFaces& of_member : found_) {
        end += of_member.faces.size();
        ends_.push_back(end);
    }
    constexpr std::size_t most = 0x7FFFFFFFu;
    if (end > most) fail(MGDT_ERR_TOO_LARGE, "%zu faces are more than can be numbered", end);
}

// Items number the faces of all members: those of member 0 first, then those of member 1, and so
// on.
const FoundFaces& Assembly::member_of(std::size_t& item) const noexcept {
    std::size_t m = 0;
    while (item >= ends_[m]) ++m;
    if (m > 0) item -= ends_[m - 1];
    return found_[m];
}

void Assembly::prefetch_face(std::size_t item) const noexcept {
    const FoundFaces& from = member_of(item);
    const char* const bytes = reinterpret_cast<const char*>(&from.faces[item]);
    prefetch(bytes);
    prefetch(bytes + 64);
}
void Assembly::prefetch_corners(std::size_t item) const noexcept {
    const FoundFaces& from = member_of(item);
    prefetch(from.corners.begin() + from.faces[item].begin());
}

// Sorts the faces by their sides. Planes come after points.
void Assembly::sort_faces() {
    const std::size_t points = vertex_of_.size();
    Buffer<std::uint32_t> ends(view_.allocator, points + 1);
    struct Item {
        std::uint32_t side, item, size;
    };
    Buffer<Item> items(view_.allocator);
    const auto each = [&](std::size_t begin, std::size_t end, auto f) {
        while (begin < end) {
            std::size_t first = begin;
            const FoundFaces& from = member_of(first);
            const std::size_t n = std::min(end - begin, from.faces.size() - first);
            for (std::size_t i = 0; i < n; ++i) {
                const FoundFace& face = from.faces[first + i];
                f(face.sides[0], Item{face.sides[1], static_cast<std::uint32_t>(begin + i),
                                      static_cast<std::uint32_t>(face.size())});
            }
            begin += n;
        }
    };
    make_lists(
        view_.team, view_.allocator, ends_.back(), faces_per_thread, points, ends.data(), each,
        [&](std::size_t size) { set_size(items, size); },
        [&](std::size_t position, const Item& item) { items[position] = item; });
    view_.team.split(points, cells_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t k = begin; k < end; ++k)
            std::sort(items.begin() + ends[k], items.begin() + ends[k + 1],
                      [](const Item& a, const Item& b) { return a.side < b.side; });
    });
    set_size(order_, items.size());
    set_size(diagram_.face_begin, items.size() + 1);
    diagram_.face_begin[0] = 0;
    for (std::size_t f = 0; f < items.size(); ++f) {
        order_[f] = items[f].item;
        diagram_.face_begin[f + 1] = diagram_.face_begin[f] + items[f].size;
    }
    copy_faces();
}

// Copies the faces in their order.
void Assembly::copy_faces() {
    VoronoiDiagram& d = diagram_;
    const std::size_t faces = order_.size();
    set_size(d.face_sides, 2 * faces);
    set_size(d.areas, faces);
    set_size(d.face_centroids, 3 * faces);
    set_size(d.face_corners, static_cast<std::size_t>(d.face_begin[faces]));
    const int scale = mesh_.scale;
    constexpr std::size_t ahead = 16;
    view_.team.split(faces, faces_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t f = begin; f < end; ++f) {
            if (f + 2 * ahead < end) prefetch_face(order_[f + 2 * ahead]);
            if (f + ahead < end) prefetch_corners(order_[f + ahead]);
            std::size_t i = order_[f];
            const FoundFaces& from = member_of(i);
            const FoundFace& face = from.faces[i];
            d.face_sides[2 * f] = face.sides[0];
            const std::uint32_t other = face.sides[1];
            d.face_sides[2 * f + 1] =
                !is_plane(other)
                    ? other
                    : VoronoiDiagram::plane | region_.given(other & ~VoronoiDiagram::plane);
            d.areas[f] = face.area;
            const double* const a = mesh_.point(vertex_of_[face.sides[0]]);
            for (int k = 0; k < 3; ++k)
                d.face_centroids[3 * f + static_cast<std::size_t>(k)] =
                    sources_ == nullptr ? scaled(a[k], -scale) + face.centroid.x[k]
                                        : face.centroid.x[k];
            std::copy_n(from.corners.begin() + face.begin(), face.size(),
                        d.face_corners.begin() + d.face_begin[f]);
        }
    });
}

// Numbers vertices and rays in the order in which faces name them.
void Assembly::number_corners() {
    Buffer<std::uint32_t> of_slot(view_.allocator), of_cut(view_.allocator),
        corner_of(view_.allocator);
    of_slot.resize(mesh_.tetrahedra.size(), no_index);
    of_cut.resize(cut_.size(), no_index);
    Buffer<std::uint32_t>& corners = diagram_.face_corners;
    const auto number_of = [&](std::uint32_t& number, std::uint32_t corner) {
        if (number == no_index) {
            number = static_cast<std::uint32_t>(corner_of.size());
            corner_of.push_back(corner);
        }
        return number;
    };
    constexpr std::size_t ahead = 16;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i + ahead < corners.size())
            if (const std::uint32_t next = corners[i + ahead]; next < cut_corner)
                prefetch(&of_slot[next]);
        const std::uint32_t corner = corners[i];
        if ((corner & cut_corner) != 0) {
            corners[i] = number_of(of_cut[corner & ~cut_corner], corner);
        } else if ((corner & ghost_corner) != 0) {
            const TetId slot = corner & ~ghost_corner;
            const Tetrahedron& ghost = mesh_.tetrahedra[slot];
            const TetId inner = tetrahedron_of(ghost.n[ghost.infinite_slot()]);
            std::uint32_t& number = of_slot[centers_.first_equal(slot)];
            if (number == no_index) number = add_ray(slot, of_slot[centers_.first_equal(inner)]);
            corners[i] = number | VoronoiDiagram::ray;
        } else {
            corners[i] = number_of(of_slot[corner], corner);
        }
    }
    set_vertices(corner_of);
    if (sources_ != nullptr) sources_->of_vertex = std::move(corner_of);
}

// Writes a circumcentre without the mesh's scale, rounded to the nearest doubles.
void Assembly::write_circumcenter(TetId t, double* out) const {
    double x[3];
    if (unscale(centers_[t].x, mesh_.scale, x)) {
        std::copy_n(x, 3, out);
        return;
    }
    const VertexId(&v)[4] = mesh_.tetrahedra[t].v;
    const Circumcenter center = circumcenter(
        {mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3])}, mesh_.scale);
    std::copy_n(center.x, 3, out);
}

void Assembly::set_vertices(const Buffer<std::uint32_t>& corner_of) {
    Buffer<double>& vertices = diagram_.vertices;
    set_size(vertices, 3 * corner_of.size());
    constexpr std::size_t ahead = 16, vertices_per_thread = 65536;
    view_.team.split(
        corner_of.size(), vertices_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t i = begin; i < end; ++i) {
                if (i + ahead < end)
                    if (const std::uint32_t next = corner_of[i + ahead]; next < cut_corner)
                        centers_.prefetch(next);
                const std::uint32_t corner = corner_of[i];
                if (corner < cut_corner) write_circumcenter(corner, vertices.begin() + 3 * i);
            }
        });
    // One thread writes the corners at the region, since they share the memory of exact numbers.
    if (cut_.size() == 0) return;
    for (std::size_t i = 0; i < corner_of.size(); ++i) {
        if (corner_of[i] < cut_corner) continue;
        double x[3];
        cut_.unscaled(corner_of[i], x);
        std::copy_n(x, 3, vertices.begin() + 3 * i);
    }
}

// Marks the cells without rays as bounded. The rays of a face are its last corners.
void Assembly::find_bounded_cells() {
    VoronoiDiagram& d = diagram_;
    d.is_bounded.resize(vertex_of_.size());
    for (std::size_t cell = 0; cell < vertex_of_.size(); ++cell)
        d.is_bounded[cell] = vertex_of_[cell] != infinite_vertex ? 1 : 0;
    for (std::size_t f = 0; f < order_.size(); ++f) {
        if ((d.face_corners[d.face_begin[f + 1] - 1] & VoronoiDiagram::ray) == 0) continue;
        for (const std::size_t side : {2 * f, 2 * f + 1})
            if (!is_plane(d.face_sides[side])) d.is_bounded[d.face_sides[side]] = 0;
    }
}

// Adds the ray from a vertex that leaves the hull through the facet of a ghost.
std::uint32_t Assembly::add_ray(TetId slot, std::uint32_t vertex) {
    const Tetrahedron& ghost = mesh_.tetrahedra[slot];
    const auto number = static_cast<std::uint32_t>(diagram_.ray_vertices.size());
    // The vertices of the facet in an order that depends on the points alone.
    const unsigned char* const at = outer_face[ghost.infinite_slot()];
    VertexId v[3] = {ghost.v[at[0]], ghost.v[at[1]], ghost.v[at[2]]};
    const auto least = std::min_element(v, v + 3, [&](VertexId a, VertexId b) {
        return mesh_.vertices[a].index < mesh_.vertices[b].index;
    });
    turn_to(v, static_cast<int>(least - v));
    double direction[3];
    unit_normal(view_.allocator, mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]),
                direction);
    diagram_.ray_vertices.push_back(vertex);
    if (sources_ != nullptr) sources_->of_ray.push_back(slot);
    for (const double of : direction) diagram_.ray_directions.push_back(of);
    return number;
}

// Lists the faces of each cell, in their order.
void Assembly::list_cells() {
    VoronoiDiagram& d = diagram_;
    const std::size_t points = vertex_of_.size();
    d.cell_begin.resize(points + 1);
    make_lists(
        view_.team, view_.allocator, order_.size(), faces_per_thread, points, d.cell_begin.data(),
        [&](std::size_t begin, std::size_t end, auto f) {
            for (std::size_t face = begin; face < end; ++face)
                for (const std::size_t side : {2 * face, 2 * face + 1})
                    if (!is_plane(d.face_sides[side]))
                        f(d.face_sides[side], static_cast<std::uint32_t>(face));
        },
        [&](std::size_t size) { d.cell_faces.resize(size); },
        [&](std::size_t position, std::uint32_t face) { d.cell_faces[position] = face; });
}

void Assembly::prefetch_faces(std::size_t cell) const noexcept {
    const VoronoiDiagram& d = diagram_;
    for (std::uint64_t i = d.cell_begin[cell]; i < d.cell_begin[cell + 1]; ++i) {
        prefetch(&order_[d.cell_faces[i]]);
        prefetch(&d.face_sides[2 * std::size_t{d.cell_faces[i]}]);
    }
}

// Adds the pyramids between a vertex and its faces. Returns false if the errors are too large.
bool Assembly::measure_cell(std::size_t cell, double& volume, double* centroid) const {
    constexpr double u = rounding_of<double>;
    const VoronoiDiagram& d = diagram_;
    const double* const at = mesh_.point(vertex_of_[cell]);
    double sum = 0, magnitudes = 0, error = 0, extent = 0, moment_error = 0;
    Vector<double> moment = {};
    const auto count = static_cast<double>(d.cell_begin[cell + 1] - d.cell_begin[cell]);
    for (std::uint64_t i = d.cell_begin[cell]; i < d.cell_begin[cell + 1]; ++i) {
        const std::uint32_t face = d.cell_faces[i];
        std::size_t item = order_[face];
        const FoundFace& pyramid = member_of(item).faces[item];
        Vector<double> base = pyramid.centroid;
        if (mesh_.scale != 0)
            for (double& x : base.x) x = scaled(x, mesh_.scale);
        double base_error = pyramid.centroid_error;
        if (d.face_sides[2 * face] != cell) {
            // The base is relative to the other point.
            const Vector<double> way =
                difference<double>(mesh_.point(vertex_of_[d.face_sides[2 * face]]), at);
            base = base + way;
            base_error += 4 * u * length(way);
        }
        const double distance = length(base);
        sum += pyramid.volume;
        magnitudes += std::fabs(pyramid.volume);
        error += pyramid.volume_error;
        moment = moment + pyramid.volume * base;
        moment_error += std::fabs(pyramid.volume) * (base_error + (count + 8) * u * distance) +
                        pyramid.volume_error * (distance + base_error);
        extent = std::max(extent, distance);
    }
    error += (count + 4) * u * magnitudes;
    // Products in this range have lost no digits by underflow.
    constexpr double least = 0x1p-900, most = 0x1p900;
    if (!(sum > least && sum < most && error <= 0.5 * measure_error * sum &&
          moment_error + extent * error <= 0.5 * measure_error * extent * sum))
        return false;
    volume = std::ldexp(sum / 3, -3 * mesh_.scale);
    for (int k = 0; k < 3; ++k) {
        const double offset = 0.75 * (moment.x[k] / sum);
        centroid[k] = scaled(sources_ == nullptr ? at[k] + offset : offset, -mesh_.scale);
    }
    return true;
}

// Vertices with near numbers mostly have near points, so their cells share faces that are in the
// cache.
void Assembly::measure_cells(AtomicArray<TetId>& first, const VertexIndices& indices,
                             std::size_t measured, StageProgress& progress) {
    VoronoiDiagram& d = diagram_;
    const std::size_t points = vertex_of_.size(), vertices = mesh_.vertices.size();
    d.volumes.resize(points, 0.0);
    d.cell_centroids.resize(3 * points, 0.0);
    view_.team.split(
        vertices, cells_per_thread, [&](std::size_t begin, std::size_t end, unsigned member) {
            CellMeasurer measurer(view_.allocator);
            constexpr VertexId ahead = 4;
            for (auto v = static_cast<VertexId>(std::max<std::size_t>(begin, 1)); v < end; ++v) {
                progress.step(v, begin, end, member);
                if (v + 2 * ahead < end) {
                    const std::size_t cell = indices[v + 2 * ahead];
                    // The last cells may have no faces, so there may be no such item.
                    prefetch(d.cell_faces.begin() + d.cell_begin[cell]);
                }
                if (v + ahead < end) prefetch_faces(indices[v + ahead]);
                const std::size_t cell = indices[v];
                if (cell >= measured) continue;
                double* const centroid = d.cell_centroids.begin() + 3 * cell;
                if (d.is_bounded[cell] == 0) {
                    d.volumes[cell] = unbounded;
                    std::fill_n(centroid, 3, unbounded);
                    continue;
                }
                if (measure_cell(cell, d.volumes[cell], centroid)) continue;
                const TetId of_cell = first[v].load(std::memory_order_relaxed);
                measurer.measure(mesh_, v, of_cell, region_, Measure::volume, &d.volumes[cell]);
                measurer.measure(mesh_, v, of_cell, region_,
                                 sources_ == nullptr ? Measure::centroid : Measure::centroid_offset,
                                 centroid);
            }
        });
}

}  // namespace mgdt
