/* SPDX-License-Identifier: MIT
 * Writes point sets and what the C interface says of them, for the tests of the other languages to
 * compare with: files of 64-bit integers and doubles in the machine's own byte order.
 *
 *   reference FOLDER
 *
 * It checks itself what it writes: mgdt_check at every level, and Euler's formula. */
#include <mgdt/mgdt.h>
#include <mgdt/mgdt_domain.h>
#include <mgdt/mgdt_periodic.h>
#include <mgdt/mgdt_voronoi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { random_points = 1000, repeated_points = 10, queries = 200 };

static const char* folder;

static void stop(const char* what) {
    fprintf(stderr, "reference: %s\n", what);
    exit(1);
}

static void require(mgdt_status s, const mgdt_triangulation* t) {
    char message[256] = "";
    if (s == MGDT_OK) return;
    mgdt_get_error(t, (int64_t)sizeof message, message);
    stop(message);
}

static void* room(int64_t count, size_t size) {
    void* p = calloc((size_t)count + 1, size);
    if (!p) stop("out of memory");
    return p;
}

static void write_file(const char* name, const void* data, int64_t count) {
    char path[4096];
    FILE* f;
    if ((size_t)snprintf(path, sizeof path, "%s/%s", folder, name) >= sizeof path)
        stop("the folder's name is too long");
    f = fopen(path, "wb");
    /* Both kinds of element have 8 bytes. */
    if (!f || fwrite(data, 8, (size_t)count, f) != (size_t)count || fclose(f) != 0) {
        perror(path);
        exit(1);
    }
}

/* Numbers in [0, 1) from a 64-bit congruential generator: the upper 53 bits. */
static double next_random(uint64_t* state) {
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*state >> 11) / 9007199254740992.0;
}

typedef mgdt_status (*get_function)(const mgdt_triangulation* t, int64_t capacity, int64_t* v);

static void export_list(const mgdt_triangulation* t, get_function get, int64_t count,
                        const char* name) {
    int64_t* v = room(count, sizeof *v);
    require(get(t, count, v), t);
    write_file(name, v, count);
    free(v);
}

/* Writes the arrays of a Voronoi diagram, as PREFIX_NAME, and frees it. */
static void write_diagram(mgdt_voronoi* v, const char* prefix) {
    static const struct {
        int32_t key;
        const char* name;
    } arrays[] = {{MGDT_VORONOI_ARRAY_FACE_OFFSETS, "face_offsets"},
                  {MGDT_VORONOI_ARRAY_FACE_CORNERS, "face_corners"},
                  {MGDT_VORONOI_ARRAY_FACE_SIDES, "face_sides"},
                  {MGDT_VORONOI_ARRAY_FACE_SHIFTS, "face_shifts"},
                  {MGDT_VORONOI_ARRAY_RAY_VERTICES, "ray_vertices"},
                  {MGDT_VORONOI_ARRAY_CELL_OFFSETS, "cell_offsets"},
                  {MGDT_VORONOI_ARRAY_CELL_FACES, "cell_faces"},
                  {MGDT_VORONOI_ARRAY_CELL_BOUNDED, "cell_bounded"},
                  {MGDT_VORONOI_ARRAY_CELL_NEIGHBORS, "cell_neighbors"},
                  {MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS, "cell_neighbor_shifts"},
                  {MGDT_VORONOI_ARRAY_CELL_FACE_AREAS, "cell_face_areas"},
                  {MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES, "cell_neighbor_distances"},
                  {MGDT_VORONOI_ARRAY_VERTICES, "vertices"},
                  {MGDT_VORONOI_ARRAY_RAY_DIRECTIONS, "ray_directions"},
                  {MGDT_VORONOI_ARRAY_FACE_AREAS, "face_areas"},
                  {MGDT_VORONOI_ARRAY_FACE_NORMALS, "face_normals"},
                  {MGDT_VORONOI_ARRAY_FACE_CENTROIDS, "face_centroids"},
                  {MGDT_VORONOI_ARRAY_CELL_VOLUMES, "cell_volumes"},
                  {MGDT_VORONOI_ARRAY_CELL_CENTROIDS, "cell_centroids"}};
    size_t k;
    for (k = 0; k < sizeof arrays / sizeof *arrays; ++k) {
        const int32_t key = arrays[k].key;
        char name[64];
        int64_t count = 0;
        void* values;
        mgdt_status status;
        if (mgdt_voronoi_get_size(v, key, &count) != MGDT_OK) stop("an array without a size");
        values = room(count, 8);
        if (key < MGDT_VORONOI_ARRAY_VERTICES)
            status = mgdt_voronoi_get_array(v, key, count, values);
        else
            status = mgdt_voronoi_get_doubles(v, key, count, values);
        if (status != MGDT_OK) stop("an array of a diagram");
        snprintf(name, sizeof name, "%s_%s", prefix, arrays[k].name);
        write_file(name, values, count);
        free(values);
    }
    mgdt_voronoi_destroy(v);
}

