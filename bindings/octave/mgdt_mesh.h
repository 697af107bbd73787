/* SPDX-License-Identifier: MIT
 * Domains and meshes: what mgdt_domain_mesh.m, mgdt_refine.m, mgdt_improve.m, mgdt_mesh_places.m
 * and mgdt_offending_pairs.m call. */
#ifndef MGDT_OCTAVE_MESH_H
#define MGDT_OCTAVE_MESH_H

#include "mgdt_support.h"

/* The domain and the mesh in use. Octave's allocations may leave the function, so they are kept
 * here and freed by the next call. */
static mgdt_domain* domain;
static mgdt_mesh* mesh;
static int domain_is_busy; /* a progress function is running, which must not free it */

static void close_domain(void) {
    if (domain_is_busy) return;
    if (mesh) mgdt.mesh_destroy(mesh);
    if (domain) mgdt.domain_destroy(domain);
    mesh = NULL;
    domain = NULL;
}

DEFINE_READER(domain, domain, close_domain)
DEFINE_READER(mesh, mesh, close_domain)

/* As many markers as there are things that they mark, or [] for none. */
static const int32_t* markers(const mxArray* a, const char* what, int64_t n) {
    int64_t listed, k;
    const int64_t* const given = whole_numbers(a, what, &listed);
    int32_t* const to = room(listed, sizeof *to);
    if (listed == 0) return NULL;
    if (listed != n)
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s are %lld numbers; they must be %lld", what,
                          (long long)listed, (long long)n);
    for (k = 0; k < n; ++k) {
        if (given[k] < INT32_MIN || given[k] > INT32_MAX)
            mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s must fit 32-bit integers", what);
        to[k] = (int32_t)given[k];
    }
    return to;
}

static const double* places(const mxArray* a, const char* what, int64_t* n) {
    const double* const from = columns(a, 3, what, n);
    return one_by_one(from, 3, *n);
}

/* The arguments: points, offsets, corners, markers, ends of segments, markers of segments, holes,
 * places of regions, their markers, whether points are rounded, whether nothing may be left out,
 * whether the boundary is kept, whether it is cleaned, the distances for that, threads and the
 * memory limit. All are read before a domain is made. */
enum { domain_arguments = 17 };

static void make_domain(int count, const mxArray* const* given, int always_cleaned) {
    int64_t n, n_offsets, n_corners, n_ends, n_holes, n_regions;
    const double *xyz, *holes, *regions;
    const int64_t *offsets, *corners, *ends;
    const int32_t *of_facets, *of_segments, *of_regions;
    int32_t rounded, strict, kept, cleaned, threads;
    double weld, flatness;
    int64_t limit;
    if (count < domain_arguments) bad_argument("a domain needs more arguments");
    if (domain_is_busy)
        mexErrMsgIdAndTxt("mgdt:busy", "a progress function of a mesh may not use another domain");
    xyz = places(given[0], "points", &n);
    offsets = whole_numbers(given[1], "offsets", &n_offsets);
    corners = whole_numbers(given[2], "corners of facets", &n_corners);
    if (n_offsets < 1 || offsets[n_offsets - 1] != n_corners + 1)
        bad_argument("the offsets of facets do not fit their corners");
    of_facets = markers(given[3], "markers", n_offsets - 1);
    ends = whole_numbers(given[4], "ends of segments", &n_ends);
    of_segments = markers(given[5], "segment_markers", n_ends / 2);
    holes = places(given[6], "holes", &n_holes);
    regions = places(given[7], "regions", &n_regions);
    of_regions = markers(given[8], "the markers of regions", n_regions);
    rounded = small(given[9], "rounded");
    strict = small(given[10], "strict");
    kept = small(given[11], "keep_boundary");
    cleaned = small(given[12], "clean");
    weld = number(given[13], "weld");
    flatness = number(given[14], "flatness");
    threads = small(given[15], "threads");
    limit = integer(given[16], "memory_limit", 9e15);

    close_domain();
    if (mgdt.domain_create(&domain) != MGDT_OK) ensure(NULL, MGDT_ERR_OUT_OF_MEMORY);
    ensure_domain(mgdt.domain_set_option(domain, MGDT_DOMAIN_OPTION_INDEX_BASE, 1));
    ensure_domain(mgdt.domain_set_option(domain, MGDT_DOMAIN_OPTION_ROUND_POINTS, rounded));
    ensure_domain(mgdt.domain_set_option(domain, MGDT_DOMAIN_OPTION_STRICT, strict));
    ensure_domain(mgdt.domain_set_option(domain, MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, kept));
    ensure_domain(mgdt.domain_set_double_option(domain, MGDT_DOMAIN_OPTION_WELD, weld));
    ensure_domain(mgdt.domain_set_double_option(domain, MGDT_DOMAIN_OPTION_FLATNESS, flatness));
    ensure_domain(mgdt.domain_set_option(domain, MGDT_DOMAIN_OPTION_THREADS, threads));
    ensure_domain(mgdt.domain_set_option(domain, MGDT_DOMAIN_OPTION_MEMORY_LIMIT, limit));
    ensure_domain(mgdt.domain_set_points(domain, n, xyz));
    ensure_domain(mgdt.domain_set_facets(domain, n_offsets - 1, offsets, corners, of_facets));
    ensure_domain(mgdt.domain_set_segments(domain, n_ends / 2, ends, of_segments));
    ensure_domain(mgdt.domain_set_holes(domain, n_holes, holes));
    ensure_domain(mgdt.domain_set_regions(domain, n_regions, regions, of_regions));
    if (always_cleaned || cleaned || weld != 0 || flatness != 0)
        ensure_domain(mgdt.domain_clean(domain));
}

