/* SPDX-License-Identifier: MIT
 * The improvement of meshes. */
#include <math.h>
#include <mgdt/mgdt_domain.h>

#include "given_lattice.h"

static void options(void) {
    static const struct {
        int32_t key;
        int64_t first, most;
    } all[] = {{MGDT_MESH_OPTION_GOAL, 25, 70},
               {MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_FIXED, MGDT_BOUNDARY_SLIDE},
               {MGDT_MESH_OPTION_POINTS, MGDT_POINTS_MOVE, MGDT_POINTS_REMOVE},
               {MGDT_MESH_OPTION_MEAN_PASSES, 0, 1000},
               {MGDT_MESH_OPTION_MOST_PASSES, 100, 10000}};
    mgdt_mesh* m = NULL;
    int64_t value = -1;
    size_t k;
    CHECK_EQUAL(mgdt_mesh_create_with_allocator(NULL, NULL, NULL, &m), MGDT_OK);
    for (k = 0; k < sizeof all / sizeof *all; ++k) {
        CHECK_EQUAL(mgdt_mesh_get_option(m, all[k].key, &value), MGDT_OK);
        CHECK_EQUAL(value, all[k].first);
        CHECK_EQUAL(mgdt_mesh_set_option(m, all[k].key, -1), MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_mesh_set_option(m, all[k].key, all[k].most + 1),
                    MGDT_ERR_INVALID_ARGUMENT);
        set(m, all[k].key, all[k].most);
        CHECK_EQUAL(mgdt_mesh_get_option(m, all[k].key, &value), MGDT_OK);
        CHECK_EQUAL(value, all[k].most);
    }
    mgdt_mesh_destroy(m);
}

/* The arrays that describe an improvement agree with each other and with the mesh. */
static void report(const mgdt_mesh* m, int64_t tetrahedra_before) {
    const int64_t n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    int64_t* const histogram = array_of(m, MGDT_MESH_ARRAY_ANGLE_HISTOGRAM);
    int64_t* const below = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA_BELOW);
    int64_t* const reasons = array_of(m, MGDT_MESH_ARRAY_REASONS);
    double* const shapes = doubles_of(m, MGDT_MESH_ARRAY_SHAPES);
    int64_t sums[2] = {0, 0}, left = 0, i;
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_ANGLE_HISTOGRAM), 36);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_TETRAHEDRA_BELOW), 12);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_SHAPES), 6);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REASONS), n);
    for (i = 0; i < 36; ++i) sums[i % 2] += histogram[i];
    CHECK_EQUAL(sums[0], 6 * tetrahedra_before);
    CHECK_EQUAL(sums[1], 6 * n);
    CHECK(fabs(shapes[1] - least_angle(m) * 180 / 3.14159265358979) < 1e-9);
    CHECK(shapes[0] <= shapes[1]);
    CHECK(shapes[2] < 180 && shapes[3] < 180 && shapes[3] > 60);
    CHECK(shapes[4] > 0 && shapes[4] < shapes[5] && shapes[5] < 1);
    /* Tetrahedra with an angle below 5 i + 5 degrees. */
    for (i = 0; i < 6; ++i) CHECK_EQUAL(below[2 * i + 1] > 0, shapes[1] < 5 * (double)i + 5 - 1e-9);
    for (i = 0; i < n; ++i) left += reasons[i] != MGDT_REASON_NONE ? 1 : 0;
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL), left);
    free(histogram);
    free(below);
    free(reasons);
    free(shapes);
}

static int is_on_surface(int64_t p) {
    int k;
    int is = 0;
    for (k = 0; k < 3; ++k) {
        const double x = lattice_points[3 * p + k];
        is |= x == 0 || x == side || (k == 2 && x == side / 2);
    }
    return is;
}

