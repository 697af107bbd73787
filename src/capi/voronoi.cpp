// SPDX-License-Identifier: MIT
// Creation of a Voronoi diagram, and its arrays.
#include "capi/cell_view.hpp"
#include "capi/voronoi_handle.hpp"

using namespace mgdt;

namespace {

constexpr std::size_t voronoi_size = sizeof(mgdt_voronoi), voronoi_align = alignof(mgdt_voronoi);

MGDT_NOT_INLINE void destroy(mgdt_voronoi* v) noexcept {
    const FpEnvironment environment;
    free_voronoi(v);
}

void build(const mgdt_triangulation* t, std::int64_t n_planes, const double* planes,
           VoronoiDiagram& diagram) {
    const std::size_t n = require_planes(n_planes, planes);
    const auto points = static_cast<std::size_t>(point_count(t->core));
    if (t->core.vertex_count() > 0) {
        with_cell_view(t, diagram.areas.allocator(), n, planes,
                       [&](const ExportView& view, const Region& region, std::size_t far) {
                           const Progress::Call call = t->core.call_to_cancel();
                           build_voronoi(view, region, points, far, t->core.stop_request(),
                                         diagram);
                       });
    } else {
        make_empty(points, diagram);
    }
    diagram.planes.resize(4 * n);
    std::copy_n(planes, 4 * n, diagram.planes.begin());
}

// Whether an array has integers, for mgdt_voronoi_get_array(), and no doubles.
bool has_integers(std::int32_t array) {
    return array < MGDT_VORONOI_VERTICES;
}

std::size_t size_of(const VoronoiDiagram& d, std::int32_t array) {
    switch (array) {
        case MGDT_VORONOI_FACE_OFFSETS:
            return d.face_begin.size();
        case MGDT_VORONOI_FACE_CORNERS:
            return d.face_corners.size();
        case MGDT_VORONOI_FACE_SIDES:
            return d.face_sides.size();
        case MGDT_VORONOI_FACE_IMAGES:
            return d.face_images.size();
        case MGDT_VORONOI_RAY_VERTICES:
            return d.ray_vertices.size();
        case MGDT_VORONOI_CELL_OFFSETS:
            return d.cell_begin.size();
        case MGDT_VORONOI_CELL_FACES:
        case MGDT_VORONOI_CELL_NEIGHBORS:
        case MGDT_VORONOI_CELL_FACE_AREAS:
        case MGDT_VORONOI_CELL_NEIGHBOR_DISTANCES:
            return d.cell_faces.size();
        case MGDT_VORONOI_CELL_NEIGHBOR_IMAGES:
            return d.face_images.empty() ? 0 : 3 * d.cell_faces.size();
        case MGDT_VORONOI_CELL_BOUNDED:
            return d.is_bounded.size();
        case MGDT_VORONOI_VERTICES:
            return d.vertices.size();
        case MGDT_VORONOI_RAY_DIRECTIONS:
            return d.ray_directions.size();
        case MGDT_VORONOI_FACE_AREAS:
            return d.areas.size();
        case MGDT_VORONOI_FACE_NORMALS:
        case MGDT_VORONOI_FACE_CENTROIDS:
            return d.face_centroids.size();
        case MGDT_VORONOI_CELL_VOLUMES:
            return d.volumes.size();
        case MGDT_VORONOI_CELL_CENTROIDS:
            return d.cell_centroids.size();
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no array %d", static_cast<int>(array));
    }
}

template <class Int>
void write(const mgdt_voronoi& v, std::int32_t array, Int* out) {
    const VoronoiDiagram& d = v.diagram;
    const std::int64_t base = v.index_base;
    const auto numbers = [&](const auto& from) {
        for (std::size_t i = 0; i < from.size(); ++i)
            out[i] = static_cast<Int>(static_cast<std::int64_t>(from[i]) + base);
    };
    // Rays and planes, which have a flag, become -1, -2, ...
    constexpr std::uint32_t flag = VoronoiDiagram::ray;
    static_assert(flag == VoronoiDiagram::plane);
    const auto unflagged = [&](std::uint32_t x) {
        return static_cast<Int>((x & flag) != 0 ? -1 - static_cast<std::int64_t>(x & ~flag)
                                                : static_cast<std::int64_t>(x) + base);
    };
    const auto flagged = [&](const Buffer<std::uint32_t>& from) {
        for (std::size_t i = 0; i < from.size(); ++i) out[i] = unflagged(from[i]);
    };
    // Calls f(face, side) for each face of each cell, where `side`, 0 or 1, is that of the cell.
    // The same point may be on both sides, as different images: the first side is the cell's then.
    const auto each_face_of_cell = [&](const auto& f) {
        for (std::size_t cell = 0; cell < d.cell_count(); ++cell)
            for (std::uint64_t i = d.cell_begin[cell]; i < d.cell_begin[cell + 1]; ++i)
                f(std::size_t{d.cell_faces[i]},
                  d.face_sides[2 * std::size_t{d.cell_faces[i]}] == cell ? 0u : 1u);
    };
    switch (array) {
        case MGDT_VORONOI_FACE_OFFSETS:
            return numbers(d.face_begin);
        case MGDT_VORONOI_FACE_CORNERS:
            return flagged(d.face_corners);
        case MGDT_VORONOI_FACE_SIDES:
            return flagged(d.face_sides);
        case MGDT_VORONOI_FACE_IMAGES:
            for (const std::int64_t k : d.face_images) *out++ = static_cast<Int>(k);
            return;
        case MGDT_VORONOI_RAY_VERTICES:
            return numbers(d.ray_vertices);
        case MGDT_VORONOI_CELL_OFFSETS:
            return numbers(d.cell_begin);
        case MGDT_VORONOI_CELL_FACES:
            return numbers(d.cell_faces);
        case MGDT_VORONOI_CELL_NEIGHBORS:
            return each_face_of_cell([&](std::size_t face, unsigned side) {
                *out++ = unflagged(d.face_sides[2 * face + 1 - side]);
            });
        case MGDT_VORONOI_CELL_NEIGHBOR_IMAGES:
            return each_face_of_cell([&](std::size_t face, unsigned side) {
                for (unsigned c = 0; c < 3; ++c) {
                    const std::int64_t k = d.face_images[3 * face + c];
                    *out++ = static_cast<Int>(side == 0 ? k : -k);
                }
            });
        default:
            std::copy_n(d.is_bounded.begin(), d.is_bounded.size(), out);
    }
}

// The largest number that is written, above the index base.
std::uint64_t largest(const VoronoiDiagram& d) {
    return std::max<std::uint64_t>({d.face_corners.size(), d.cell_faces.size(),
                                    d.vertices.size() / 3, d.areas.size(), d.is_bounded.size()});
}

template <class Int>
void get_integers(const mgdt_voronoi* v, std::int32_t array, std::int64_t capacity, Int* values) {
    const std::size_t size = size_of(v->diagram, array);
    if (!has_integers(array))
        fail(MGDT_ERR_UNKNOWN_KEY, "array %d has doubles, not integers", static_cast<int>(array));
    const std::uint64_t most = largest(v->diagram) + static_cast<std::uint64_t>(v->index_base);
    if (most > static_cast<std::uint64_t>(std::numeric_limits<Int>::max()))
        fail(MGDT_ERR_INDEX_RANGE, "numbers up to %llu do not fit a 32-bit integer",
             static_cast<unsigned long long>(most));
    if (array == MGDT_VORONOI_FACE_IMAGES || array == MGDT_VORONOI_CELL_NEIGHBOR_IMAGES)
        for (const std::int64_t k : v->diagram.face_images)
            if (std::abs(k) > std::numeric_limits<Int>::max())
                fail(MGDT_ERR_INDEX_RANGE, "%lld does not fit a 32-bit integer",
                     static_cast<long long>(k));
    require_capacity(capacity, size, "values");
    if (size == 0) return;
    require_pointer(values, "values");
    write(*v, array, values);
}

void write_doubles(const VoronoiDiagram& d, std::int32_t array, double* out) {
    const auto copy = [&](const Buffer<double>& from) {
        std::copy_n(from.begin(), from.size(), out);
    };
    switch (array) {
        case MGDT_VORONOI_VERTICES:
            return copy(d.vertices);
        case MGDT_VORONOI_RAY_DIRECTIONS:
            return copy(d.ray_directions);
        case MGDT_VORONOI_FACE_AREAS:
            return copy(d.areas);
        case MGDT_VORONOI_FACE_NORMALS:
            return write_normals(d, out);
        case MGDT_VORONOI_FACE_CENTROIDS:
            return copy(d.face_centroids);
        case MGDT_VORONOI_CELL_VOLUMES:
            return copy(d.volumes);
        case MGDT_VORONOI_CELL_FACE_AREAS:
            for (const std::uint32_t face : d.cell_faces) *out++ = d.areas[face];
            return;
        case MGDT_VORONOI_CELL_NEIGHBOR_DISTANCES:
            return write_distances(d, out);
        default:
            return copy(d.cell_centroids);
    }
}

}  // namespace