/* The cleaned facets and segments as a struct. */
static mxArray* clean_surface(int count, const mxArray* const* given) {
    static const struct {
        const char* name;
        int32_t key;
    } arrays[] = {{"points", MGDT_DOMAIN_ARRAY_POINTS},
                  {"offsets", MGDT_DOMAIN_ARRAY_FACET_OFFSETS},
                  {"corners", MGDT_DOMAIN_ARRAY_FACET_CORNERS},
                  {"markers", MGDT_DOMAIN_ARRAY_FACET_MARKERS},
                  {"origins", MGDT_DOMAIN_ARRAY_FACET_ORIGINS},
                  {"segments", MGDT_DOMAIN_ARRAY_SEGMENTS},
                  {"segment_markers", MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS},
                  {"segment_origins", MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS},
                  {"covered", MGDT_DOMAIN_ARRAY_COVERED_FACETS}},
      counts[] = {{"moved_points", MGDT_DOMAIN_STAT_MOVED_POINTS},
                  {"repeated_corners", MGDT_DOMAIN_STAT_REPEATED_CORNERS},
                  {"collapsed_facets", MGDT_DOMAIN_STAT_COLLAPSED_FACETS},
                  {"points_in_edges", MGDT_DOMAIN_STAT_POINTS_IN_EDGES},
                  {"points_in_facets", MGDT_DOMAIN_STAT_POINTS_IN_FACETS},
                  {"edges_in_facets", MGDT_DOMAIN_STAT_EDGES_IN_FACETS},
                  {"exchanged_edges", MGDT_DOMAIN_STAT_EXCHANGED_EDGES}};
    enum { n_arrays = sizeof arrays / sizeof *arrays, n_counts = sizeof counts / sizeof *counts };
    const char* names[n_arrays + n_counts];
    mxArray* result;
    int k;
    make_domain(count, given, 1);
    for (k = 0; k < n_arrays; ++k) names[k] = arrays[k].name;
    for (k = 0; k < n_counts; ++k) names[n_arrays + k] = counts[k].name;
    result = mxCreateStructMatrix(1, 1, n_arrays + n_counts, names);
    for (k = 0; k < n_arrays; ++k) mxSetFieldByNumber(result, 0, k, array_of_domain(arrays[k].key));
    for (k = 0; k < n_counts; ++k) {
        int64_t n = 0;
        ensure_domain(mgdt.domain_get_stat(domain, counts[k].key, &n));
        mxSetFieldByNumber(result, 0, n_arrays + k, mxCreateDoubleScalar((double)n));
    }
    close_domain();
    return result;
}

/* Rows of two kinds and two numbers. */
static mxArray* offending_pairs(int count, const mxArray* const* given) {
    mgdt_status status;
    mxArray* result;
    make_domain(count, given, 0);
    status = mgdt.domain_validate(domain);
    if (status != MGDT_ERR_INVALID_BOUNDARY) ensure_domain(status);
    result = array_of_domain(MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS);
    close_domain();
    return result;
}

