// SPDX-License-Identifier: MIT
// What a caller sets for a mesh, and the calls that make and change the mesh.
#include <limits>
#include <utility>

#include "capi/items.hpp"
#include "capi/mesh_handle.hpp"
#include "parallel/thread_count.hpp"

using namespace mgdt;

namespace {

// The points that items of the next build may have as corners.
CornerRange input_points(const MeshObject& m) {
    return {m.value.input.points.size() / 3, m.settings().index_base};
}

void set_points(MeshObject& m, std::int64_t n, const double* xyz) {
    Buffer<double> points = copy_of_points(m.allocator(), n, xyz, m.settings().index_base);
    m.value.clear_input();
    m.value.input.points = std::move(points);
    m.value.has_input = true;
}

// Sets tetrahedra, faces or edges, which have `each` corners.
template <class Int>
void set_items(MeshObject& m, std::size_t each, std::int64_t n, const Int* corners,
               const std::int32_t* markers, const char* what, const char* plural,
               Buffer<std::uint32_t>& to, Buffer<std::int32_t>& to_markers) {
    const std::size_t count = require_items(n, each, plural);
    if (count > 0) require_pointer(corners, each == 2 ? "ends" : "corners");
    Buffer<std::uint32_t> copy =
        copy_of_corners(m.allocator(), count, each, corners, input_points(m), what);
    Buffer<std::int32_t> of_items = copy_of_markers(m.allocator(), count, markers);
    to = std::move(copy);
    to_markers = std::move(of_items);
}

template <class Int>
void set_tetrahedra(MeshObject& m, std::int64_t n, const Int* corners,
                    const std::int32_t* markers) {
    GivenMesh& input = m.value.input;
    set_items(m, 4, n, corners, markers, "tetrahedron", "tetrahedra", input.tetrahedra,
              input.tetrahedron_markers);
}

template <class Int>
void set_faces(MeshObject& m, std::int64_t n, const Int* corners, const std::int32_t* markers) {
    GivenMesh& input = m.value.input;
    set_items(m, 3, n, corners, markers, "face", "faces", input.faces, input.face_markers);
}

template <class Int>
void set_edges(MeshObject& m, std::int64_t n, const Int* ends, const std::int32_t* markers) {
    GivenMesh& input = m.value.input;
    set_items(m, 2, n, ends, markers, "edge", "edges", input.edges, input.edge_markers);
}

template <class Int>
void set_fixed_points(MeshObject& m, std::int64_t n, const Int* points) {
    const std::size_t count = require_items(n, 1, "fixed points");
    if (count > 0) require_pointer(points, "points");
    const CornerRange range = {
        m.value.has_input ? input_points(m).points : m.value.given_point_count(),
        m.settings().index_base};
    Buffer<std::uint32_t> copy =
        copy_of_corners(m.allocator(), count, 1, points, range, "fixed point");
    (m.value.has_input ? m.value.fixed_input_points : m.value.fixed_points) = std::move(copy);
}

void build(MeshObject& m, StageProgress& progress) {
    MeshState& state = m.value;
    if (state.input.tetrahedra.empty())
        fail(MGDT_ERR_INVALID_ARGUMENT, "no tetrahedra have been set since the last build");
    SolidMesh made(m.allocator());
    Team team(thread_count(m.settings()));
    link_mesh(state.input, m.settings().index_base, team, m.allocator(), progress, made);
    state.forget_numbers();
    state.wishes.of_regions.reset();
    static_cast<SolidMesh&>(state) = std::move(made);
    state.fixed_points = std::move(state.fixed_input_points);
    state.report.clear();
    state.clear_input();
}

void improve(MeshObject& m, StageProgress& progress) {
    Team team(thread_count(m.settings()));
    m.value.forget_numbers();
    improve_mesh(m.value, m.settings(), m.value.fixed_points, team, m.allocator(), progress,
                 m.value.report);
}

// A copy of sizes. Refuses those for which is_allowed() is false, and names the first one.
template <class IsAllowed>
Buffer<double> copy_of_sizes(MeshObject& m, std::size_t count, const double* sizes,
                             const IsAllowed& is_allowed) {
    Buffer<double> copy(m.allocator());
    copy.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_allowed(sizes[i]))
            fail(MGDT_ERR_INVALID_ARGUMENT, "size %lld is %g",
                 static_cast<long long>(i) + m.settings().index_base, sizes[i]);
        copy[i] = sizes[i];
    }
    return copy;
}

void set_sizes(MeshObject& m, std::int32_t of, std::int64_t n, const double* sizes) {
    MeshState& state = m.value;
    const struct {
        Buffer<double>& to;
        std::size_t count;
        const char* what;
    } kinds[] = {{state.wishes.of_points, state.points.size() / 3, "points"},
                 {state.wishes.of_tetrahedra, state.tetrahedron_count(), "tetrahedra"},
                 {state.wishes.of_regions, state.region_markers.size(), "regions"}};
    if (of < MGDT_SIZES_OF_POINTS || of > MGDT_SIZES_OF_REGIONS)
        fail(MGDT_ERR_UNKNOWN_KEY, "there are no sizes of kind %d", static_cast<int>(of));
    const auto& kind = kinds[of];
    if (n != 0 && (n < 0 || static_cast<std::uint64_t>(n) != kind.count))
        fail(MGDT_ERR_INVALID_ARGUMENT, "%lld sizes of %s, of which there are %llu",
             static_cast<long long>(n), kind.what, static_cast<unsigned long long>(kind.count));
    if (n > 0) require_pointer(sizes, "sizes");
    const auto count = static_cast<std::size_t>(n);
    kind.to = copy_of_sizes(m, count, sizes, [](double size) { return size >= 0; });
}

