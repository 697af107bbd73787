/* SPDX-License-Identifier: MIT
 * Stands between the bindings and the library and notes which addresses pass, for
 * test_no_copies.f90. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <mgdt/mgdt.h>

static const void* seen;

const void* spy_seen(void) {
    return seen;
}

static void* real(const char* name) {
    return dlsym(RTLD_NEXT, name);
}

#define NEXT(name, type) \
    static type next;    \
    if (!next) *(void**)&next = real(#name)

typedef mgdt_status (*insert_fn)(mgdt_triangulation*, int64_t, const double*);
typedef mgdt_status (*strided_fn)(mgdt_triangulation*, int64_t, const double*, const double*,
                                  const double*, int64_t);
typedef mgdt_status (*get_fn)(const mgdt_triangulation*, int64_t, int64_t*);
typedef mgdt_status (*get_i32_fn)(const mgdt_triangulation*, int64_t, int32_t*);
typedef mgdt_status (*locate_fn)(const mgdt_triangulation*, int64_t, const double*, int64_t*,
                                 double*);

mgdt_status mgdt_insert_points(mgdt_triangulation* t, int64_t n, const double* xyz) {
    NEXT(mgdt_insert_points, insert_fn);
    seen = xyz;
    return next(t, n, xyz);
}

mgdt_status mgdt_insert_points_strided(mgdt_triangulation* t, int64_t n, const double* x,
                                       const double* y, const double* z, int64_t stride) {
    NEXT(mgdt_insert_points_strided, strided_fn);
    seen = x;
    return next(t, n, x, y, z, stride);
}

mgdt_status mgdt_get_tetrahedra(const mgdt_triangulation* t, int64_t capacity, int64_t* v) {
    NEXT(mgdt_get_tetrahedra, get_fn);
    seen = v;
    return next(t, capacity, v);
}

mgdt_status mgdt_get_tetrahedra_i32(const mgdt_triangulation* t, int64_t capacity, int32_t* v) {
    NEXT(mgdt_get_tetrahedra_i32, get_i32_fn);
    seen = v;
    return next(t, capacity, v);
}

mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                               int64_t* tetrahedra, double* weights) {
    NEXT(mgdt_locate_points, locate_fn);
    seen = weights ? (const void*)weights : (const void*)xyz;
    return next(t, n, xyz, tetrahedra, weights);
}