/* The mesh as a struct of its arrays, with those of the domain if there is one. */
static mxArray* struct_of_mesh(int has_domain) {
    static const struct {
        const char* name;
        int32_t key;
    } arrays[] = {{"points", MGDT_MESH_ARRAY_POINTS},
                  {"point_origins", MGDT_MESH_ARRAY_POINT_ORIGINS},
                  {"tetrahedra", MGDT_MESH_ARRAY_TETRAHEDRA},
                  {"neighbours", MGDT_MESH_ARRAY_NEIGHBORS},
                  {"tetrahedron_regions", MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS},
                  {"region_markers", MGDT_MESH_ARRAY_REGION_MARKERS},
                  {"faces", MGDT_MESH_ARRAY_FACES},
                  {"face_tetrahedra", MGDT_MESH_ARRAY_FACE_TETRAHEDRA},
                  {"face_facets", MGDT_MESH_ARRAY_FACE_FACETS},
                  {"face_markers", MGDT_MESH_ARRAY_FACE_MARKERS},
                  {"edges", MGDT_MESH_ARRAY_EDGES},
                  {"edge_segments", MGDT_MESH_ARRAY_EDGE_SEGMENTS},
                  {"edge_markers", MGDT_MESH_ARRAY_EDGE_MARKERS},
                  {"steiner_edges", MGDT_MESH_ARRAY_STEINER_EDGES},
                  {"steiner_parameters", MGDT_MESH_ARRAY_STEINER_PARAMETERS},
                  {"reasons", MGDT_MESH_ARRAY_REASONS},
                  {"angle_histogram", MGDT_MESH_ARRAY_ANGLE_HISTOGRAM},
                  {"tetrahedra_below", MGDT_MESH_ARRAY_TETRAHEDRA_BELOW},
                  {"shapes", MGDT_MESH_ARRAY_SHAPES},
                  {"refusals", MGDT_MESH_ARRAY_REFUSALS},
                  {"sizes", MGDT_MESH_ARRAY_SIZES}};
    enum { n_arrays = sizeof arrays / sizeof *arrays };
    const char* names[n_arrays + 4];
    int64_t is_rounded = 0, n = 0;
    double* volumes;
    mxArray* result;
    int k;
    ensure_mesh(mgdt.mesh_get_stat(mesh, MGDT_MESH_STAT_IS_ROUNDED, &is_rounded));
    ensure_mesh(mgdt.mesh_get_stat(mesh, MGDT_MESH_STAT_TETRAHEDRA, &n));
    for (k = 0; k < n_arrays; ++k) names[k] = arrays[k].name;
    names[n_arrays] = "volumes";
    names[n_arrays + 1] = "is_rounded";
    names[n_arrays + 2] = "open_edges";
    names[n_arrays + 3] = "covered_facets";
    result = mxCreateStructMatrix(1, 1, n_arrays + 2 + (has_domain ? 2 : 0), names);
    for (k = 0; k < n_arrays; ++k) mxSetFieldByNumber(result, 0, k, array_of_mesh(arrays[k].key));
    volumes = room(n, sizeof *volumes);
    ensure_mesh(mgdt.mesh_get_tetrahedron_measures(mesh, MGDT_TETRAHEDRON_VOLUME, n, volumes));
    mxSetFieldByNumber(result, 0, n_arrays, rows_of_doubles(volumes, n, 1));
    mxFree(volumes);
    mxSetFieldByNumber(result, 0, n_arrays + 1, mxCreateLogicalScalar(is_rounded != 0));
    if (has_domain) {
        mxSetFieldByNumber(result, 0, n_arrays + 2, array_of_domain(MGDT_DOMAIN_ARRAY_OPEN_EDGES));
        mxSetFieldByNumber(result, 0, n_arrays + 3,
                           array_of_domain(MGDT_DOMAIN_ARRAY_COVERED_FACETS));
    }
    return result;
}

/* The mesh as a struct of its arrays. After the arguments of make_domain(): a progress function or
 * [], and whether to check. */
