/* SPDX-License-Identifier: MIT
 * The long calls that read a handle: each reports its progress and can be cancelled. */
#include <mgdt/mgdt_domain.h>
#include <mgdt/mgdt_mesh.h>
#include <mgdt/mgdt_parts.h>
#include <mgdt/mgdt_periodic.h>
#include <mgdt/mgdt_voronoi.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"

typedef struct {
    int64_t calls, stop_at; /* the report that asks to stop; 0 for none */
    int is_in_order;
    double last;
} watch;

static int32_t report(double fraction, void* user) {
    watch* const w = user;
    ++w->calls;
    w->is_in_order &= fraction >= w->last && fraction <= 1;
    w->last = fraction;
    return w->calls == w->stop_at;
}

/* What each kind of handle has. */
#define HANDLE(of, type, prefix)                                  \
    static mgdt_status set_##of(void* handle, watch* w) {         \
        mgdt_progress_fn const fn = w != NULL ? report : NULL;    \
        return mgdt_##prefix##set_progress((type*)handle, fn, w); \
    }                                                             \
    static mgdt_status cancel_##of(void* handle) {                \
        return mgdt_##prefix##cancel((type*)handle);              \
    }
HANDLE(triangulation, mgdt_triangulation, )
HANDLE(domain, mgdt_domain, domain_)
HANDLE(mesh, mgdt_mesh, mesh_)
HANDLE(box, mgdt_periodic, periodic_)
HANDLE(parts, mgdt_parts, parts_)

enum { n = 1200 };
static double* xyz;
static double results[200 * n]; /* room for what any of the calls writes */
static int64_t integers[100 * n];
static mgdt_mesh* mesh;

static mgdt_status check(void* t) {
    return mgdt_check(t, MGDT_CHECK_CANONICAL);
}
static mgdt_status volumes(void* t) {
    return mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, n, results);
}
static mgdt_status centroids(void* t) {
    return mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 0, NULL, 3 * n, results);
}
static mgdt_status diagram(void* t) {
    /* The faces of a cube that cuts cells. */
    static const double planes[6 * 4] = {1, 0,  0, 1, -1, 0, 0, 0, 0, 1, 0,  1,
                                         0, -1, 0, 0, 0,  0, 1, 1, 0, 0, -1, 0};
    mgdt_voronoi* v = NULL;
    const mgdt_status status = mgdt_voronoi_create(t, 6, planes, &v);
    CHECK((v != NULL) == (status == MGDT_OK));
    mgdt_voronoi_destroy(v);
    return status;
}
static mgdt_status ratios(void* t) {
    return mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_RADIUS_RATIO, 20 * n, results);
}
static mgdt_status centers(void* t) {
    return mgdt_get_circumcenters(t, 20 * n, results, results + 60 * n);
}
static mgdt_status alphas_of_edges(void* t) {
    return mgdt_get_alphas(t, 1, 20 * n, results);
}
static mgdt_status alphas_of_facets(void* t) {
    return mgdt_get_alphas(t, 2, 100 * n, results);
}
static mgdt_status alphas(void* t) {
    return mgdt_get_alphas(t, 3, 20 * n, results);
}
static mgdt_status alpha_surface(void* t) {
    int64_t count;
    return mgdt_get_alpha_surface(t, .01, 30 * n, integers, &count);
}
static mgdt_status solid_alpha(void* t) {
    return mgdt_get_solid_alpha(t, results);
}
static mgdt_status gabriel(void* t) {
    int64_t count;
    return mgdt_get_gabriel_edges(t, 30 * n, integers, &count);
}
static mgdt_status spanning_tree(void* t) {
    int64_t count;
    return mgdt_get_spanning_tree(t, 30 * n, integers, &count);
}
static mgdt_status interpolate(void* t) {
    return mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_NONE, 1, xyz, n, xyz + 1,
                            results);
}
static mgdt_status weights(void* t) {
    return mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NONE, n, xyz + 1,
                                          n + 1, integers, 60 * n, integers + 2 * n, results);
}
static mgdt_status gradients(void* t) {
    return mgdt_get_gradients(t, 1, xyz, results);
}
static mgdt_status locate(void* t) {
    return mgdt_locate_points(t, n, xyz, integers, results);
}
static mgdt_status nearest(void* t) {
    return mgdt_nearest_vertices(t, n, xyz, integers);
}
static mgdt_status validate(void* d) {
    return mgdt_domain_validate(d);
}
static mgdt_status clean(void* d) {
    return mgdt_domain_clean(d);
}
static mgdt_status compare(void* d) {
    return mgdt_domain_check(d, mesh);
}
static mgdt_status check_mesh(void* m) {
    return mgdt_mesh_check(m);
}
static mgdt_status measure_mesh(void* m) {
    return mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, 20 * n, results);
}
static mgdt_status check_box(void* p) {
    return mgdt_periodic_check(p);
}
static mgdt_status measure_box(void* p) {
    return mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, n, results);
}
static mgdt_status diagram_of_box(void* p) {
    mgdt_voronoi* v = NULL;
    const mgdt_status status = mgdt_periodic_create_voronoi(p, &v);
    CHECK((v != NULL) == (status == MGDT_OK));
    mgdt_voronoi_destroy(v);
    return status;
}
static mgdt_status check_parts(void* p) {
    return mgdt_parts_check(p, MGDT_CHECK_CANONICAL);
}