/* The mesh reaches the goal; what may not move does not, and a second call changes nothing. */
static void improve(int64_t boundary, int64_t points) {
    static const int64_t fixed[2] = {31, 62};
    mgdt_mesh* const m = lattice_mesh();
    mgdt_mesh* const other = lattice_mesh();
    const double before = least_angle(m);
    double* xyz;
    int64_t i, k, moved = 0;
    mgdt_mesh* both[2];
    both[0] = m;
    both[1] = other;
    for (i = 0; i < 2; ++i) {
        set(both[i], MGDT_MESH_OPTION_BOUNDARY, boundary);
        set(both[i], MGDT_MESH_OPTION_POINTS, points);
        set(both[i], MGDT_MESH_OPTION_THREADS, 1 + 3 * i);
        CHECK_EQUAL(mgdt_mesh_set_fixed_points(both[i], 2, fixed), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_improve(both[i]), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(both[i]), MGDT_OK);
        report(both[i], n_tetrahedra);
    }
    CHECK(are_same(m, other));
    CHECK(least_angle(m) > before);
    if (points != MGDT_POINTS_KEEP) CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_REGIONS), 2);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_POINTS) - stat_of(m, MGDT_MESH_STAT_STEINER_POINTS),
                n_points);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS),
                stat_of(m, MGDT_MESH_STAT_REMOVED_POINTS));
    if (points != MGDT_POINTS_REMOVE) CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS), 0);
    xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
    for (i = 0; i < n_points; ++i) {
        const int is_fixed = points == MGDT_POINTS_KEEP || i == fixed[0] || i == fixed[1] ||
                             (boundary == MGDT_BOUNDARY_FIXED && is_on_surface(i));
        int moves = 0;
        for (k = 0; k < 3; ++k) {
            const double x = lattice_points[3 * i + k];
            moves |= xyz[3 * i + k] != x;
            if (x == 0 || x == side || (k == 2 && x == side / 2))
                CHECK(fabs(xyz[3 * i + k] - x) < 1e-13);
        }
        moved += moves;
        if (is_fixed) CHECK(!moves);
    }
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MOVED_POINTS), moved);
    free(xyz);
    if (points == MGDT_POINTS_MOVE) {
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MOVED_POINTS), 0);
        report(other, n_tetrahedra);
        CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_TETRAHEDRA),
                    size_of(other, MGDT_MESH_ARRAY_TETRAHEDRA));
        xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
        {
            double* const same = doubles_of(other, MGDT_MESH_ARRAY_POINTS);
            CHECK(memcmp(xyz, same, (size_t)size_of(m, MGDT_MESH_ARRAY_POINTS) * sizeof *xyz) == 0);
            free(same);
        }
        free(xyz);
    }
    mgdt_mesh_destroy(m);
    mgdt_mesh_destroy(other);
}

/* A goal that no mesh reaches leaves reasons; the worst tetrahedron is no worse. */
static void unreachable_goal(void) {
    mgdt_mesh* const m = lattice_mesh();
    const double before = least_angle(m);
    set(m, MGDT_MESH_OPTION_GOAL, 65);
    set(m, MGDT_MESH_OPTION_MOST_PASSES, 5);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK(least_angle(m) >= before);
    CHECK(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL) > 0);
    CHECK(stat_of(m, MGDT_MESH_STAT_PASSES) > 0);
    report(m, n_tetrahedra);
    mgdt_mesh_destroy(m);
}

static struct {
    mgdt_mesh* mesh;
    double last;
    int reports, most;
} watched;

static int32_t watch(double fraction, void* user) {
    CHECK(user == &watched);
    CHECK(fraction >= watched.last && fraction <= 1);
    watched.last = fraction;
    return ++watched.reports > watched.most;
}