static void export_diagram(const mgdt_triangulation* t, int64_t n_planes, const double* planes,
                           const char* prefix) {
    mgdt_voronoi* v = NULL;
    require(mgdt_voronoi_create(t, n_planes, planes, &v), t);
    write_diagram(v, prefix);
}

/* The arrays of a mesh. */
static void write_mesh(const mgdt_mesh* m, const char* prefix) {
    static const struct {
        int32_t key;
        const char* name;
    } arrays[] = {{MGDT_MESH_ARRAY_POINT_ORIGINS, "point_origins"},
                  {MGDT_MESH_ARRAY_TETRAHEDRA, "tetrahedra"},
                  {MGDT_MESH_ARRAY_NEIGHBORS, "neighbors"},
                  {MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS, "tetrahedron_regions"},
                  {MGDT_MESH_ARRAY_REGION_MARKERS, "region_markers"},
                  {MGDT_MESH_ARRAY_FACES, "faces"},
                  {MGDT_MESH_ARRAY_FACE_TETRAHEDRA, "face_tetrahedra"},
                  {MGDT_MESH_ARRAY_FACE_FACETS, "face_facets"},
                  {MGDT_MESH_ARRAY_FACE_MARKERS, "face_markers"},
                  {MGDT_MESH_ARRAY_EDGES, "edges"},
                  {MGDT_MESH_ARRAY_EDGE_SEGMENTS, "edge_segments"},
                  {MGDT_MESH_ARRAY_EDGE_MARKERS, "edge_markers"},
                  {MGDT_MESH_ARRAY_STEINER_EDGES, "steiner_edges"},
                  {MGDT_MESH_ARRAY_REASONS, "reasons"},
                  {MGDT_MESH_ARRAY_REFUSALS, "refusals"},
                  {MGDT_MESH_ARRAY_ANGLE_HISTOGRAM, "angle_histogram"},
                  {MGDT_MESH_ARRAY_TETRAHEDRA_BELOW, "tetrahedra_below"},
                  {MGDT_MESH_ARRAY_POINTS, "points"},
                  {MGDT_MESH_ARRAY_STEINER_PARAMETERS, "steiner_parameters"},
                  {MGDT_MESH_ARRAY_SHAPES, "shapes"},
                  {MGDT_MESH_ARRAY_SIZES, "sizes"}};
    int64_t count = 0, k;
    for (k = 0; k < (int64_t)(sizeof arrays / sizeof *arrays); ++k) {
        char name[64];
        void* values;
        mgdt_status status;
        if (mgdt_mesh_get_size(m, arrays[k].key, &count) != MGDT_OK)
            stop("an array without a size");
        values = room(count, 8);
        if (arrays[k].key < MGDT_MESH_ARRAY_POINTS)
            status = mgdt_mesh_get_array(m, arrays[k].key, count, values);
        else
            status = mgdt_mesh_get_doubles(m, arrays[k].key, count, values);
        if (status != MGDT_OK) stop("an array of a mesh");
        snprintf(name, sizeof name, "%s_%s", prefix, arrays[k].name);
        write_file(name, values, count);
        free(values);
    }
}

/* Places inside and outside of the block, their tetrahedra and weights, and values there: those of
 * the points are their coordinates. */
