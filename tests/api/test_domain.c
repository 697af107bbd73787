/* SPDX-License-Identifier: MIT
 * Domains, and the meshes that are built of them; test_mesh.c tests what a mesh does by itself. */
#include <stdlib.h>

#include "domain_box.h"

static void mesh_of_a_box(int64_t base) {
    mgdt_domain* const d = make_box(base);
    const double inside[3] = {2, 2, 3};
    const int32_t marker = 42;
    mgdt_mesh* m;
    int64_t *faces, *sides, *facets, *face_markers, *region_markers, *origins, *sources;
    double* xyz;
    int64_t i, n, inner = 0, given = 0;
    CHECK_EQUAL(mgdt_domain_set_regions(d, 1, inside, &marker), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
    m = mesh_of(d);
    CHECK(fabs(volume_of(m, base) - 6 * 64) < 1e-9);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_POINTS), 13);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 7);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_SEGMENTS), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_REGIONS), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_PLANAR_FACETS), 7);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_MISSING_FACETS), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_CAVITIES), 1);
    CHECK(mesh_stat(m, MGDT_MESH_STAT_LARGEST_CAVITY) >= 3);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_IS_ROUNDED), 0);
    CHECK(mesh_stat(m, MGDT_MESH_STAT_MEMORY_BYTES) > 0);
    n = mesh_stat(m, MGDT_MESH_STAT_FACES);
    faces = array_of(m, MGDT_MESH_ARRAY_FACES);
    sides = array_of(m, MGDT_MESH_ARRAY_FACE_TETRAHEDRA);
    facets = array_of(m, MGDT_MESH_ARRAY_FACE_FACETS);
    face_markers = array_of(m, MGDT_MESH_ARRAY_FACE_MARKERS);
    CHECK_EQUAL(mesh_size(m, MGDT_MESH_ARRAY_FACES), 3 * n);
    for (i = 0; i < n; ++i) {
        CHECK_EQUAL(face_markers[i], markers[facets[i] - base]);
        if (facets[i] - base == 6) ++inner;
        /* The polygons of the cube turn about normals that point out of it. */
        CHECK_EQUAL(sides[2 * i] == base - 1, facets[i] - base < 6);
        CHECK(sides[2 * i + 1] >= base);
    }
    CHECK(inner >= 1);
    sources = array_of(m, MGDT_MESH_ARRAY_EDGE_SEGMENTS);
    for (i = 0; i < mesh_size(m, MGDT_MESH_ARRAY_EDGE_SEGMENTS); ++i)
        if (sources[i] >= base) {
            ++given;
            CHECK_EQUAL(sources[i], base);
        }
    CHECK(given >= 1);
    region_markers = array_of(m, MGDT_MESH_ARRAY_REGION_MARKERS);
    CHECK_EQUAL(region_markers[0], 42);
    xyz = points_of(m);
    CHECK(memcmp(xyz, box, sizeof box) == 0);
    CHECK_EQUAL(mesh_size(m, MGDT_MESH_ARRAY_POINTS),
                39 + 3 * mesh_stat(m, MGDT_MESH_STAT_STEINER_POINTS));
    origins = array_of(m, MGDT_MESH_ARRAY_POINT_ORIGINS);
    for (i = 0; i < mesh_stat(m, MGDT_MESH_STAT_POINTS); ++i)
        CHECK_EQUAL(origins[i], i < 13 ? i + base : base - 1);
    free(xyz);
    free(faces);
    free(sides);
    free(facets);
    free(face_markers);
    free(origins);
    free(sources);
    free(region_markers);
    /* A hole leaves nothing. The mesh stays as it was. */
    CHECK_EQUAL(mgdt_domain_set_holes(d, 1, inside), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_CHECK_FAILED);
    check_message(d, "is in a hole");
    CHECK_EQUAL(build(d), MGDT_ERR_OPEN_BOUNDARY);
    check_message(d, "all that the facets enclose are holes");
    /* Holes and regions are set in place of those before. */
    CHECK_EQUAL(mgdt_domain_set_holes(d, 0, NULL), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_HOLES), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_regions(d, 1, inside, NULL), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_REGIONS), 1);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_CHECK_FAILED);
    check_message(d, "has the marker 42, not 0");
    CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_POINTS), 0);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_REGIONS), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_CHECK_FAILED);
    check_message(d, "points besides Steiner points");
    mgdt_domain_destroy(d);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);
}