static mxArray* domain_mesh(int count, const mxArray* const* given) {
    progress p = {NULL, NULL};
    const mxArray* function;
    int is_checked;
    mxArray* result;
    mgdt_status status;
    if (count < domain_arguments + 2) bad_argument("a mesh needs more arguments");
    function = given[domain_arguments];
    is_checked = number(given[domain_arguments + 1], "check") != 0;
    make_domain(count, given, 0);
    if (!mxIsEmpty(function)) {
        p.function = mxDuplicateArray(function);
        mgdt.domain_set_progress(domain, report, &p);
    }
    domain_is_busy = 1;
    status = mgdt.domain_build(domain, &mesh);
    domain_is_busy = 0;
    mgdt.domain_set_progress(domain, NULL, NULL);
    if (p.problem) {
        close_domain();
        mexCallMATLAB(0, NULL, 1, &p.problem, "rethrow");
    }
    ensure_domain(status);
    if (is_checked) {
        ensure_mesh(mgdt.mesh_check(mesh));
        ensure_domain(mgdt.domain_check(domain, mesh));
    }
    result = struct_of_mesh(1);
    close_domain();
    return result;
}

/* Makes a mesh of points, tetrahedra, markers, faces, markers of faces, edges, markers of edges,
 * threads and the memory limit. All are read before a mesh is made. */
enum { mesh_items = 9 };

static void make_mesh(const mxArray* const* given) {
    int64_t n, n_corners, n_face_corners, n_ends;
    const double* const xyz = places(given[0], "points", &n);
    const int64_t* const corners = whole_numbers(given[1], "corners of tetrahedra", &n_corners);
    const int32_t* const of_tetrahedra = markers(given[2], "markers", n_corners / 4);
    const int64_t* const faces = whole_numbers(given[3], "corners of faces", &n_face_corners);
    const int32_t* const of_faces = markers(given[4], "face_markers", n_face_corners / 3);
    const int64_t* const ends = whole_numbers(given[5], "ends of edges", &n_ends);
    const int32_t* const of_edges = markers(given[6], "edge_markers", n_ends / 2);
    const int32_t threads = small(given[7], "threads");
    const int64_t limit = integer(given[8], "memory_limit", 9e15);
    if (domain_is_busy)
        mexErrMsgIdAndTxt("mgdt:busy", "a progress function of a mesh may not use another mesh");
    close_domain();
    if (mgdt.mesh_create(&mesh) != MGDT_OK) ensure(NULL, MGDT_ERR_OUT_OF_MEMORY);
    ensure_mesh(mgdt.mesh_set_option(mesh, MGDT_MESH_OPTION_INDEX_BASE, 1));
    ensure_mesh(mgdt.mesh_set_option(mesh, MGDT_MESH_OPTION_MEMORY_LIMIT, limit));
    ensure_mesh(mgdt.mesh_set_option(mesh, MGDT_MESH_OPTION_THREADS, threads));
    ensure_mesh(mgdt.mesh_set_points(mesh, n, xyz));
    ensure_mesh(mgdt.mesh_set_tetrahedra(mesh, n_corners / 4, corners, of_tetrahedra));
    ensure_mesh(mgdt.mesh_set_faces(mesh, n_face_corners / 3, faces, of_faces));
    ensure_mesh(mgdt.mesh_set_edges(mesh, n_ends / 2, ends, of_edges));
    ensure_mesh(mgdt.mesh_build(mesh));
}

/* Changes the mesh, which is checked then if that is wanted, and returns it as a struct. `sizes`
 * may have the problem of a function that found sizes. */
static mxArray* changed_mesh(mgdt_status (*change)(mgdt_mesh*), progress* sizes,
                             const mxArray* function, int is_checked) {
    progress p = {NULL, NULL};
    mxArray* result;
    mgdt_status status;
    if (!mxIsEmpty(function)) {
        p.function = mxDuplicateArray(function);
        mgdt.mesh_set_progress(mesh, report, &p);
    }
    domain_is_busy = 1;
    status = change(mesh);
    domain_is_busy = 0;
    mgdt.mesh_set_progress(mesh, NULL, NULL);
    mgdt.mesh_set_size_function(mesh, NULL, NULL);
    if (p.problem || sizes->problem) {
        close_domain();
        mexCallMATLAB(0, NULL, 1, p.problem ? &p.problem : &sizes->problem, "rethrow");
    }
    ensure_mesh(status);
    if (is_checked) ensure_mesh(mgdt.mesh_check(mesh));
    result = struct_of_mesh(0);
    close_domain();
    return result;
}

