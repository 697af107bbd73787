/* SPDX-License-Identifier: MIT
 * A library with numbers beyond 32 bits, which a real one needs hundreds of gigabytes for: these
 * stand in for its own in test_overflow.f and test_overflow_module.f90. */
#include <mgdt/mgdt.h>
#include <sys/resource.h>

static const int64_t large = INT64_C(3000000000);

/* Less memory than a copy of such an array takes. */
void limit_memory(void) {
    struct rlimit limit;
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = (rlim_t)4 << 30;
    setrlimit(RLIMIT_AS, &limit);
}

/* For Fortran, whatever it does to names. */
void limit_memory_(void) {
    limit_memory();
}
void limit_memory__(void) {
    limit_memory();
}

int64_t mgdt_point_count(const mgdt_triangulation* t) {
    return t ? large : 0;
}
int64_t mgdt_vertex_count(const mgdt_triangulation* t) {
    return t ? large : 0;
}
int64_t mgdt_tetrahedron_count(const mgdt_triangulation* t) {
    return t ? large : 0;
}
int64_t mgdt_hull_facet_count(const mgdt_triangulation* t) {
    return t ? large : 0;
}
int64_t mgdt_edge_count(const mgdt_triangulation* t) {
    return t ? large : 0;
}
int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation* t) {
    return t ? 4 * large : 0;
}
int64_t mgdt_vertex_neighbors_count(const mgdt_triangulation* t) {
    return t ? 2 * large : 0;
}

mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz, int64_t* vertex) {
    if (!t || !xyz) return MGDT_ERR_NULL_POINTER;
    *vertex = large;
    return MGDT_OK;
}

mgdt_status mgdt_nearest_vertex_i32(const mgdt_triangulation* t, const double* xyz,
                                    int32_t* vertex) {
    return t && xyz && vertex ? MGDT_ERR_INDEX_RANGE : MGDT_ERR_NULL_POINTER;
}

mgdt_status mgdt_get_seed(const mgdt_triangulation* t, uint64_t* seed) {
    if (!t || !seed) return MGDT_ERR_NULL_POINTER;
    *seed = (uint64_t)large;
    return MGDT_OK;
}
mgdt_status mgdt_get_memory_limit(const mgdt_triangulation* t, int64_t* bytes) {
    if (!t || !bytes) return MGDT_ERR_NULL_POINTER;
    *bytes = -large; /* below what 32 bits hold */
    return MGDT_OK;
}

/* What the library says of 32-bit arrays then, and what capacity reached it. */
mgdt_status mgdt_get_tetrahedra_i32(const mgdt_triangulation* t, int64_t capacity, int32_t* v) {
    if (!t || !v) return MGDT_ERR_NULL_POINTER;
    return capacity < 4 * large ? MGDT_ERR_BUFFER_TOO_SMALL : MGDT_ERR_INDEX_RANGE;
}
mgdt_status mgdt_get_tetrahedra(const mgdt_triangulation* t, int64_t capacity, int64_t* v) {
    if (!t || !v) return MGDT_ERR_NULL_POINTER;
    return capacity < 4 * large ? MGDT_ERR_BUFFER_TOO_SMALL : MGDT_OK;
}
