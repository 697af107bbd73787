/* SPDX-License-Identifier: MIT
 * Voronoi diagrams, of triangulations and of periodic boxes. */
#ifndef MGDT_OCTAVE_DIAGRAM_H
#define MGDT_OCTAVE_DIAGRAM_H

#include "mgdt_support.h"

/* The diagram that is being read. Octave's allocations may leave the function, so it is kept here
 * and freed by the next call. */
static mgdt_voronoi* diagram;

static void close_diagram(void) {
    if (diagram) mgdt.voronoi_destroy(diagram);
    diagram = NULL;
}

static void ensure_diagram(mgdt_status s) {
    char message[256] = "";
    if (s == MGDT_OK) return;
    mgdt.voronoi_get_error(diagram, (int64_t)sizeof message, message);
    close_diagram();
    mexErrMsgIdAndTxt(identifier(s), "%s", *message ? message : mgdt.status_string(s));
}

static mxArray* array_of_diagram(int32_t key, int width) {
    int64_t count = 0;
    mxArray* result;
    ensure_diagram(mgdt.voronoi_get_size(diagram, key, &count));
    if (key < MGDT_VORONOI_VERTICES) {
        int64_t* const v = room(count, sizeof *v);
        ensure_diagram(mgdt.voronoi_get_array(diagram, key, count, v));
        result = rows(v, count / width, width);
        mxFree(v);
    } else {
        double* const x = room(count, sizeof *x);
        ensure_diagram(mgdt.voronoi_get_doubles(diagram, key, count, x));
        result = rows_of_doubles(x, count / width, width);
        mxFree(x);
    }
    return result;
}

/* The diagram in use as a struct of its arrays, with a row for each face, ray, vertex or cell,
 * without faces that are smaller. It is freed. */
static mxArray* take_diagram(double area, double share) {
    static const struct {
        const char* name;
        int32_t key;
        int width;
    } arrays[] = {{"vertices", MGDT_VORONOI_VERTICES, 3},
                  {"face_offsets", MGDT_VORONOI_FACE_OFFSETS, 1},
                  {"face_corners", MGDT_VORONOI_FACE_CORNERS, 1},
                  {"face_sides", MGDT_VORONOI_FACE_SIDES, 2},
                  {"face_images", MGDT_VORONOI_FACE_IMAGES, 3},
                  {"face_areas", MGDT_VORONOI_FACE_AREAS, 1},
                  {"face_normals", MGDT_VORONOI_FACE_NORMALS, 3},
                  {"face_centroids", MGDT_VORONOI_FACE_CENTROIDS, 3},
                  {"ray_vertices", MGDT_VORONOI_RAY_VERTICES, 1},
                  {"ray_directions", MGDT_VORONOI_RAY_DIRECTIONS, 3},
                  {"cell_offsets", MGDT_VORONOI_CELL_OFFSETS, 1},
                  {"cell_faces", MGDT_VORONOI_CELL_FACES, 1},
                  {"cell_bounded", MGDT_VORONOI_CELL_BOUNDED, 1},
                  {"cell_neighbors", MGDT_VORONOI_CELL_NEIGHBORS, 1},
                  {"cell_neighbor_images", MGDT_VORONOI_CELL_NEIGHBOR_IMAGES, 3},
                  {"cell_face_areas", MGDT_VORONOI_CELL_FACE_AREAS, 1},
                  {"cell_neighbor_distances", MGDT_VORONOI_CELL_NEIGHBOR_DISTANCES, 1},
                  {"cell_volumes", MGDT_VORONOI_CELL_VOLUMES, 1},
                  {"cell_centroids", MGDT_VORONOI_CELL_CENTROIDS, 3}};
    enum { count = sizeof arrays / sizeof *arrays };
    const char* names[count];
    mxArray* result;
    int k;
    ensure_diagram(mgdt.voronoi_drop_small_faces(diagram, area, share));
    for (k = 0; k < count; ++k) names[k] = arrays[k].name;
    result = mxCreateStructMatrix(1, 1, count, names);
    for (k = 0; k < count; ++k)
        mxSetFieldByNumber(result, 0, k, array_of_diagram(arrays[k].key, arrays[k].width));
    close_diagram();
    return result;
}

#endif /* MGDT_OCTAVE_DIAGRAM_H */