typedef struct {
    const char* name;
    mgdt_status (*run)(void*);
} call;

/* Stops each call at some of its reports, and by a request that is made before it. */
static void try_calls(void* handle, const call* calls, size_t count,
                      mgdt_status (*set)(void*, watch*), mgdt_status (*cancel)(void*)) {
    size_t i;
    for (i = 0; i < count; ++i) {
        watch w = {0, 0, 1, 0};
        int64_t reports, k;
        int is_right;
        CHECK_EQUAL(set(handle, &w), MGDT_OK);
        is_right = CHECK_EQUAL(calls[i].run(handle), MGDT_OK);
        is_right &= CHECK(w.is_in_order && w.last == 1);
        is_right &= CHECK(w.calls >= 2 && w.calls <= 150);
        reports = w.calls;
        for (k = 0; k < 4; ++k) {
            /* The last report comes too late. */
            const int64_t stop_at[4] = {1, (reports + 1) / 2, reports - 1, reports};
            const mgdt_status expected = k < 3 ? MGDT_ERR_CANCELLED : MGDT_OK;
            w.calls = 0;
            w.last = 0;
            w.stop_at = stop_at[k];
            is_right &= CHECK_EQUAL(calls[i].run(handle), expected);
            is_right &= CHECK_EQUAL(w.calls, stop_at[k]);
        }
        CHECK_EQUAL(set(handle, NULL), MGDT_OK);
        CHECK_EQUAL(cancel(handle), MGDT_OK);
        is_right &= CHECK_EQUAL(calls[i].run(handle), MGDT_ERR_CANCELLED);
        is_right &= CHECK_EQUAL(calls[i].run(handle), MGDT_OK);
        if (!is_right) printf("in the call \"%s\", with %d reports\n", calls[i].name, (int)reports);
    }
}
#define TRY(handle, calls, of) \
    try_calls(handle, calls, sizeof(calls) / sizeof *(calls), set_##of, cancel_##of)

static void of_triangulations(void) {
    static const call calls[] = {{"check", check},
                                 {"volumes", volumes},
                                 {"centroids", centroids},
                                 {"diagram", diagram},
                                 {"ratios", ratios},
                                 {"circumcentres", centers},
                                 {"alphas of edges", alphas_of_edges},
                                 {"alphas of facets", alphas_of_facets},
                                 {"alphas", alphas},
                                 {"alpha surface", alpha_surface},
                                 {"solid alpha", solid_alpha},
                                 {"Gabriel graph", gabriel},
                                 {"spanning tree", spanning_tree},
                                 {"interpolation", interpolate},
                                 {"weights", weights},
                                 {"gradients", gradients},
                                 {"location", locate},
                                 {"nearest vertices", nearest}};
    mgdt_triangulation* const t = make(n, xyz);
    double before[n], after[n];
    int64_t i;
    int32_t threads;
    CHECK_EQUAL(mgdt_set_read_progress(t, 1), MGDT_OK);
    for (threads = 1; threads <= 3; threads += 2) {
        CHECK_EQUAL(mgdt_set_threads(t, threads), MGDT_OK);
        TRY(t, calls, triangulation);
    }
    /* Unless they are set to, calls that read report nothing and leave a request to the next
     * insertion or diagram. */
    {
        watch w = {0, 0, 1, 0};
        CHECK_EQUAL(mgdt_set_read_progress(t, 0), MGDT_OK);
        CHECK_EQUAL(mgdt_set_progress(t, report, &w), MGDT_OK);
        CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
        for (i = 0; i < (int64_t)(sizeof calls / sizeof calls[0]); ++i)
            if (calls[i].run != diagram) CHECK_EQUAL(calls[i].run(t), MGDT_OK);
        CHECK_EQUAL(w.calls, 0);
        CHECK_EQUAL(diagram(t), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(diagram(t), MGDT_OK);
        CHECK(w.calls > 1 && w.last == 1);
        CHECK_EQUAL(mgdt_set_progress(t, NULL, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_set_read_progress(t, 1), MGDT_OK);
    }
    /* A cancelled call leaves nothing behind. */
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, n, before), MGDT_OK);
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, n, after),
                MGDT_ERR_CANCELLED);
    CHECK_ERROR(t, "cancelled");
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, n, after), MGDT_OK);
    for (i = 0; i < n; ++i) CHECK(before[i] == after[i]);
    mgdt_destroy(t);
}

