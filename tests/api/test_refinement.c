/* SPDX-License-Identifier: MIT
 * mgdt_mesh_refine() and the sizes that it takes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "mgdt/mgdt_mesh.h"

/* Two tetrahedra, each a region, and a point that neither of them uses. */
static mgdt_mesh* two_tetrahedra(void) {
    static const double xyz[18] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 4, 4, 4, 9, 9, 9};
    static const int32_t corners[8] = {0, 1, 2, 3, 1, 2, 3, 4}, markers[2] = {5, 6};
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_points(m, 6, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra_i32(m, 2, corners, markers), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
    return m;
}

static int64_t stat_of(const mgdt_mesh* m, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_mesh_get_stat(m, key, &value), MGDT_OK);
    return value;
}

static int64_t size_of(const mgdt_mesh* m, int32_t key) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_mesh_get_size(m, key, &size), MGDT_OK);
    return size;
}

static void check_message(const mgdt_mesh* m, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_mesh_get_error(m, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    CHECK(strstr(message, text) != NULL);
}

/* How many tetrahedra a region has. */
static int64_t count_in(const mgdt_mesh* m, int64_t region) {
    const int64_t n = size_of(m, MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS);
    int64_t* const regions = malloc((size_t)n * sizeof *regions);
    int64_t count = 0, t;
    CHECK_EQUAL(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS, n, regions), MGDT_OK);
    for (t = 0; t < n; ++t) count += regions[t] == region;
    free(regions);
    return count;
}

static void options(void) {
    static const struct {
        int32_t key;
        double at_first;
    } doubles[4] = {{MGDT_MESH_OPTION_SIZE, 0},
                    {MGDT_MESH_OPTION_GRADATION, 0.3},
                    {MGDT_MESH_OPTION_RADIUS_EDGE, 1.4},
                    {MGDT_MESH_OPTION_VOLUME, 0}};
    mgdt_mesh* const m = two_tetrahedra();
    int64_t value = -1;
    double x = -1;
    int k;
    for (k = 0; k < 4; ++k) {
        CHECK_EQUAL(mgdt_mesh_get_double_option(m, doubles[k].key, &x), MGDT_OK);
        CHECK(x == doubles[k].at_first);
        CHECK_EQUAL(mgdt_mesh_set_double_option(m, doubles[k].key, 0.75), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_double_option(m, doubles[k].key, -1), MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_mesh_set_double_option(m, doubles[k].key, nan("")),
                    MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_mesh_set_double_option(m, doubles[k].key, HUGE_VAL),
                    MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_mesh_get_double_option(m, doubles[k].key, &x), MGDT_OK);
        CHECK(x == 0.75);
        CHECK_EQUAL(mgdt_mesh_get_double_option(m, doubles[k].key, NULL), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_mesh_set_option(m, doubles[k].key, 1), MGDT_ERR_UNKNOWN_KEY);
        CHECK_EQUAL(mgdt_mesh_get_option(m, doubles[k].key, &value), MGDT_ERR_UNKNOWN_KEY);
    }
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_GOAL, 1), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_set_double_option(NULL, MGDT_MESH_OPTION_SIZE, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_double_option(NULL, MGDT_MESH_OPTION_SIZE, &x),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MOST_POINTS, -1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_SIZES_OF_SURFACE, 2),
                MGDT_ERR_INVALID_ARGUMENT);
    mgdt_mesh_destroy(m);
}

static void sizes(void) {
    static const int64_t counts[3] = {6, 2, 2};
    mgdt_mesh* const m = two_tetrahedra();
    double x[6] = {1, 1, 1, 1, 1, 1};
    int32_t of;
    for (of = MGDT_SIZES_OF_POINTS; of <= MGDT_SIZES_OF_REGIONS; ++of) {
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, counts[of] + 1, x), MGDT_ERR_INVALID_ARGUMENT);
        check_message(m,
                      of == 0 ? "7 sizes of points, of which there are 6" : "of which there are 2");
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, -1, x), MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, counts[of], NULL), MGDT_ERR_NULL_POINTER);
        x[1] = -1;
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, counts[of], x), MGDT_ERR_INVALID_ARGUMENT);
        check_message(m, "size 1 is -1");
        x[1] = nan("");
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, counts[of], x), MGDT_ERR_INVALID_ARGUMENT);
        x[1] = HUGE_VAL;
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, counts[of], x), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_sizes(m, of, 0, NULL), MGDT_OK);
        x[1] = 1;
    }
    CHECK_EQUAL(mgdt_mesh_set_sizes(m, 3, 2, x), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_set_sizes(m, -1, 2, x), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_set_sizes(NULL, 0, 2, x), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_refine(NULL), MGDT_ERR_NULL_POINTER);

    /* Sizes that were removed count no more: there is nothing to do but for the shapes. */
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_RADIUS_EDGE, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REFUSALS), 2);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_SIZES), 6);
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_SIZES, 6, x), MGDT_OK);
    for (of = 0; of < 6; ++of) CHECK(x[of] == 0);
    mgdt_mesh_destroy(m);
}