static void export_places(const mgdt_mesh* m) {
    enum { n = 5 };
    static const double places[3 * n] = {1.25, 2.5, 0.75, 4.5, 1,   1,   -1, -1,
                                         5,    2,   2,    2,   3.3, 0.1, 4};
    static const int32_t outside[2] = {MGDT_OUTSIDE_NONE, MGDT_OUTSIDE_BOUNDARY};
    static const char* const names[2] = {"inside", "nearest"};
    int64_t count = 0, found[n];
    double weights[4 * n], out[3 * n], shapes[3];
    int64_t angles[18], below[6];
    double* xyz;
    int k;
    if (mgdt_mesh_get_size(m, MGDT_MESH_ARRAY_POINTS, &count) != MGDT_OK) stop("no points");
    xyz = room(count, sizeof *xyz);
    if (mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, count, xyz) != MGDT_OK) stop("no points");
    write_file("places", places, 3 * n);
    for (k = 0; k < 2; ++k) {
        char name[64];
        if (mgdt_mesh_locate_points(m, outside[k], n, places, found, weights) != MGDT_OK ||
            mgdt_mesh_interpolate(m, outside[k], 3, xyz, n, places, out) != MGDT_OK)
            stop("places in a mesh");
        snprintf(name, sizeof name, "places_%s_tetrahedra", names[k]);
        write_file(name, found, n);
        snprintf(name, sizeof name, "places_%s_weights", names[k]);
        write_file(name, weights, 4 * n);
        snprintf(name, sizeof name, "places_%s_values", names[k]);
        write_file(name, out, 3 * n);
    }
    if (mgdt_mesh_get_shape_summary(m, shapes, angles, below) != MGDT_OK) stop("shapes");
    write_file("summary_shapes", shapes, 3);
    write_file("summary_angles", angles, 18);
    write_file("summary_below", below, 6);
    free(xyz);
}

static int32_t size_at(int64_t n, const double* xyz, double* sizes, void* user) {
    int64_t i;
    (void)user;
    for (i = 0; i < n; ++i) sizes[i] = 0.375 + 0.125 * xyz[3 * i + 2];
    return 0;
}

/* Refines a block of two regions and 125 points by sizes of all kinds. */
static void refine_block(mgdt_mesh* m) {
    static const double of_regions[2] = {0.45, 0};
    static const double field_points[12] = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8},
                        field_sizes[4] = {0.5, 0.75, 0.75, 1};
    double of_points[125] = {0.3}, of_tetrahedra[384] = {0};
    of_tetrahedra[383] = 0.25;
    if (mgdt_mesh_set_sizes(m, MGDT_SIZES_OF_REGIONS, 2, of_regions) != MGDT_OK ||
        mgdt_mesh_set_sizes(m, MGDT_SIZES_OF_POINTS, 125, of_points) != MGDT_OK ||
        mgdt_mesh_set_sizes(m, MGDT_SIZES_OF_TETRAHEDRA, 384, of_tetrahedra) != MGDT_OK ||
        mgdt_mesh_set_size_field(m, 4, field_points, field_sizes) != MGDT_OK ||
        mgdt_mesh_set_size_function(m, size_at, NULL) != MGDT_OK ||
        mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_SIZE, 0.75) != MGDT_OK ||
        mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_GRADATION, 0.5) != MGDT_OK ||
        mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_RADIUS_EDGE, 1.5) != MGDT_OK ||
        mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_VOLUME, 0.125) != MGDT_OK ||
        mgdt_mesh_set_option(m, MGDT_MESH_OPTION_SIZES_OF_SURFACE, 1) != MGDT_OK ||
        mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MOST_POINTS, 2000) != MGDT_OK ||
        mgdt_mesh_refine(m) != MGDT_OK || mgdt_mesh_check(m) != MGDT_OK)
        stop("the block was not refined");
    mgdt_mesh_set_size_function(m, NULL, NULL);
    mgdt_mesh_set_size_field(m, 0, NULL, NULL);
    write_mesh(m, "refined");
}

/* The cubes of a lattice, whose inner points are moved, each of six tetrahedra. Writes what is
 * given and the arrays of the refined and of the improved mesh. */