/* Wherever it is cancelled, an improvement leaves a valid mesh that is no worse. */
static void cancel(void) {
    int is_finished = 0, most;
    for (most = 0; most < 400 && !is_finished; most += 1 + most / 4) {
        mgdt_mesh* const m = lattice_mesh();
        const double before = least_angle(m);
        mgdt_status status;
        watched.mesh = m;
        watched.last = 0;
        watched.reports = 0;
        watched.most = most;
        CHECK_EQUAL(mgdt_mesh_set_progress(m, watch, &watched), MGDT_OK);
        set(m, MGDT_MESH_OPTION_GOAL, 40);
        set(m, MGDT_MESH_OPTION_MOST_PASSES, 4);
        status = mgdt_mesh_improve(m);
        is_finished = status == MGDT_OK;
        if (!is_finished) {
            CHECK_EQUAL(status, MGDT_ERR_CANCELLED);
            check_message(m, "cancelled");
        }
        CHECK_EQUAL(mgdt_mesh_set_progress(m, NULL, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
        CHECK(least_angle(m) >= before);
        mgdt_mesh_destroy(m);
    }
    CHECK(is_finished);
    CHECK(watched.last == 1);
    {
        mgdt_mesh* const m = lattice_mesh();
        CHECK_EQUAL(mgdt_mesh_cancel(m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        mgdt_mesh_destroy(m);
    }
}

/* The mesh of a domain keeps the points of the domain, and is Delaunay no more. */
static void domain_mesh(void) {
    /* The four points around the middle are the corners of a flat tetrahedron. */
    static const double solid[6 * 3] = {20, 0,   1,  -20, 0, 1,  0, 20, -1,
                                        0,  -20, -1, 0,   0, 30, 0, 0,  -30};
    static const int64_t triangles[8 * 3] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                             2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    mgdt_domain* d = NULL;
    mgdt_mesh* m = NULL;
    char message[256];
    int64_t value = -1;
    double* xyz;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, 6, solid), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 8, NULL, triangles, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_option(m, MGDT_MESH_OPTION_POINTS, &value), MGDT_OK);
    CHECK_EQUAL(value, MGDT_POINTS_KEEP);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_IS_OF_DOMAIN), 1);
    set(m, MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_SLIDE);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_IS_DELAUNAY), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_IS_OF_DOMAIN), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MOVED_POINTS), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_get_error(d, sizeof message, message), MGDT_OK);
    CHECK(strstr(message, "has been improved") != NULL);
    xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
    CHECK(memcmp(xyz, solid, sizeof solid) == 0);
    free(xyz);
    mgdt_mesh_destroy(m);
    mgdt_domain_destroy(d);
}

/* One tetrahedron, flat but for its last bits, cannot change, whatever is allowed. */
static void one_tetrahedron(void) {
    static const double sliver[12] = {0, 0, 0, 1, 0, 1e-9, 1, 1, 0, 0, 1, 1e-9};
    static const int64_t corners[4] = {0, 1, 2, 3};
    int64_t boundary, points;
    for (boundary = 0; boundary < 2; ++boundary)
        for (points = 0; points < 3; ++points) {
            mgdt_mesh* const m = mesh_of(4, sliver, 1, corners, NULL);
            const double before = least_angle(m);
            double* xyz;
            set(m, MGDT_MESH_OPTION_BOUNDARY, boundary);
            set(m, MGDT_MESH_OPTION_POINTS, points);
            set(m, MGDT_MESH_OPTION_MEAN_PASSES, 2);
            CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
            CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
            CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 1);
            CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL), 1);
            CHECK(least_angle(m) == before);
            xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
            CHECK(memcmp(xyz, sliver, sizeof sliver) == 0);
            free(xyz);
            mgdt_mesh_destroy(m);
        }
}

/* The same lattice far from the origin, very large and very small. */
static void far_and_scaled(void) {
    /* Of subnormal coordinates the last one is too coarse for any move: that mesh stays. */
    static const double shift[6] = {1e9, -1e9, 0, 0, 0, 0},
                        scale[6] = {1, 1, 1e-150, 1e150, 1e305, 1e-315};
    static double xyz[3 * n_points];
    size_t k;
    int i;
    for (k = 0; k < sizeof shift / sizeof *shift; ++k) {
        mgdt_mesh* m;
        double before;
        for (i = 0; i < 3 * n_points; ++i) xyz[i] = scale[k] * lattice_points[i] + shift[k];
        m = mesh_of(n_points, xyz, n_tetrahedra, lattice, lattice_markers);
        before = least_angle(m);
        set(m, MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_SLIDE);
        set(m, MGDT_MESH_OPTION_POINTS, MGDT_POINTS_REMOVE);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
        CHECK(scale[k] < 1e-300 ? least_angle(m) == before : least_angle(m) > before);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL) > 0, scale[k] < 1e-300);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_REGIONS), 2);
        mgdt_mesh_destroy(m);
    }
}

/* Faces and edges inside of the mesh, which end nowhere at its surface, stay where they are: their
 * areas and lengths are the same. */