/* A size of one region alone: the other region follows by the gradation. */
static void regions(void) {
    static const double of_regions[2] = {0.5, 0};
    mgdt_mesh* const m = two_tetrahedra();
    int64_t in_first, in_second, n;
    CHECK_EQUAL(mgdt_mesh_set_sizes(m, MGDT_SIZES_OF_REGIONS, 2, of_regions), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_GRADATION, 3), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    in_first = count_in(m, 0);
    in_second = count_in(m, 1);
    CHECK(in_first > 20);
    CHECK_EQUAL(in_first + in_second, n);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REFUSALS), n);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_STEINER_POINTS),
                stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS));
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS), 1);
    /* The regions keep their sizes, and the mesh is within them. */
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK(stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS) <= n / 20);
    /* An improvement forgets what the refinement has said. */
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REFUSALS), 0);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_SIZES), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_REFUSED), 0);
    CHECK(size_of(m, MGDT_MESH_ARRAY_REASONS) > 0);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REASONS), 0);
    mgdt_mesh_destroy(m);
}

/* Sizes of 1e-300 and the like are refused; such points, and steps of 1e6, are not. */
static void hostile(void) {
    static const double corner[3] = {1e-300, 1e-6, 1e300};
    mgdt_mesh* m = two_tetrahedra();
    double x[6] = {0};
    int k;
    for (k = 0; k < 2; ++k) {
        CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_SIZE, corner[k]), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_ERR_TOO_LARGE);
        check_message(m, "the sizes would take about");
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
        CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REFUSALS), 0);
    }
    /* With a limit they are possible. */
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MOST_POINTS, 500), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS), 500);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);

    m = two_tetrahedra();
    CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MOST_POINTS, 2000), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_GRADATION, 9e5), MGDT_OK);
    x[0] = 1e-6;
    x[1] = 1;
    x[2] = 1e300;
    CHECK_EQUAL(mgdt_mesh_set_sizes(m, MGDT_SIZES_OF_POINTS, 6, x), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);
    /* Points that are far from 0, or very near to it. */
    for (k = 0; k < 3; ++k) {
        static const int32_t corners[4] = {0, 1, 2, 3};
        const double scale = k == 0 ? 1e-260 : k == 1 ? 1e290 : 1;
        double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        int i;
        for (i = 0; i < 12; ++i) xyz[i] = k == 2 ? 1e9 + xyz[i] : scale * xyz[i];
        CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_points(m, 4, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_tetrahedra_i32(m, 1, corners, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_SIZE, 0.1 * scale), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
        CHECK(stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS) > 3);
        CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
        mgdt_mesh_destroy(m);
    }
    /* A mesh without tetrahedra has nothing to refine. */
    CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_POINTS), 0);
    mgdt_mesh_destroy(m);
}

static int32_t stop_at_half(double fraction, void* user) {
    ++*(int*)user;
    return fraction > 0.2;
}

static void cancelling(void) {
    mgdt_mesh* const m = two_tetrahedra();
    int heard = 0;
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_SIZE, 0.15), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_progress(m, stop_at_half, &heard), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_ERR_CANCELLED);
    CHECK(heard > 1);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_SIZES), 0);
    CHECK_EQUAL(mgdt_mesh_set_progress(m, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_cancel(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);
}

static void memory_limits(void) {
    mgdt_mesh* const m = two_tetrahedra();
    int64_t limit, refused = 0;
    mgdt_status status = MGDT_ERR_OUT_OF_MEMORY;
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_SIZE, 0.3), MGDT_OK);
    for (limit = stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES); status == MGDT_ERR_OUT_OF_MEMORY;
         limit += limit / 5) {
        CHECK_EQUAL(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_MEMORY_LIMIT, limit), MGDT_OK);
        status = mgdt_mesh_refine(m);
        if (status != MGDT_ERR_OUT_OF_MEMORY) break;
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
        ++refused;
    }
    CHECK_EQUAL(status, MGDT_OK);
    CHECK(refused > 5);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);
}