/* The improvement of a mesh. After the arguments of make_mesh(): fixed points, goal, boundary, what
 * happens to points, mean passes, most passes, a progress function or [], and whether to check. */
static mxArray* improved_mesh(int count, const mxArray* const* given) {
    static const int32_t keys[] = {MGDT_MESH_OPTION_GOAL, MGDT_MESH_OPTION_BOUNDARY,
                                   MGDT_MESH_OPTION_POINTS, MGDT_MESH_OPTION_MEAN_PASSES,
                                   MGDT_MESH_OPTION_MOST_PASSES};
    enum { n_keys = sizeof keys / sizeof *keys, first_key = mesh_items + 1 };
    static const char* const names[n_keys] = {"goal", "boundary", "keep", "mean_passes",
                                              "most_passes"};
    int32_t values[n_keys];
    const int64_t* fixed;
    int64_t n_fixed;
    const mxArray* function;
    progress unasked = {NULL, NULL};
    int is_checked, k;
    if (count < first_key + n_keys + 2) bad_argument("a mesh needs more arguments");
    fixed = whole_numbers(given[mesh_items], "fixed", &n_fixed);
    for (k = 0; k < n_keys; ++k) values[k] = small(given[first_key + k], names[k]);
    function = given[first_key + n_keys];
    is_checked = number(given[first_key + n_keys + 1], "check") != 0;
    make_mesh(given);
    ensure_mesh(mgdt.mesh_set_fixed_points(mesh, n_fixed, fixed));
    for (k = 0; k < n_keys; ++k) ensure_mesh(mgdt.mesh_set_option(mesh, keys[k], values[k]));
    return changed_mesh(mgdt.mesh_improve, &unasked, function, is_checked);
}

/* Sizes that a mesh takes, or [] for none. */
static void set_sizes(int32_t of, const mxArray* a) {
    const int64_t n = (int64_t)mxGetNumberOfElements(a);
    if (n > 0 && !mxIsDouble(a)) bad_argument("sizes are numbers");
    ensure_mesh(mgdt.mesh_set_sizes(mesh, of, n, n > 0 ? mxGetPr(a) : NULL));
}

/* Points with sizes, linear between them; [] and [] for none. */
static void set_size_field(const mxArray* points, const mxArray* sizes) {
    int64_t n = 0;
    const double* const xyz = mxIsEmpty(points) ? NULL : places(points, "size_field", &n);
    if ((int64_t)mxGetNumberOfElements(sizes) != n)
        bad_argument("size_field has not one size for each point");
    if (n > 0) ensure_mesh(mgdt.mesh_set_size_field(mesh, n, xyz, mxGetPr(sizes)));
}

/* Asks a function of Octave's for the sizes at places, in a matrix with a row for each. */
static int32_t find_sizes(int64_t n, const double* xyz, double* sizes, void* user) {
    mxArray* const places_asked = mxCreateDoubleMatrix((mwSize)n, 3, mxREAL);
    double* const to = mxGetPr(places_asked);
    mxArray* answer;
    int64_t i;
    int k;
    for (i = 0; i < n; ++i)
        for (k = 0; k < 3; ++k) to[n * k + i] = xyz[3 * i + k];
    answer = ask(user, "mgdt_sizes", places_asked);
    if (!answer) return 1;
    memcpy(sizes, mxGetPr(answer), (size_t)n * sizeof *sizes);
    mxDestroyArray(answer);
    return 0;
}

/* The refinement of a mesh. After the arguments of make_mesh(): sizes of points, tetrahedra and
 * regions, points and sizes of a field, a function that finds sizes or [], the size everywhere,
 * gradation, radius-edge ratio, volume, most points, whether sizes are those of the surface, a
 * progress function or [], and whether to check. */