static void export_block(void) {
    enum {
        side = 4,
        row = side + 1,
        layer = row * row,
        points = row * layer,
        cubes = side * side * side
    };
    static const int64_t steps[6][3] = {{1, row, layer}, {1, layer, row}, {row, 1, layer},
                                        {row, layer, 1}, {layer, 1, row}, {layer, row, 1}};
    static double xyz[3 * points];
    static int64_t corners[24 * cubes], markers[6 * cubes];
    static int32_t of_tetrahedra[6 * cubes];
    const int64_t faces[3] = {0, 1, row + 1}, of_faces[1] = {9}, fixed[1] = {points / 2};
    const int32_t face_markers[1] = {9};
    int64_t i, j, k, n = 0;
    uint32_t seed = 1;
    mgdt_mesh* m = NULL;
    for (i = 0; i < points; ++i) {
        const int64_t at[3] = {i % row, i / row % row, i / layer};
        for (k = 0; k < 3; ++k) {
            seed = seed * 1664525u + 1013904223u;
            xyz[3 * i + k] = (double)at[k];
            if (at[k] > 0 && at[k] < side) xyz[3 * i + k] += 0.45 * (seed / 4294967296.0 - 0.5);
        }
        if (at[0] == side || at[1] == side || at[2] == side) continue;
        for (j = 0; j < 6; ++j) {
            of_tetrahedra[n / 4] = at[2] < 2 ? 5 : 7;
            markers[n / 4] = of_tetrahedra[n / 4];
            corners[n++] = i;
            for (k = 0; k < 3; ++k, ++n) corners[n] = corners[n - 1] + steps[j][k];
        }
    }
    write_file("block_given_points", xyz, 3 * points);
    write_file("block_given_tetrahedra", corners, n);
    write_file("block_given_markers", markers, n / 4);
    write_file("block_given_faces", faces, 3);
    write_file("block_given_face_markers", of_faces, 1);
    write_file("block_given_fixed", fixed, 1);
    if (mgdt_mesh_create(&m) != MGDT_OK || mgdt_mesh_set_points(m, points, xyz) != MGDT_OK ||
        mgdt_mesh_set_tetrahedra(m, n / 4, corners, of_tetrahedra) != MGDT_OK ||
        mgdt_mesh_set_faces(m, 1, faces, face_markers) != MGDT_OK || mgdt_mesh_build(m) != MGDT_OK)
        stop("the block is no mesh");
    refine_block(m);
    if (mgdt_mesh_set_points(m, points, xyz) != MGDT_OK ||
        mgdt_mesh_set_tetrahedra(m, n / 4, corners, of_tetrahedra) != MGDT_OK ||
        mgdt_mesh_set_faces(m, 1, faces, face_markers) != MGDT_OK ||
        mgdt_mesh_set_fixed_points(m, 1, fixed) != MGDT_OK || mgdt_mesh_build(m) != MGDT_OK ||
        mgdt_mesh_set_option(m, MGDT_MESH_OPTION_GOAL, 30) != MGDT_OK ||
        mgdt_mesh_set_option(m, MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_SLIDE) != MGDT_OK ||
        mgdt_mesh_improve(m) != MGDT_OK || mgdt_mesh_check(m) != MGDT_OK)
        stop("the block was not improved");
    write_mesh(m, "block");
    export_places(m);
    mgdt_mesh_destroy(m);
}

/* Two cubes that share a square, one of them a hole, and a prism that is turned so far that it has
 * no tetrahedra without further points. Writes what is given and the arrays of the mesh. */