static void offending_pairs(void) {
    const int64_t triangle[3] = {8, 9, 11},
                  expected[4] = {MGDT_DOMAIN_KIND_FACET, 7, MGDT_DOMAIN_KIND_FACET, 8};
    int64_t corners[30], begin[9], pairs[4];
    int32_t narrow[30], narrow_begin[9], narrow_pairs[4];
    mgdt_domain* d = make_box(1);
    double xyz[39];
    memcpy(xyz, box, sizeof xyz);
    xyz[33] = 2;
    xyz[34] = 2;
    xyz[35] = 2;
    memcpy(corners, quads, sizeof quads);
    for (int i = 0; i < 3; ++i) {
        corners[24 + i] = 8 + i;
        corners[27 + i] = triangle[i];
    }
    for (int i = 0; i < 30; ++i) ++corners[i];
    for (int i = 0; i < 8; ++i) begin[i] = offsets[i] + 1;
    begin[8] = 31;
    CHECK_EQUAL(mgdt_domain_set_points(d, 13, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 8, begin, corners, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_ERR_INVALID_BOUNDARY);
    check_message(d, "facet 7 and facet 8 meet");
    CHECK_EQUAL(build(d), MGDT_ERR_INVALID_BOUNDARY);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_OFFENDING_PAIRS), 1);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 4);
    CHECK_EQUAL(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, 4, pairs), MGDT_OK);
    CHECK(memcmp(pairs, expected, sizeof expected) == 0);
    CHECK_EQUAL(mgdt_domain_get_array_i32(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, 4, narrow_pairs),
                MGDT_OK);
    for (int i = 0; i < 4; ++i) CHECK_EQUAL(narrow_pairs[i], expected[i]);
    /* The same facets, in 32 bits. */
    for (int i = 0; i < 30; ++i) narrow[i] = (int32_t)corners[i];
    for (int i = 0; i < 9; ++i) narrow_begin[i] = (int32_t)begin[i];
    CHECK_EQUAL(mgdt_domain_set_facets_i32(d, 8, narrow_begin, narrow, NULL), MGDT_OK);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 0);
    CHECK_EQUAL(mgdt_domain_set_segments_i32(d, 1, narrow, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_validate(d), MGDT_ERR_INVALID_BOUNDARY);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 4);
    /* Setting points removes what depended on them. */
    CHECK_EQUAL(mgdt_domain_set_points(d, 13, box), MGDT_OK);
    CHECK_EQUAL(size_of(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS), 0);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_FACETS), 0);
    mgdt_domain_destroy(d);
}

/* Nothing at all, and points without facets, enclose nothing. */
static void nothing(void) {
    mgdt_domain* d = NULL;
    int i;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    for (i = 0; i < 2; ++i) {
        CHECK_EQUAL(mgdt_domain_validate(d), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_ERR_OPEN_BOUNDARY);
        CHECK_EQUAL(mgdt_domain_set_points(d, 13, box), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 0, NULL, NULL, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_segments(d, 0, NULL, NULL), MGDT_OK);
    }
    mgdt_domain_destroy(d);
}

/* Builds, and counts what the mesh leaves out. */
static void expect_unused(mgdt_domain* d, int64_t points, int64_t faces, int64_t regions,
                          int64_t holes) {
    mgdt_mesh* const m = mesh_of(d);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_POINTS), points);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_FACES), faces);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_REGIONS), regions);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_HOLES), holes);
    mgdt_mesh_destroy(m);
}

/* Two cubes, one inside of the other, one of whose sides is missing in turn; a point that comes
 * twice, one far away, and places outside. */
