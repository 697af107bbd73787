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

DEFINE_READER(diagram, voronoi, close_diagram)

/* The diagram in use as a struct of its arrays, with a row for each face, ray, vertex or cell,
 * without faces that are smaller. It is freed. */
static mxArray* take_diagram(double area, double share) {
    static const struct {
        const char* name;
        int32_t key;
    } arrays[] = {{"vertices", MGDT_VORONOI_ARRAY_VERTICES},
                  {"face_offsets", MGDT_VORONOI_ARRAY_FACE_OFFSETS},
                  {"face_corners", MGDT_VORONOI_ARRAY_FACE_CORNERS},
                  {"face_sides", MGDT_VORONOI_ARRAY_FACE_SIDES},
                  {"face_shifts", MGDT_VORONOI_ARRAY_FACE_SHIFTS},
                  {"face_areas", MGDT_VORONOI_ARRAY_FACE_AREAS},
                  {"face_normals", MGDT_VORONOI_ARRAY_FACE_NORMALS},
                  {"face_centroids", MGDT_VORONOI_ARRAY_FACE_CENTROIDS},
                  {"ray_vertices", MGDT_VORONOI_ARRAY_RAY_VERTICES},
                  {"ray_directions", MGDT_VORONOI_ARRAY_RAY_DIRECTIONS},
                  {"cell_offsets", MGDT_VORONOI_ARRAY_CELL_OFFSETS},
                  {"cell_faces", MGDT_VORONOI_ARRAY_CELL_FACES},
                  {"cell_bounded", MGDT_VORONOI_ARRAY_CELL_BOUNDED},
                  {"cell_neighbors", MGDT_VORONOI_ARRAY_CELL_NEIGHBORS},
                  {"cell_neighbor_shifts", MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS},
                  {"cell_face_areas", MGDT_VORONOI_ARRAY_CELL_FACE_AREAS},
                  {"cell_neighbor_distances", MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES},
                  {"cell_volumes", MGDT_VORONOI_ARRAY_CELL_VOLUMES},
                  {"cell_centroids", MGDT_VORONOI_ARRAY_CELL_CENTROIDS}};
    enum { count = sizeof arrays / sizeof *arrays };
    const char* names[count];
    mxArray* result;
    int k;
    ensure_diagram(mgdt.voronoi_drop_small_faces(diagram, area, share));
    for (k = 0; k < count; ++k) names[k] = arrays[k].name;
    result = mxCreateStructMatrix(1, 1, count, names);
    for (k = 0; k < count; ++k) mxSetFieldByNumber(result, 0, k, array_of_diagram(arrays[k].key));
    close_diagram();
    return result;
}

#endif /* MGDT_OCTAVE_DIAGRAM_H */