static void dangling_items(void) {
    enum { first = 37 };
    static const int32_t face_marker[2] = {4, 4}, edge_marker[1] = {8};
    int64_t faces[6], edges[2], boundary;
    /* Points of the middle layer, which is a plane: a square of two faces; and an edge beside it.
     */
    const int64_t base = 2 * (side + 1) * (side + 1) + (side + 1) + 1;
    faces[0] = base;
    faces[1] = base + 1;
    faces[2] = base + side + 2;
    faces[3] = base;
    faces[4] = base + side + 1;
    faces[5] = base + side + 2;
    edges[0] = first;
    edges[1] = first + 1;
    for (boundary = 0; boundary < 2; ++boundary) {
        mgdt_mesh* m = NULL;
        double area = 0, length = 0, before, *xyz;
        int64_t *v, *found, i, n, k;
        CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_points(m, n_points, lattice_points), MGDT_OK);
        /* Without markers of tetrahedra, nothing else divides the mesh. */
        CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, n_tetrahedra, lattice, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_faces(m, 2, faces, face_marker), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_edges(m, 1, edges, edge_marker), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
        before = least_angle(m);
        set(m, MGDT_MESH_OPTION_GOAL, 28);
        set(m, MGDT_MESH_OPTION_BOUNDARY, boundary);
        set(m, MGDT_MESH_OPTION_POINTS, MGDT_POINTS_REMOVE);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
        CHECK(least_angle(m) > before);
        xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
        v = array_of(m, MGDT_MESH_ARRAY_FACES);
        found = array_of(m, MGDT_MESH_ARRAY_FACE_MARKERS);
        n = size_of(m, MGDT_MESH_ARRAY_FACE_MARKERS);
        for (i = 0; i < n; ++i) {
            double e[2][3];
            if (found[i] != 4) continue;
            for (k = 0; k < 3; ++k) {
                e[0][k] = xyz[3 * v[3 * i + 1] + k] - xyz[3 * v[3 * i] + k];
                e[1][k] = xyz[3 * v[3 * i + 2] + k] - xyz[3 * v[3 * i] + k];
            }
            CHECK(fabs(e[0][2]) < 1e-13 && fabs(e[1][2]) < 1e-13);
            area += fabs(e[0][0] * e[1][1] - e[0][1] * e[1][0]);
        }
        free(found);
        free(v);
        v = array_of(m, MGDT_MESH_ARRAY_EDGES);
        found = array_of(m, MGDT_MESH_ARRAY_EDGE_MARKERS);
        n = size_of(m, MGDT_MESH_ARRAY_EDGE_MARKERS);
        for (i = 0; i < n; ++i) {
            double square = 0;
            if (found[i] != 8) continue;
            for (k = 0; k < 3; ++k)
                square += pow(xyz[3 * v[2 * i] + k] - xyz[3 * v[2 * i + 1] + k], 2);
            length += sqrt(square);
        }
        free(found);
        free(v);
        free(xyz);
        {
            const double *const p = lattice_points + 3 * base, *const q = p + 3,
                                *const r = q + 3 * (side + 1), *const s = p + 3 * (side + 1),
                                *const a = lattice_points + 3 * first;
            const double given =
                fabs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) +
                fabs((s[0] - p[0]) * (r[1] - p[1]) - (s[1] - p[1]) * (r[0] - p[0]));
            CHECK(fabs(area - given) < 1e-12);
            CHECK(fabs(length - sqrt(pow(a[3] - a[0], 2) + pow(a[4] - a[1], 2) +
                                     pow(a[5] - a[2], 2))) < 1e-12);
        }
        mgdt_mesh_destroy(m);
    }
}

/* Two columns of cubes that have nothing in common but one edge of each cube. The points of these
 * edges have tetrahedra in both columns, and stay. */