void set_size_field(MeshObject& m, std::int64_t n, const double* xyz, const double* sizes) {
    Buffer<double> points = copy_of_points(m.allocator(), n, xyz, m.settings().index_base);
    const auto count = static_cast<std::size_t>(n);
    if (count > 0) require_pointer(sizes, "sizes");
    Buffer<double> copy = copy_of_sizes(m, count, sizes, [](double size) {
        return size > 0 && size < std::numeric_limits<double>::infinity();
    });
    VaryingSizes& varying = m.value.wishes.varying;
    varying.field_points = std::move(points);
    varying.field_sizes = std::move(copy);
}

void refine(MeshObject& m, StageProgress& progress) {
    Team team(thread_count(m.settings()));
    MeshState& state = m.value;
    RefinementOptions options = m.settings();
    options.divides_walls = m.settings().slides;
    refine_mesh(state, options, state.wishes, team, m.allocator(), progress, state.refinement);
    state.forget_places();
    state.wishes.of_points.reset();
    state.wishes.of_tetrahedra.reset();
    state.report.clear();
}

// Runs body(progress), a call that changes the mesh, reports progress and can be cancelled.
template <class Body>
mgdt_status change(mgdt_mesh* m, const Body& body, const char* name = __builtin_FUNCTION()) {
    return guard(
        m,
        [&] {
            const StopFlag::Call call(m->object.stop());
            StageProgress progress(m->object.settings(), m->object.stop());
            progress.report(0);
            body(m->object, progress);
            progress.finish();
        },
        name);
}

}  // namespace

extern "C" mgdt_status mgdt_mesh_set_points(mgdt_mesh* m, int64_t n, const double* xyz) {
    return guard(m, [&] { set_points(m->object, n, xyz); });
}

extern "C" mgdt_status mgdt_mesh_set_tetrahedra(mgdt_mesh* m, int64_t n, const int64_t* corners,
                                                const int32_t* markers) {
    return guard(m, [&] { set_tetrahedra(m->object, n, corners, markers); });
}

extern "C" mgdt_status mgdt_mesh_set_tetrahedra_i32(mgdt_mesh* m, int64_t n, const int32_t* corners,
                                                    const int32_t* markers) {
    return guard(m, [&] { set_tetrahedra(m->object, n, corners, markers); });
}

extern "C" mgdt_status mgdt_mesh_set_faces(mgdt_mesh* m, int64_t n, const int64_t* corners,
                                           const int32_t* markers) {
    return guard(m, [&] { set_faces(m->object, n, corners, markers); });
}

extern "C" mgdt_status mgdt_mesh_set_faces_i32(mgdt_mesh* m, int64_t n, const int32_t* corners,
                                               const int32_t* markers) {
    return guard(m, [&] { set_faces(m->object, n, corners, markers); });
}

extern "C" mgdt_status mgdt_mesh_set_edges(mgdt_mesh* m, int64_t n, const int64_t* ends,
                                           const int32_t* markers) {
    return guard(m, [&] { set_edges(m->object, n, ends, markers); });
}

extern "C" mgdt_status mgdt_mesh_set_edges_i32(mgdt_mesh* m, int64_t n, const int32_t* ends,
                                               const int32_t* markers) {
    return guard(m, [&] { set_edges(m->object, n, ends, markers); });
}

extern "C" mgdt_status mgdt_mesh_set_fixed_points(mgdt_mesh* m, int64_t n, const int64_t* points) {
    return guard(m, [&] { set_fixed_points(m->object, n, points); });
}

extern "C" mgdt_status mgdt_mesh_set_fixed_points_i32(mgdt_mesh* m, int64_t n,
                                                      const int32_t* points) {
    return guard(m, [&] { set_fixed_points(m->object, n, points); });
}

extern "C" mgdt_status mgdt_mesh_build(mgdt_mesh* m) {
    return change(m, build);
}

extern "C" mgdt_status mgdt_mesh_set_sizes(mgdt_mesh* m, int32_t of, int64_t n,
                                           const double* sizes) {
    return guard(m, [&] { set_sizes(m->object, of, n, sizes); });
}

extern "C" mgdt_status mgdt_mesh_set_size_field(mgdt_mesh* m, int64_t n, const double* xyz,
                                                const double* sizes) {
    return guard(m, [&] { set_size_field(m->object, n, xyz, sizes); });
}

extern "C" mgdt_status mgdt_mesh_set_size_function(mgdt_mesh* m, mgdt_size_fn fn, void* user) {
    return guard(m, [&] {
        m->object.value.wishes.varying.function = fn;
        m->object.value.wishes.varying.user = user;
    });
}

extern "C" mgdt_status mgdt_mesh_get_size_function(const mgdt_mesh* m, mgdt_size_fn* fn,
                                                   void** user) {
    return guard_short(m, [&] {
        require_pointer(reinterpret_cast<const void*>(fn), "the output");
        *fn = m->object.value.wishes.varying.function;
        if (user) *user = m->object.value.wishes.varying.user;
    });
}

extern "C" mgdt_status mgdt_mesh_refine(mgdt_mesh* m) {
    return change(m, refine);
}

extern "C" mgdt_status mgdt_mesh_improve(mgdt_mesh* m) {
    return change(m, improve);
}
