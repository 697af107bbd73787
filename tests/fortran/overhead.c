/* SPDX-License-Identifier: MIT
 * The C side of overhead.f90: the same calls on the same arrays. */
#include <mgdt/mgdt.h>
#include <stdlib.h>

int32_t c_round(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    mgdt_status status = mgdt_create(&t);
    if (status == MGDT_OK) status = mgdt_set_index_base(t, 1);
    if (status == MGDT_OK) status = mgdt_insert_points(t, n, xyz);
    const int64_t capacity = 4 * mgdt_tetrahedron_count(t);
    int32_t* v = malloc((size_t)capacity * sizeof *v);
    if (!v) status = MGDT_ERR_OUT_OF_MEMORY;
    if (status == MGDT_OK) status = mgdt_get_tetrahedra_i32(t, capacity, v);
    if (status == MGDT_OK) status = mgdt_get_neighbors_i32(t, capacity, v);
    free(v);
    mgdt_destroy(t);
    return status;
}