static void touching_solids(void) {
    static const double heights[4] = {0, .05, .1, 1};
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                     {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    double xyz[28 * 3];
    int64_t corners[36 * 4], points, boundary;
    int i, j, k, l, step, t = 0;
    /* Seven points in each layer; the corner that both squares have is the first one. */
    static const double flat[7][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {-1, 0}, {0, -1}, {-1, -1}};
    static const int squares[2][4] = {{0, 1, 2, 3}, {6, 5, 4, 0}};
    for (i = 0; i < 28; ++i) {
        xyz[3 * i] = flat[i % 7][0];
        xyz[3 * i + 1] = flat[i % 7][1];
        xyz[3 * i + 2] = heights[i / 7];
    }
    for (k = 0; k < 3; ++k)
        for (l = 0; l < 2; ++l)
            for (j = 0; j < 6; ++j, ++t) {
                int at[3] = {0, 0, 0};
                for (step = 0; step < 4; ++step) {
                    corners[4 * t + step] = 7 * (k + at[2]) + squares[l][at[0] + 2 * at[1]];
                    if (step < 3) at[orders[j][step]] = 1;
                }
            }
    for (boundary = 0; boundary < 2; ++boundary)
        for (points = 0; points < 3; ++points) {
            mgdt_mesh* const m = mesh_of(28, xyz, 36, corners, NULL);
            double *volumes, sum = 0;
            int64_t n;
            CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
            set(m, MGDT_MESH_OPTION_BOUNDARY, boundary);
            set(m, MGDT_MESH_OPTION_POINTS, points);
            set(m, MGDT_MESH_OPTION_GOAL, 30);
            CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
            CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
            n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
            volumes = malloc((size_t)n * sizeof *volumes);
            CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, n, volumes),
                        MGDT_OK);
            while (n > 0) sum += volumes[--n];
            CHECK(fabs(sum - 2) < 1e-12);
            free(volumes);
            mgdt_mesh_destroy(m);
        }
}

/* A point of no tetrahedron has no influence, however far away it is. */
static void far_point(void) {
    static double xyz[3 * (n_points + 1)];
    mgdt_mesh* const near = mesh_of(n_points, lattice_points, n_tetrahedra, lattice, NULL);
    mgdt_mesh* far;
    double *a, *b;
    memcpy(xyz, lattice_points, sizeof lattice_points);
    xyz[3 * n_points] = xyz[3 * n_points + 1] = xyz[3 * n_points + 2] = -1e300;
    far = mesh_of(n_points + 1, xyz, n_tetrahedra, lattice, NULL);
    set(near, MGDT_MESH_OPTION_POINTS, MGDT_POINTS_MOVE);
    set(far, MGDT_MESH_OPTION_POINTS, MGDT_POINTS_MOVE);
    set(near, MGDT_MESH_OPTION_GOAL, 35);
    set(far, MGDT_MESH_OPTION_GOAL, 35);
    CHECK_EQUAL(mgdt_mesh_improve(near), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_improve(far), MGDT_OK);
    CHECK(stat_of(near, MGDT_MESH_STAT_MOVED_POINTS) > 0);
    CHECK_EQUAL(stat_of(near, MGDT_MESH_STAT_MOVED_POINTS),
                stat_of(far, MGDT_MESH_STAT_MOVED_POINTS));
    a = doubles_of(near, MGDT_MESH_ARRAY_POINTS);
    b = doubles_of(far, MGDT_MESH_ARRAY_POINTS);
    CHECK(memcmp(a, b, sizeof lattice_points) == 0);
    CHECK(b[3 * n_points] == -1e300);
    {
        static const double outside[6] = {-1, 2.25, 1.75, 2.5, 1.5, 9};
        int64_t at[2][2];
        double weights[2][8];
        CHECK_EQUAL(
            mgdt_mesh_locate_points(near, MGDT_OUTSIDE_BOUNDARY, 2, outside, at[0], weights[0]),
            MGDT_OK);
        CHECK_EQUAL(
            mgdt_mesh_locate_points(far, MGDT_OUTSIDE_BOUNDARY, 2, outside, at[1], weights[1]),
            MGDT_OK);
        CHECK(memcmp(at[0], at[1], sizeof at[0]) == 0);
        CHECK(memcmp(weights[0], weights[1], sizeof weights[0]) == 0);
    }
    free(a);
    free(b);
    mgdt_mesh_destroy(near);
    mgdt_mesh_destroy(far);
}

