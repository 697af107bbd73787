/* SPDX-License-Identifier: MIT
 * Periodic boxes: what mgdt_periodic_box.m calls. */
#ifndef MGDT_OCTAVE_BOX_H
#define MGDT_OCTAVE_BOX_H

#include "mgdt_diagram.h"

/* The box in use. Octave's allocations may leave the function, so it is kept here and freed by the
 * next call. */
static mgdt_periodic* box;
static int box_is_busy; /* a progress function is running, which must not free it */

static void close_box(void) {
    if (box_is_busy) return;
    if (box) mgdt.periodic_destroy(box);
    box = NULL;
}

DEFINE_READER(box, periodic, close_box)

static mxArray* measures_of_box(int32_t measure, int64_t n) {
    const int width = measure == MGDT_MEASURE_CENTROID ? 3 : 1;
    double* const x = room(width * n, sizeof *x);
    mxArray* result;
    ensure_box(mgdt.periodic_get_cell_measures(box, measure, width * n, x));
    result = rows_of_doubles(x, n, width);
    mxFree(x);
    return result;
}

/* The arguments: points, vectors, threads, the memory limit, a progress function or [], whether to
 * check, whether to measure cells, whether to make their diagram, and the least area and share of
 * faces; the distance within which points become equal. All are read before a box is made. */
static mxArray* periodic_box(int count, const mxArray* const* given) {
    static const struct {
        const char* name;
        int32_t key;
    } arrays[] = {{"points", MGDT_PERIODIC_ARRAY_POINTS},
                  {"vectors", MGDT_PERIODIC_ARRAY_VECTORS},
                  {"point_map", MGDT_PERIODIC_ARRAY_POINT_MAP},
                  {"point_shifts", MGDT_PERIODIC_ARRAY_POINT_SHIFTS},
                  {"tetrahedra", MGDT_PERIODIC_ARRAY_TETRAHEDRA},
                  {"shifts", MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS},
                  {"neighbours", MGDT_PERIODIC_ARRAY_NEIGHBORS},
                  {"neighbour_shifts", MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS},
                  {"vertex_neighbour_offsets", MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS},
                  {"vertex_neighbours", MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS},
                  {"vertex_neighbour_shifts", MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS}};
    static const struct {
        const char* name;
        int32_t key;
    } measures[] = {{"volumes", MGDT_MEASURE_VOLUME},
                    {"areas", MGDT_MEASURE_AREA},
                    {"centroids", MGDT_MEASURE_CENTROID},
                    {"faces", MGDT_MEASURE_FACES}};
    enum { n_arrays = sizeof arrays / sizeof *arrays, n_measures = 4 };
    const char* names[n_arrays + n_measures + 1];
    progress p = {NULL, NULL};
    int64_t n, n_vectors, limit;
    const double *xyz, *vectors;
    int32_t threads;
    int is_checked, is_measured, has_cells, k, fields = n_arrays;
    double area, share, distance;
    mgdt_status status;
    mxArray* result;
    if (count < 11) bad_argument("a box needs more arguments");
    if (box_is_busy)
        mexErrMsgIdAndTxt("mgdt:busy", "a progress function of a box may not use another box");
    xyz = columns(given[0], 3, "points", &n);
    xyz = one_by_one(xyz, 3, n);
    vectors = columns(given[1], 3, "vectors", &n_vectors);
    vectors = one_by_one(vectors, 3, n_vectors);
    threads = small(given[2], "threads");
    limit = integer(given[3], "memory_limit", 9e15);
    is_checked = number(given[5], "check") != 0;
    is_measured = number(given[6], "measures") != 0;
    has_cells = number(given[7], "cells") != 0;
    area = number(given[8], "least_area");
    share = number(given[9], "least_share");
    distance = number(given[10], "merge_distance");
    close_box();
    if (n_vectors > 3) bad_argument("the box has more than three vectors");
    ensure(NULL, mgdt.periodic_create(&box));
    ensure_box(mgdt.periodic_set_vectors(box, (int32_t)n_vectors, vectors));
    ensure_box(mgdt.periodic_set_option(box, MGDT_PERIODIC_OPTION_INDEX_BASE, 1));
    ensure_box(mgdt.periodic_set_option(box, MGDT_PERIODIC_OPTION_THREADS, threads));
    ensure_box(mgdt.periodic_set_option(box, MGDT_PERIODIC_OPTION_MEMORY_LIMIT, limit));
    ensure_box(mgdt.periodic_set_merge_distance(box, distance));
    ensure_box(mgdt.periodic_insert_points(box, n, xyz));
    if (!mxIsEmpty(given[4])) {
        p.function = mxDuplicateArray(given[4]);
        mgdt.periodic_set_progress(box, report, &p);
    }
    box_is_busy = 1;
    status = mgdt.periodic_build(box);
    box_is_busy = 0;
    mgdt.periodic_set_progress(box, NULL, NULL);
    if (p.problem) {
        close_box();
        mexCallMATLAB(0, NULL, 1, &p.problem, "rethrow");
    }
    ensure_box(status);
    if (is_checked) ensure_box(mgdt.periodic_check(box));
    for (k = 0; k < n_arrays; ++k) names[k] = arrays[k].name;
    for (k = 0; is_measured && k < n_measures; ++k) names[fields++] = measures[k].name;
    if (has_cells) names[fields++] = "cells";
    result = mxCreateStructMatrix(1, 1, fields, names);
    for (k = 0; k < n_arrays; ++k) mxSetFieldByNumber(result, 0, k, array_of_box(arrays[k].key));
    for (k = 0; is_measured && k < n_measures; ++k)
        mxSetFieldByNumber(result, 0, n_arrays + k, measures_of_box(measures[k].key, n));
    if (has_cells) {
        close_diagram();
        ensure_box(mgdt.periodic_create_voronoi(box, &diagram));
        mxSetFieldByNumber(result, 0, fields - 1, take_diagram(area, share));
    }
    close_box();
    return result;
}

#endif /* MGDT_OCTAVE_BOX_H */