static mxArray* refined_mesh(int count, const mxArray* const* given) {
    static const struct {
        const char* name;
        int32_t key;
    } doubles[] = {{"size", MGDT_MESH_OPTION_SIZE},
                   {"gradation", MGDT_MESH_OPTION_GRADATION},
                   {"radius_edge", MGDT_MESH_OPTION_RADIUS_EDGE},
                   {"volume", MGDT_MESH_OPTION_VOLUME}};
    enum { n_doubles = sizeof doubles / sizeof *doubles, first_double = mesh_items + 6 };
    double values[n_doubles];
    progress sizes = {NULL, NULL};
    int32_t most_points, of_surface;
    const mxArray* const* const last = given + first_double + n_doubles;
    int is_checked, k;
    if (count < first_double + n_doubles + 4) bad_argument("a mesh needs more arguments");
    for (k = 0; k < n_doubles; ++k) values[k] = number(given[first_double + k], doubles[k].name);
    most_points = small(last[0], "most_points");
    of_surface = small(last[1], "sizes_of_surface");
    is_checked = number(last[3], "check") != 0;
    make_mesh(given);
    set_sizes(MGDT_SIZES_OF_POINTS, given[mesh_items]);
    set_sizes(MGDT_SIZES_OF_TETRAHEDRA, given[mesh_items + 1]);
    set_sizes(MGDT_SIZES_OF_REGIONS, given[mesh_items + 2]);
    set_size_field(given[mesh_items + 3], given[mesh_items + 4]);
    if (!mxIsEmpty(given[mesh_items + 5])) {
        sizes.function = mxDuplicateArray(given[mesh_items + 5]);
        mgdt.mesh_set_size_function(mesh, find_sizes, &sizes);
    }
    for (k = 0; k < n_doubles; ++k)
        ensure_mesh(mgdt.mesh_set_double_option(mesh, doubles[k].key, values[k]));
    ensure_mesh(mgdt.mesh_set_option(mesh, MGDT_MESH_OPTION_MOST_POINTS, most_points));
    ensure_mesh(mgdt.mesh_set_option(mesh, MGDT_MESH_OPTION_SIZES_OF_SURFACE, of_surface));
    return changed_mesh(mgdt.mesh_refine, &sizes, last[2], is_checked);
}

/* Tetrahedra and weights of places in a mesh, and values there. After the arguments of make_mesh():
 * places, whether the nearest place of the boundary stands for one outside, and values of the
 * points, a row for each, or []. */
static void mesh_places(int results, mxArray** to, int count, const mxArray* const* given) {
    int64_t n, n_points = 0, fields;
    const double *where, *values = NULL;
    double *weights, *out;
    int64_t* found;
    int32_t outside;
    if (count < mesh_items + 3) bad_argument("places in a mesh need more arguments");
    where = places(given[mesh_items], "places", &n);
    outside =
        number(given[mesh_items + 1], "nearest") != 0 ? MGDT_OUTSIDE_BOUNDARY : MGDT_OUTSIDE_NONE;
    fields = (int64_t)mxGetN(given[mesh_items + 2]);
    if (!mxIsEmpty(given[mesh_items + 2])) {
        const double* const by_columns =
            columns(given[mesh_items + 2], (int)fields, "values", &n_points);
        values = one_by_one(by_columns, (int)fields, n_points);
    }
    make_mesh(given);
    if (values) {
        int64_t points = 0;
        ensure_mesh(mgdt.mesh_get_stat(mesh, MGDT_MESH_STAT_POINTS, &points));
        if (points != n_points) {
            close_domain();
            mexErrMsgIdAndTxt("mgdt:invalid_argument", "values have %lld rows; they must have %lld",
                              (long long)n_points, (long long)points);
        }
    }
    found = room(n, sizeof *found);
    weights = room(4 * n, sizeof *weights);
    ensure_mesh(mgdt.mesh_locate_points(mesh, outside, n, where, found, weights));
    to[0] = rows(found, n, 1);
    if (results > 1) to[1] = rows_of_doubles(weights, n, 4);
    if (results > 2) {
        out = room(fields * n, sizeof *out);
        if (values)
            ensure_mesh(mgdt.mesh_interpolate(mesh, outside, fields, values, n, where, out));
        to[2] = rows_of_doubles(out, values ? n : 0, values ? (int)fields : 0);
        mxFree(out);
    }
    mxFree(weights);
    mxFree(found);
    close_domain();
}

#endif /* MGDT_OCTAVE_MESH_H */