/* Points that are equal stay equal; if one of them is fixed, so are all. */
static void equal_points(void) {
    static const double box[10 * 3] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0,  1,  0,   0,  0,  1,
                                       1, 0, 1, 1, 1, 1, 0, 1, 1, .4, .5, .02, .4, .5, .02};
    static const int64_t sides[12 * 3] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                          2, 3, 7, 2, 7, 6, 0, 4, 7, 0, 7, 3, 1, 2, 6, 1, 6, 5};
    static const int64_t last[1] = {9};
    int fixes;
    for (fixes = 0; fixes < 2; ++fixes) {
        mgdt_domain* d = NULL;
        mgdt_mesh* m = NULL;
        double* xyz;
        int64_t offsets[13], i;
        for (i = 0; i < 13; ++i) offsets[i] = 3 * i;
        CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 10, box), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 12, offsets, sides, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
        set(m, MGDT_MESH_OPTION_POINTS, MGDT_POINTS_MOVE);
        if (fixes) CHECK_EQUAL(mgdt_mesh_set_fixed_points(m, 1, last), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
        CHECK(memcmp(xyz + 24, xyz + 27, 3 * sizeof *xyz) == 0);
        CHECK_EQUAL(memcmp(xyz + 24, box + 24, 3 * sizeof *xyz) == 0, fixes);
        free(xyz);
        mgdt_mesh_destroy(m);
        mgdt_domain_destroy(d);
    }
}

/* With the goal 0, moves serve the mean, and the worst tetrahedron becomes no worse. */
static void mean_alone(void) {
    mgdt_mesh* const m = lattice_mesh();
    const double before = least_angle(m);
    double* shapes;
    set(m, MGDT_MESH_OPTION_GOAL, 0);
    set(m, MGDT_MESH_OPTION_MEAN_PASSES, 30);
    set(m, MGDT_MESH_OPTION_POINTS, MGDT_POINTS_MOVE);
    set(m, MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_SLIDE);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK(least_angle(m) >= before);
    shapes = doubles_of(m, MGDT_MESH_ARRAY_SHAPES);
    CHECK(shapes[5] > shapes[4]);
    free(shapes);
    mgdt_mesh_destroy(m);
}

/* A flat roof of three faces is no small angle of the input, although the angle below it is. */
static void flat_roof(void) {
    static const double xyz[15] = {0, 0, 0, 1, 0, 0, .5, .87, 0, .5, .29, .05, 30, .29, -.5};
    static const int64_t corners[8] = {0, 1, 2, 3, 0, 2, 1, 4};
    mgdt_mesh* const m = mesh_of(5, xyz, 2, corners, NULL);
    int64_t* reasons;
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    reasons = array_of(m, MGDT_MESH_ARRAY_REASONS);
    CHECK(reasons[0] != MGDT_REASON_NONE && reasons[0] != MGDT_REASON_INPUT_ANGLE);
    free(reasons);
    mgdt_mesh_destroy(m);
}

/* An improvement that needs more memory than allowed changes nothing. */
static void memory_limit(void) {
    mgdt_mesh* const m = lattice_mesh();
    mgdt_mesh* const other = lattice_mesh();
    const int64_t bytes = stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES);
    int64_t more;
    for (more = 0; more < 99 * bytes; more += bytes / 4) {
        mgdt_status status;
        set(m, MGDT_MESH_OPTION_MEMORY_LIMIT, bytes + more);
        status = mgdt_mesh_improve(m);
        if (status == MGDT_OK) break;
        CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES), bytes);
        CHECK(are_same(m, other));
    }
    CHECK(more > 0);
    CHECK_EQUAL(mgdt_mesh_improve(other), MGDT_OK);
    CHECK(are_same(m, other));
    mgdt_mesh_destroy(m);
    mgdt_mesh_destroy(other);
}

void test_improvement(void) {
    int64_t boundary, points;
    make_lattice();
    options();
    for (boundary = 0; boundary < 2; ++boundary)
        for (points = 0; points < 3; ++points) improve(boundary, points);
    unreachable_goal();
    cancel();
    domain_mesh();
    one_tetrahedron();
    far_and_scaled();
    dangling_items();
    touching_solids();
    far_point();
    equal_points();
    mean_alone();
    flat_roof();
    memory_limit();
}