static void losses(void) {
    /* Outside, inside twice, outside. */
    const double places[12] = {9, 9, 9, 2, 2, 2, 2, 2, 2, 9, 9, 9}, between[3] = {0.5, 2, 2},
                 far_away[3] = {1e300, 0, 0};
    const int32_t marks[2] = {7, 8};
    double xyz[18 * 3];
    int64_t corners[44], begin[12], i, k, skipped, value;
    mgdt_domain* d = NULL;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    for (i = 0; i < 24; ++i) {
        xyz[i] = box[i];
        xyz[24 + i] = 1 + box[i] / 2;
    }
    memcpy(xyz + 48, box, 3 * sizeof *box);
    memcpy(xyz + 51, places, 3 * sizeof *places);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_STRICT, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_STRICT, 2), MGDT_ERR_INVALID_ARGUMENT);
    for (skipped = 0; skipped < 12; skipped += 6) {
        k = 0;
        for (i = 0; i < 12; ++i) {
            int64_t c;
            if (i == skipped) continue;
            begin[k / 4] = k;
            for (c = 0; c < 4; ++c) corners[k++] = quads[4 * (i % 6) + c] + 8 * (i / 6);
        }
        begin[11] = 44;
        CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_STRICT, 0), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 17, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 11, begin, corners, NULL), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_OK);
        CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_OPEN_EDGES), 4);
        /* Without a side of the outer cube the inner one alone is filled. */
        if (skipped == 0)
            expect_unused(d, 9, 10, 0, 0);
        else
            expect_unused(d, 0, 0, 0, 0);
        CHECK_EQUAL(mgdt_domain_set_regions(d, 2, places, marks), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_holes(d, 1, far_away), MGDT_OK);
        expect_unused(d, skipped == 0 ? 9 : 0, skipped == 0 ? 10 : 0, 1, 1);
        CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_STRICT, 1), MGDT_OK);
        CHECK_EQUAL(build(d), skipped == 0 ? MGDT_ERR_OPEN_BOUNDARY : MGDT_ERR_INVALID_ARGUMENT);
        check_message(d, skipped == 0 ? "facet 0 bounds nothing" : "region 0 is in no region");
    }
    /* The whole cubes: the strict build succeeds, or names what is left out. */
    {
        int64_t all[48], offsets_of_all[13];
        for (i = 0; i < 48; ++i) all[i] = quads[i % 24] + 8 * (i / 24);
        for (i = 0; i < 13; ++i) offsets_of_all[i] = 4 * i;
        CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 17, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 12, offsets_of_all, all, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_regions(d, 1, between, marks), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_holes(d, 2, places + 3), MGDT_OK);
        expect_unused(d, 0, 0, 0, 0);
        CHECK_EQUAL(mgdt_domain_set_holes(d, 3, places + 3), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_ERR_INVALID_ARGUMENT);
        check_message(d, "hole 2 is in nothing");
        CHECK_EQUAL(mgdt_domain_clear(d), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_points(d, 18, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_domain_set_facets(d, 12, offsets_of_all, all, NULL), MGDT_OK);
        CHECK_EQUAL(build(d), MGDT_ERR_INVALID_ARGUMENT);
        check_message(d, "point 17 is a corner of no tetrahedron");
    }
    mgdt_domain_destroy(d);
}

/* With a kept boundary every side of the cube is two faces, and each triangle of a bent prism one,
 * which needs a point inside. */
static void kept_boundary(void) {
    const double prism[18] = {1,     0,    0, -0.5, 0.866, 0, -0.5,   -0.866, 0,
                              0.866, -0.5, 2, 0,    1,     2, -0.866, -0.5,   2};
    const int64_t triangles[24] = {0, 2, 1, 3, 4, 5, 0, 1, 3, 1, 4, 3,
                                   1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5};
    int64_t value = -1, i, n;
    int64_t* edges;
    double* xyz;
    mgdt_domain* d = NULL;
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_get_option(d, MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, &value), MGDT_OK);
    CHECK_EQUAL(value, 0);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, 2),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, 6, prism), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 8, NULL, triangles, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_OK);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_KEEPS_BOUNDARY), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_IS_OF_DOMAIN), 1);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_GRID_BITS), 0);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_FACES), 8);
    n = mesh_stat(m, MGDT_MESH_STAT_STEINER_POINTS);
    CHECK(n >= 1);
    edges = array_of(m, MGDT_MESH_ARRAY_STEINER_EDGES);
    for (i = 0; i < 2 * n; ++i) CHECK_EQUAL(edges[i], -1);
    xyz = points_of(m);
    CHECK(memcmp(xyz, prism, sizeof prism) == 0);
    free(xyz);
    free(edges);
    mgdt_mesh_destroy(m);
    mgdt_domain_destroy(d);
}

/* A mesh holds its memory itself: the domain's memory is the same with it and without it. */
static void memory_of_a_mesh(void) {
    const double places[12] = {9, 9, 9, 2, 2, 2, 2, 2, 2, 9, 9, 9};
    const int32_t marks[4] = {1, 2, 3, 4};
    mgdt_domain* const d = make_box(0);
    mgdt_mesh* m = NULL;
    int64_t held;
    CHECK_EQUAL(mgdt_domain_set_regions(d, 4, places, marks), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_holes(d, 1, places), MGDT_OK);
    CHECK_EQUAL(build(d), MGDT_OK);
    held = stat_of(d, MGDT_DOMAIN_STAT_MEMORY_BYTES);
    m = mesh_of(d);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_REGIONS), 2);
    CHECK_EQUAL(mesh_stat(m, MGDT_MESH_STAT_UNUSED_HOLES), 1);
    CHECK_EQUAL(stat_of(d, MGDT_DOMAIN_STAT_MEMORY_BYTES), held);
    mgdt_domain_destroy(d);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    mgdt_mesh_destroy(m);
}

void test_domain(void) {
    mesh_of_a_box(0);
    mesh_of_a_box(1);
    offending_pairs();
    nothing();
    losses();
    kept_boundary();
    memory_of_a_mesh();
}