/* Points in space with sizes, which need not be in the mesh. */
static void size_fields(void) {
    static const double xyz[15] = {0, 0, 0, 5, 0, 0, 0, 5, 0, 0, 0, 5, 0, 0, 1e30};
    double sizes_there[5] = {0.2, 0.3, 0.3, 0.3, 0.3}, x[3];
    mgdt_mesh* const m = two_tetrahedra();
    int64_t inserted;
    int k;
    CHECK_EQUAL(mgdt_mesh_set_double_option(m, MGDT_MESH_OPTION_GRADATION, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_size_field(NULL, 4, xyz, sizes_there), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_size_field(m, 4, NULL, sizes_there), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_size_field(m, 4, xyz, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_size_field(m, -1, xyz, sizes_there), MGDT_ERR_INVALID_ARGUMENT);
    for (k = 0; k < 4; ++k) {
        const double wrong[4] = {0, -1, HUGE_VAL, nan("")};
        sizes_there[2] = wrong[k];
        CHECK_EQUAL(mgdt_mesh_set_size_field(m, 4, xyz, sizes_there), MGDT_ERR_INVALID_ARGUMENT);
        check_message(m, "size 2 is");
    }
    sizes_there[2] = 0.3;
    memcpy(x, xyz, sizeof x);
    x[1] = nan("");
    CHECK_EQUAL(mgdt_mesh_set_size_field(m, 1, x, sizes_there), MGDT_ERR_NOT_FINITE);
    CHECK_EQUAL(mgdt_mesh_set_size_field(m, 4, xyz, sizes_there), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    inserted = stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS);
    CHECK(inserted > 20);
    CHECK_EQUAL(
        mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_SIZES, size_of(m, MGDT_MESH_ARRAY_SIZES), NULL),
        MGDT_ERR_NULL_POINTER);
    mgdt_mesh_destroy(m);

    /* One point, two, three in a plane, and one that is very far away. */
    for (k = 1; k <= 5; ++k) {
        mgdt_mesh* const other = two_tetrahedra();
        CHECK_EQUAL(mgdt_mesh_set_size_field(other, k, xyz, sizes_there), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_option(other, MGDT_MESH_OPTION_MOST_POINTS, 1000), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_refine(other), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(other), MGDT_OK);
        CHECK(stat_of(other, MGDT_MESH_STAT_INSERTED_POINTS) > 20);
        /* Without the field there are no sizes. */
        CHECK_EQUAL(mgdt_mesh_set_size_field(other, 0, NULL, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_refine(other), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_get_doubles(other, MGDT_MESH_ARRAY_SIZES, 1, x),
                    MGDT_ERR_BUFFER_TOO_SMALL);
        mgdt_mesh_destroy(other);
    }
}

/* What the size function does, and how often it was called. */
struct asked {
    mgdt_mesh* m;
    int64_t places;
    double wrong;
    int stops, calls;
};

static int32_t size_at(int64_t n, const double* xyz, double* to, void* user) {
    struct asked* const asked = user;
    int64_t i;
    CHECK(n > 0 && n <= 65536);
    for (i = 0; i < n; ++i) {
        CHECK(to[i] == 0);
        to[i] = asked->wrong != 0 && i == n / 2 ? asked->wrong : 0.2 + 0.2 * fabs(xyz[3 * i]);
    }
    asked->places += n;
    ++asked->calls;
    CHECK_EQUAL(mgdt_mesh_refine(asked->m), MGDT_ERR_BUSY);
    if (asked->stops == 2) CHECK_EQUAL(mgdt_mesh_cancel(asked->m), MGDT_OK);
    return asked->stops == 1;
}

static int32_t no_sizes(int64_t n, const double* xyz, double* to, void* user) {
    int64_t i;
    (void)xyz;
    (void)user;
    for (i = 0; i < n; ++i)
        if (i % 2 == 0) to[i] = HUGE_VAL;
    return 0;
}

static void size_functions(void) {
    static const double wrong[3] = {-1, -HUGE_VAL, 0};
    mgdt_mesh* const m = two_tetrahedra();
    struct asked asked = {NULL, 0, 0, 0, 0};
    mgdt_size_fn fn = no_sizes;
    void* user = &fn;
    int k;
    asked.m = m;
    CHECK_EQUAL(mgdt_mesh_get_size_function(m, &fn, &user), MGDT_OK);
    CHECK(fn == NULL && user == NULL);
    CHECK_EQUAL(mgdt_mesh_get_size_function(m, NULL, &user), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_get_size_function(NULL, &fn, &user), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_size_function(NULL, size_at, &asked), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_size_function(m, size_at, &asked), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_size_function(m, &fn, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_size_function(m, &fn, &user), MGDT_OK);
    CHECK(fn == size_at && user == &asked);
    for (k = 0; k < 3; ++k) {
        asked.wrong = k == 2 ? nan("") : wrong[k];
        CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_ERR_INVALID_ARGUMENT);
        check_message(m, "the size function gives");
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
    }
    asked.wrong = 0;
    for (asked.stops = 1; asked.stops <= 2; ++asked.stops) {
        CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
    }
    asked.stops = 0;
    asked.calls = 0;
    asked.places = 0;
    CHECK_EQUAL(mgdt_mesh_refine(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK(stat_of(m, MGDT_MESH_STAT_INSERTED_POINTS) > 100);
    CHECK(asked.calls > 2 && asked.places > 1000);
    mgdt_mesh_destroy(m);
    {
        mgdt_mesh* const other = two_tetrahedra();
        CHECK_EQUAL(mgdt_mesh_set_size_function(other, no_sizes, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_double_option(other, MGDT_MESH_OPTION_RADIUS_EDGE, 0), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_refine(other), MGDT_OK);
        CHECK_EQUAL(stat_of(other, MGDT_MESH_STAT_INSERTED_POINTS), 0);
        mgdt_mesh_destroy(other);
    }
}

void test_refinement(void) {
    options();
    sizes();
    regions();
    size_fields();
    size_functions();
    hostile();
    cancelling();
    memory_limits();
}