/* A cube with a triangulated grid on each side. */
static mgdt_domain* make_domain(void) {
    enum { side = 9, points = 6 * side * side, facets = 6 * (side - 1) * (side - 1) };
    double at[3 * points];
    int64_t corners[4 * facets], offsets[facets + 1], i, j, f;
    int64_t *to = corners, count = 0;
    mgdt_domain* d = NULL;
    offsets[0] = 0;
    for (f = 0; f < 6; ++f)
        for (i = 0; i < side; ++i)
            for (j = 0; j < side; ++j) {
                double* const x = at + 3 * ((f * side + i) * side + j);
                x[f % 3] = f < 3 ? 0 : side - 1;
                x[(f + 1) % 3] = (double)i;
                x[(f + 2) % 3] = (double)j;
                if (i + 1 == side || j + 1 == side) continue;
                *to++ = (f * side + i) * side + j;
                *to++ = (f * side + i) * side + j + 1;
                *to++ = (f * side + i + 1) * side + j + 1;
                *to++ = (f * side + i + 1) * side + j;
                offsets[++count] = to - corners;
            }
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, points, at), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, count, offsets, corners, NULL), MGDT_OK);
    return d;
}

static void of_domains(void) {
    static const call of_domain[] = {
        {"validation", validate}, {"comparison", compare}, {"cleaning", clean}};
    static const call of_mesh[] = {{"check of a mesh", check_mesh},
                                   {"measures of a mesh", measure_mesh}};
    mgdt_domain* const d = make_domain();
    CHECK_EQUAL(mgdt_domain_build(d, &mesh), MGDT_OK);
    TRY(d, of_domain, domain);
    mgdt_domain_destroy(d);
    TRY(mesh, of_mesh, mesh);
    mgdt_mesh_destroy(mesh);
}

static void of_boxes(void) {
    static const double vectors[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const call calls[] = {{"check of a box", check_box},
                                 {"measures of a box", measure_box},
                                 {"diagram of a box", diagram_of_box}};
    mgdt_periodic* p = NULL;
    CHECK_EQUAL(mgdt_periodic_create(&p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_set_vectors(p, 3, vectors), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, n, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    TRY(p, calls, box);
    mgdt_periodic_destroy(p);
}

/* Without the option a check reports nothing, and a request waits for the next build. */
static void expect_unwatched_check(mgdt_parts* p) {
    watch w = {0, 0, 1, 0};
    CHECK_EQUAL(mgdt_parts_set_progress(p, report, &w), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_cancel(p), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_check(p, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(w.calls, 0);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
}

static void of_parts(void) {
    static const call calls[] = {{"check of parts", check_parts}};
    mgdt_parts* p = NULL;
    CHECK_EQUAL(mgdt_parts_create(2, &p), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 0, n / 2, xyz, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_insert_points(p, 1, n / 2, xyz + 3 * (n / 2), NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_parts_build(p), MGDT_OK);
    expect_unwatched_check(p);
    CHECK_EQUAL(mgdt_parts_set_option(p, MGDT_PARTS_READ_PROGRESS, 1), MGDT_OK);
    TRY(p, calls, parts);
    mgdt_parts_destroy(p);
}

/* A progress function that uses its handle, and another one. */
typedef struct {
    mgdt_triangulation *t, *other;
    int64_t calls;
} guest;

static int32_t intrude(double fraction, void* user) {
    guest* const g = user;
    int64_t count, edge[2];
    (void)fraction;
    ++g->calls;
    CHECK_EQUAL(mgdt_check(g->t, MGDT_CHECK_CANONICAL), MGDT_ERR_BUSY);
    CHECK_ERROR(g->t, "mgdt_check() is refused: the handle is busy in mgdt_get_gabriel_edges()");
    CHECK_EQUAL(mgdt_get_tetrahedra(g->t, 1, &count), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_insert_points(g->t, 1, xyz), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_set_progress(g->t, NULL, NULL), MGDT_ERR_BUSY);
    mgdt_destroy(g->t);
    if (g->other != NULL) {
        guest inner = {NULL, NULL, 0};
        inner.t = g->other;
        CHECK_EQUAL(mgdt_set_progress(g->other, intrude, &inner), MGDT_OK);
        CHECK_EQUAL(mgdt_get_gabriel_edges(g->other, 1, edge, &count), MGDT_ERR_BUFFER_TOO_SMALL);
        CHECK(inner.calls > 1);
        CHECK_EQUAL(mgdt_check(g->t, MGDT_CHECK_CANONICAL), MGDT_ERR_BUSY);
    }
    return 0;
}

static void from_progress(void) {
    guest g = {NULL, NULL, 0};
    g.t = make(50, xyz);
    g.other = make(40, xyz);
    CHECK_EQUAL(mgdt_set_read_progress(g.t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_read_progress(g.other, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_progress(g.t, intrude, &g), MGDT_OK);
    CHECK_EQUAL(gabriel(g.t), MGDT_OK);
    CHECK(g.calls > 1);
    CHECK_EQUAL(mgdt_set_progress(g.t, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_check(g.t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_point_count(g.t), 50);
    mgdt_destroy(g.t);
    mgdt_destroy(g.other);
}

void test_long_calls(void) {
    xyz = random_points(n + 1, 0, 75);
    of_triangulations();
    of_domains();
    of_boxes();
    of_parts();
    from_progress();
    free(xyz);
}