static void export_domain(void) {
    static const double xyz[54] = {0, 0, 0, 2,  0, 0, 2,  2,  0, 0, 2, 0,  0,  0, 2,  2, 0,  2,
                                   2, 2, 2, 0,  2, 2, 0,  0,  4, 2, 0, 4,  2,  2, 4,  0, 2,  4,
                                   8, 0, 9, -4, 7, 9, -4, -7, 9, 7, 4, 17, -7, 4, 17, 0, -8, 17};
    static const int64_t corners[68] = {
        0,  3,  2,  1,  0,  1,  5,  4,  1,  2,  6,  5,  2,  3,  7,  6,  3,  0,  4,  7,  4,  5,  6,
        7,  4,  5,  9,  8,  5,  6,  10, 9,  6,  7,  11, 10, 7,  4,  8,  11, 8,  9,  10, 11, 12, 14,
        13, 15, 16, 17, 12, 13, 16, 12, 16, 15, 13, 14, 17, 13, 17, 16, 14, 12, 15, 14, 15, 17};
    static const int64_t ends[4] = {0, 1, 8, 9};
    static const double hole[3] = {1, 1, 3}, inside[3] = {0, 0, 9.5};
    int64_t offsets[20], markers[19], count, k;
    int32_t of_facets[19], of_segments[2] = {5, 6};
    const int32_t marker = 7;
    double* volumes;
    mgdt_domain* d = NULL;
    mgdt_mesh* m = NULL;
    for (k = 0; k < 19; ++k) {
        offsets[k] = k < 11 ? 4 * k : 44 + 3 * (k - 11);
        markers[k] = of_facets[k] = 100 + (int32_t)k;
    }
    offsets[19] = 68;
    write_file("domain_given_points", xyz, 54);
    write_file("domain_given_offsets", offsets, 20);
    write_file("domain_given_corners", corners, 68);
    write_file("domain_given_markers", markers, 19);
    if (mgdt_domain_create(&d) != MGDT_OK ||
        mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_ROUND_POINTS, 1) != MGDT_OK ||
        mgdt_domain_set_points(d, 18, xyz) != MGDT_OK ||
        mgdt_domain_set_facets(d, 19, offsets, corners, of_facets) != MGDT_OK ||
        mgdt_domain_set_segments(d, 2, ends, of_segments) != MGDT_OK ||
        mgdt_domain_set_holes(d, 1, hole) != MGDT_OK ||
        mgdt_domain_set_regions(d, 1, inside, &marker) != MGDT_OK ||
        mgdt_domain_build(d, &m) != MGDT_OK || mgdt_mesh_check(m) != MGDT_OK ||
        mgdt_domain_check(d, m) != MGDT_OK)
        stop("the domain was not meshed");
    write_mesh(m, "domain");
    if (mgdt_mesh_get_stat(m, MGDT_MESH_STAT_TETRAHEDRA, &count) != MGDT_OK) stop("a statistic");
    volumes = room(count, 8);
    if (mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, count, volumes) != MGDT_OK)
        stop("the volumes of a mesh");
    write_file("domain_volumes", volumes, count);
    free(volumes);
    mgdt_mesh_destroy(m);
    mgdt_domain_destroy(d);
}

/* Points in an oblique box, two of which are images of another. Writes them, the arrays of the
 * triangulation, the measures of cells, and the diagram. */
static void export_periodic(void) {
    enum { points = 40 };
    static const double vectors[9] = {4, 0, 0, 1.5, 3, 0, -0.75, 0.5, 2.5};
    static const struct {
        int32_t key;
        const char* name;
    } arrays[] = {{MGDT_PERIODIC_ARRAY_POINT_MAP, "point_map"},
                  {MGDT_PERIODIC_ARRAY_POINT_SHIFTS, "point_shifts"},
                  {MGDT_PERIODIC_ARRAY_TETRAHEDRA, "tetrahedra"},
                  {MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS, "tetrahedron_shifts"},
                  {MGDT_PERIODIC_ARRAY_NEIGHBORS, "neighbors"},
                  {MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS, "neighbor_shifts"},
                  {MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS, "vertex_neighbor_offsets"},
                  {MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS, "vertex_neighbors"},
                  {MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS, "vertex_neighbor_shifts"},
                  {MGDT_PERIODIC_ARRAY_POINTS, "points"},
                  {MGDT_PERIODIC_ARRAY_VECTORS, "vectors"}};
    static const struct {
        int32_t key;
        const char* name;
        int64_t width;
    } measures[] = {{MGDT_MEASURE_VOLUME, "volume", 1},
                    {MGDT_MEASURE_AREA, "area", 1},
                    {MGDT_MEASURE_FACES, "faces", 1},
                    {MGDT_MEASURE_CENTROID, "centroid", 3}};
    static double xyz[3 * points], x[3 * points];
    uint64_t state = 7;
    mgdt_periodic* p = NULL;
    mgdt_voronoi* v = NULL;
    int64_t count, k;
    for (k = 0; k < 3 * points; ++k) xyz[k] = 8 * next_random(&state) - 2;
    for (k = 0; k < 3; ++k) {
        xyz[3 * 38 + k] = xyz[k] + vectors[k];
        xyz[3 * 39 + k] = xyz[k] - vectors[3 + k];
    }
    write_file("periodic_given_points", xyz, 3 * points);
    if (mgdt_periodic_create(&p) != MGDT_OK ||
        mgdt_periodic_set_vectors(p, 3, vectors) != MGDT_OK ||
        mgdt_periodic_insert_points(p, points, xyz) != MGDT_OK ||
        mgdt_periodic_build(p) != MGDT_OK || mgdt_periodic_check(p) != MGDT_OK)
        stop("the box was not triangulated");
    for (k = 0; k < (int64_t)(sizeof arrays / sizeof *arrays); ++k) {
        char name[64];
        void* values;
        mgdt_status status;
        if (mgdt_periodic_get_size(p, arrays[k].key, &count) != MGDT_OK || count == 0)
            stop("an array without elements");
        values = room(count, 8);
        if (arrays[k].key < MGDT_PERIODIC_ARRAY_POINTS)
            status = mgdt_periodic_get_array(p, arrays[k].key, count, values);
        else
            status = mgdt_periodic_get_doubles(p, arrays[k].key, count, values);
        if (status != MGDT_OK) stop("an array of a box");
        snprintf(name, sizeof name, "periodic_%s", arrays[k].name);
        write_file(name, values, count);
        free(values);
    }
    for (k = 0; k < 4; ++k) {
        char name[64];
        count = measures[k].width * points;
        if (mgdt_periodic_get_cell_measures(p, measures[k].key, count, x) != MGDT_OK)
            stop("a measure of a box");
        snprintf(name, sizeof name, "periodic_%s", measures[k].name);
        write_file(name, x, count);
    }
    if (mgdt_periodic_create_voronoi(p, &v) != MGDT_OK) stop("the cells of a box");
    write_diagram(v, "periodic_cells");
    mgdt_periodic_destroy(p);
}