void mgdt::free_voronoi(mgdt_voronoi* v) noexcept {
    const mgdt_free_fn release = v->allocator.release_function();
    void* const user = v->allocator.user();
    v->~mgdt_voronoi();
    Allocator::give_back(release, user, v, voronoi_size, voronoi_align);
}

mgdt_voronoi* mgdt::new_voronoi(const Allocator& source, std::int32_t index_base) {
    void* const memory =
        Allocator::obtain(source.allocate_function(), source.user(), voronoi_size, voronoi_align);
    if (!memory) throw std::bad_alloc();
    auto* const v = new (memory)
        mgdt_voronoi(source.allocate_function(), source.release_function(), source.user());
    v->index_base = index_base;
    v->allocator.set_limit(source.limit());
    try {
        v->allocator.count(voronoi_size);
    } catch (...) {
        free_voronoi(v);
        throw;
    }
    return v;
}

extern "C" mgdt_status mgdt_voronoi_create(const mgdt_triangulation* t, int64_t n_planes,
                                           const double* planes, mgdt_voronoi** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    return guard(t, [&] {
        *out = make_voronoi(t->core.allocator(), t->core.settings().index_base,
                            [&](VoronoiDiagram& diagram) { build(t, n_planes, planes, diagram); });
    });
}

extern "C" void mgdt_voronoi_destroy(mgdt_voronoi* v) {
    destroy_if_free(v, destroy);
}

extern "C" mgdt_status mgdt_voronoi_get_size(const mgdt_voronoi* v, int32_t array, int64_t* size) {
    return guard(v, [&] {
        require_pointer(size, "size");
        *size = static_cast<std::int64_t>(size_of(v->diagram, array));
    });
}

extern "C" mgdt_status mgdt_voronoi_get_array(const mgdt_voronoi* v, int32_t array,
                                              int64_t capacity, int64_t* values) {
    return guard(v, [&] { get_integers(v, array, capacity, values); });
}

extern "C" mgdt_status mgdt_voronoi_get_array_i32(const mgdt_voronoi* v, int32_t array,
                                                  int64_t capacity, int32_t* values) {
    return guard(v, [&] { get_integers(v, array, capacity, values); });
}

extern "C" mgdt_status mgdt_voronoi_get_doubles(const mgdt_voronoi* v, int32_t array,
                                                int64_t capacity, double* values) {
    return guard(v, [&] {
        const std::size_t size = size_of(v->diagram, array);
        if (has_integers(array))
            fail(MGDT_ERR_UNKNOWN_KEY, "array %d has integers, not doubles",
                 static_cast<int>(array));
        require_capacity(capacity, size, "values");
        if (size == 0) return;
        require_pointer(values, "values");
        write_doubles(v->diagram, array, values);
    });
}

extern "C" mgdt_status mgdt_voronoi_drop_small_faces(mgdt_voronoi* v, double area,
                                                     double relative) {
    return guard(v, [&] {
        if (!(area >= 0))
            fail(MGDT_ERR_INVALID_ARGUMENT, "the least area is %g; it has to be at least 0", area);
        if (!(relative >= 0 && relative < 1))
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "the least share of the area is %g; it has to be at least 0 and less than 1",
                 relative);
        drop_small_faces(v->diagram, area, relative);
    });
}

extern "C" mgdt_status mgdt_voronoi_get_error(const mgdt_voronoi* v, int64_t capacity,
                                              char* buffer) {
    return get_message(v, capacity, buffer);
}