int main(int argc, char** argv) {
    static double xyz[3 * (random_points + repeated_points)], asked[3 * queries];
    static double weights[4 * queries];
    static const double box[24] = {1, 0,  0, 2, -1, 0, 0, 1, 0, 1, 0,  2,
                                   0, -1, 0, 1, 0,  0, 1, 2, 0, 0, -1, 1};
    static const double segment[6] = {-0.5, -0.3, -0.4, 1.5, 1.4, 1.45};
    static int64_t located[queries], nearest[queries];
    const int64_t n = random_points + repeated_points;
    uint64_t state = 20140090;
    mgdt_triangulation* t = NULL;
    int64_t *offsets, *list, tetrahedra, facets, edges, i;
    double *centers, *squares, *measures, *alphas, *values, *results;

    if (argc != 2) stop("usage: reference FOLDER");
    folder = argv[1];
    export_domain();
    export_block();
    export_periodic();
    for (i = 0; i < 3 * random_points; ++i) xyz[i] = next_random(&state);
    for (i = 0; i < repeated_points; ++i)
        memcpy(xyz + 3 * (random_points + i), xyz + 3 * (7 * i + 3), 3 * sizeof *xyz);
    /* Some of them outside of the hull. */
    for (i = 0; i < 3 * queries; ++i) asked[i] = 1.2 * next_random(&state) - 0.1;

    if (mgdt_create(&t) != MGDT_OK) stop("mgdt_create failed");
    require(mgdt_set_canonical_output(t, 1), t);
    require(mgdt_insert_points(t, n, xyz), t);
    require(mgdt_check(t, MGDT_CHECK_CANONICAL), t);
    tetrahedra = mgdt_tetrahedron_count(t);
    facets = mgdt_hull_facet_count(t);
    if (mgdt_vertex_count(t) != random_points) stop("repeated points were not found");
    if (mgdt_vertex_count(t) - mgdt_edge_count(t) + (4 * tetrahedra + facets) / 2 - tetrahedra != 1)
        stop("Euler's formula does not hold");

    write_file("points", xyz, 3 * n);
    export_list(t, mgdt_get_tetrahedra, 4 * tetrahedra, "tetrahedra");
    export_list(t, mgdt_get_neighbors, 4 * tetrahedra, "neighbors");
    export_list(t, mgdt_get_hull_facets, 3 * facets, "hull_facets");
    export_list(t, mgdt_get_edges, 2 * mgdt_edge_count(t), "edges");
    export_list(t, mgdt_get_point_map, n, "point_map");
    offsets = room(n + 1, sizeof *offsets);
    list = room(4 * tetrahedra, sizeof *list);
    require(mgdt_get_vertex_tetrahedra(t, n + 1, offsets, 4 * tetrahedra, list), t);
    write_file("offsets", offsets, n + 1);
    write_file("list", list, 4 * tetrahedra);
    require(mgdt_get_vertex_neighbors(t, n + 1, offsets, 4 * tetrahedra, list), t);
    write_file("neighbor_offsets", offsets, n + 1);
    write_file("neighbor_list", list, mgdt_vertex_neighbors_count(t));
    require(mgdt_get_gabriel_edges(t, 4 * tetrahedra, list, &edges), t);
    write_file("gabriel_edges", list, 2 * edges);
    require(mgdt_get_spanning_tree(t, 4 * tetrahedra, list, &edges), t);
    write_file("spanning_tree", list, 2 * edges);
    centers = room(3 * tetrahedra, sizeof *centers);
    squares = room(tetrahedra, sizeof *squares);
    require(mgdt_get_circumcenters(t, tetrahedra, centers, squares), t);
    write_file("centers", centers, 3 * tetrahedra);
    write_file("squares", squares, tetrahedra);
    require(mgdt_get_alpha_surface(t, 0.01, 4 * tetrahedra, list, &edges), t);
    write_file("alpha_surface", list, 3 * edges);
    alphas = room(4 * tetrahedra, sizeof *alphas);
    require(mgdt_get_alphas(t, 2, 4 * tetrahedra, alphas), t);
    write_file("facet_alphas", alphas, 4 * tetrahedra);
    require(mgdt_get_alphas(t, 1, mgdt_edge_count(t), alphas), t);
    write_file("edge_alphas", alphas, mgdt_edge_count(t));
    require(mgdt_get_solid_alpha(t, alphas), t);
    write_file("solid_alpha", alphas, 1);
    require(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_RADIUS_RATIO, tetrahedra, squares),
            t);
    write_file("radius_ratios", squares, tetrahedra);
    require(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE, tetrahedra,
                                          squares),
            t);
    write_file("largest_angles", squares, tetrahedra);
    measures = room(3 * n, sizeof *measures);
    require(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, box, n, measures), t);
    write_file("volumes", measures, n);
    require(mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 6, box, 3 * n, measures), t);
    write_file("centroids", measures, 3 * n);
    require(mgdt_get_cell_measures(t, MGDT_MEASURE_FACES, 0, NULL, n, measures), t);
    write_file("faces", measures, n);
    export_diagram(t, 6, box, "cut");
    export_diagram(t, 0, NULL, "whole");

    values = room(2 * n, sizeof *values);
    for (i = 0; i < n; ++i) {
        values[2 * i] = xyz[3 * i];
        values[2 * i + 1] = xyz[3 * i + 1] * xyz[3 * i + 2];
    }
    write_file("values", values, 2 * n);
    results = room(6 * n + 2 * queries, sizeof *results);
    require(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_LINEAR, 2, values, queries,
                             asked, results),
            t);
    write_file("interpolated", results, 2 * queries);
    require(mgdt_get_gradients(t, 2, values, results), t);
    write_file("gradients", results, 6 * n);
    free(values);
    free(results);
    values = room(100 * queries, sizeof *values);
    {
        static int64_t row_offsets[queries + 1];
        int64_t* const row_points = room(100 * queries, sizeof *row_points);
        require(mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NONE,
                                               queries, asked, queries + 1, row_offsets,
                                               100 * queries, row_points, values),
                t);
        write_file("row_offsets", row_offsets, queries + 1);
        write_file("row_points", row_points, row_offsets[queries]);
        write_file("row_weights", values, row_offsets[queries]);
        free(row_points);
    }
    free(values);

    {
        static int64_t way[random_points];
        static double parameters[random_points + 1];
        int64_t passed;
        require(
            mgdt_traverse_segment(t, segment, segment + 3, random_points, way, parameters, &passed),
            t);
        if (passed < 20) stop("a segment through few tetrahedra");
        write_file("segment", segment, 6);
        write_file("way", way, passed);
        write_file("way_parameters", parameters, passed + 1);
    }
    require(mgdt_locate_points(t, queries, asked, located, weights), t);
    for (i = 0; i < queries; ++i) require(mgdt_nearest_vertex(t, asked + 3 * i, &nearest[i]), t);
    write_file("queries", asked, 3 * queries);
    write_file("located", located, queries);
    write_file("weights", weights, 4 * queries);
    write_file("nearest", nearest, queries);

    free(alphas);
    free(measures);
    free(squares);
    free(centers);
    free(list);
    free(offsets);
    mgdt_destroy(t);
    return 0;
}
