/* SPDX-License-Identifier: MIT
 * Exported arrays: sizes, bases, widths, orientation, and the canonical order. */
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { canary = -123456789 };

typedef mgdt_status (*get32_fn)(const mgdt_triangulation*, int64_t, int32_t*);

static const struct {
    get_fn get;
    get32_fn get32;
    int64_t (*count)(const mgdt_triangulation*);
    int64_t width;
} arrays[] = {{mgdt_get_tetrahedra, mgdt_get_tetrahedra_i32, mgdt_tetrahedron_count, 4},
              {mgdt_get_neighbors, mgdt_get_neighbors_i32, mgdt_tetrahedron_count, 4},
              {mgdt_get_hull_facets, mgdt_get_hull_facets_i32, mgdt_hull_facet_count, 3},
              {mgdt_get_edges, mgdt_get_edges_i32, mgdt_edge_count, 2},
              {mgdt_get_point_map, mgdt_get_point_map_i32, mgdt_point_count, 1}};
enum { array_count = sizeof arrays / sizeof arrays[0] };

/* One element too few touches nothing; enough writes that many and not one more; the 32-bit twin
 * has the same numbers; base 1 has each number one higher, "none" included. */
static void one_array(mgdt_triangulation* t, int a) {
    const int64_t size = arrays[a].width * arrays[a].count(t);
    int64_t *v = malloc((size_t)(size + 1) * sizeof *v), i;
    int32_t* w = malloc((size_t)(size + 1) * sizeof *w);
    int same = 1;
    CHECK(size > 0);
    for (i = 0; i <= size; ++i) w[i] = canary, v[i] = canary;
    CHECK_EQUAL(arrays[a].get(t, size - 1, v), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(arrays[a].get32(t, size - 1, w), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(arrays[a].get(t, 0, v), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(arrays[a].get(t, -1, v), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(arrays[a].get32(t, -1, w), MGDT_ERR_INVALID_ARGUMENT);
    for (i = 0; i <= size; ++i) same &= w[i] == canary && v[i] == canary;
    CHECK(same);
    CHECK_EQUAL(arrays[a].get(t, size + 1, v), MGDT_OK);
    CHECK_EQUAL(arrays[a].get32(t, size, w), MGDT_OK);
    CHECK_EQUAL(v[size], canary);
    CHECK_EQUAL(w[size], canary);
    for (i = 0; i < size; ++i) same &= v[i] == w[i] && v[i] >= -1;
    CHECK(same);
    CHECK_EQUAL(mgdt_set_index_base(t, 1), MGDT_OK);
    CHECK_EQUAL(arrays[a].get32(t, size, w), MGDT_OK);
    for (i = 0; i < size; ++i) same &= w[i] == v[i] + 1;
    CHECK_EQUAL(arrays[a].get(t, size, v), MGDT_OK);
    for (i = 0; i < size; ++i) same &= w[i] == v[i];
    CHECK(same);
    CHECK_EQUAL(mgdt_set_index_base(t, 0), MGDT_OK);
    free(v);
    free(w);
}

/* The list around each vertex, from the tetrahedra, in both bases and both widths. */
static void vertex_tetrahedra(mgdt_triangulation* t) {
    const int64_t n = mgdt_point_count(t), m = mgdt_tetrahedron_count(t), size = 4 * m;
    int64_t *tetrahedra = get_array(mgdt_get_tetrahedra, t, size),
            *offsets = malloc((size_t)(n + 2) * sizeof *offsets),
            *list = malloc((size_t)(size + 1) * sizeof *list), i, k;
    int32_t *offsets32 = malloc((size_t)(n + 2) * sizeof *offsets32),
            *list32 = malloc((size_t)(size + 1) * sizeof *list32);
    int good = 1;
    int32_t base;
    CHECK_EQUAL(mgdt_vertex_tetrahedra_count(t), size);
    for (i = 0; i <= n + 1; ++i) offsets[i] = offsets32[i] = canary;
    for (i = 0; i <= size; ++i) list[i] = list32[i] = canary;
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, n, offsets, size, list), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, n + 1, offsets, size - 1, list),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra_i32(t, n, offsets32, size, list32),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra_i32(t, n + 1, offsets32, size - 1, list32),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, -1, offsets, size, list), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, n + 1, offsets, -1, list), MGDT_ERR_INVALID_ARGUMENT);
    for (i = 0; i <= n + 1; ++i) good &= offsets[i] == canary && offsets32[i] == canary;
    for (i = 0; i <= size; ++i) good &= list[i] == canary && list32[i] == canary;
    CHECK(good);
    for (base = 0; base < 2; ++base) {
        CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
        CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, n + 1, offsets, size, list), MGDT_OK);
        CHECK_EQUAL(mgdt_get_vertex_tetrahedra_i32(t, n + 1, offsets32, size, list32), MGDT_OK);
        for (i = 0; i <= n; ++i) good &= offsets[i] == offsets32[i];
        for (i = 0; i < size; ++i) good &= list[i] == list32[i];
        CHECK(good);
        CHECK_EQUAL(offsets[n + 1], canary);
        CHECK_EQUAL(offsets32[n + 1], canary);
        CHECK_EQUAL(list[size], canary);
        CHECK_EQUAL(list32[size], canary);
        CHECK_EQUAL(offsets[0], base);
        CHECK_EQUAL(offsets[n], size + base);
        for (i = 0; i < n && good; ++i)
            for (k = offsets[i] - base; k < offsets[i + 1] - base; ++k) {
                const int64_t* v = tetrahedra + 4 * (list[k] - base);
                if (!(list[k] >= base && list[k] < m + base)) {
                    good = 0;
                    break;
                }
                good &= v[0] == i || v[1] == i || v[2] == i || v[3] == i;
                good &= k == offsets[i] - base || list[k - 1] < list[k];
            }
        CHECK(good);
    }
    CHECK_EQUAL(mgdt_set_index_base(t, 0), MGDT_OK);
    free(tetrahedra);
    free(offsets);
    free(list);
    free(offsets32);
    free(list32);
}

/* Every neighbour shares the other three vertices, and has this one as its own. Returns how many
 * facets have none. */
static int64_t open_facets(int64_t m, const int64_t* v, const int64_t* neighbor) {
    int64_t i, j, k, open = 0;
    int good = 1;
    for (i = 0; i < 4 * m; ++i) {
        const int64_t other = neighbor[i];
        int shared = 0, mutual = 0;
        if (other == -1) {
            ++open;
            continue;
        }
        if (other < 0 || other >= m || other == i / 4) {
            good = 0;
            continue;
        }
        for (j = 0; j < 4; ++j) {
            mutual += neighbor[4 * other + j] == i / 4;
            for (k = 0; k < 4; ++k) shared += v[4 * (i / 4) + j] == v[4 * other + k] && j != i % 4;
        }
        good &= shared == 3 && mutual == 1;
    }
    CHECK(good);
    return open;
}

/* More tetrahedra than are numbered by a table. */
static void many_neighbors(void) {
    const int64_t n = is_small() ? 100 : 30000;
    double* xyz = random_points(n, 0, 34);
    mgdt_triangulation* t = make(n, xyz);
    const int64_t m = mgdt_tetrahedron_count(t);
    int64_t *v = get_array(mgdt_get_tetrahedra, t, 4 * m),
            *neighbor = get_array(mgdt_get_neighbors, t, 4 * m);
    CHECK_EQUAL(open_facets(m, v, neighbor), mgdt_hull_facet_count(t));
    free(v);
    free(neighbor);
    mgdt_destroy(t);
    free(xyz);
}

/* On random points, where doubles decide: orientation, hull facets, neighbours, edges. */
static void meaning(void) {
    const int64_t n = is_small() ? 80 : 300;
    double* xyz = random_points(n, 0, 31);
    mgdt_triangulation* t = make(n, xyz);
    const int64_t m = mgdt_tetrahedron_count(t), h = mgdt_hull_facet_count(t),
                  e = mgdt_edge_count(t);
    int64_t *v = get_array(mgdt_get_tetrahedra, t, 4 * m),
            *neighbor = get_array(mgdt_get_neighbors, t, 4 * m),
            *hull = get_array(mgdt_get_hull_facets, t, 3 * h),
            *edges = get_array(mgdt_get_edges, t, 2 * e), i, j, k, open, used = 0;
    char* edge = calloc((size_t)(n * n), 1);
    double sum = 0, outside = 0;
    int good = 1;
    for (i = 0; i < m; ++i) {
        const double six = volume(xyz + 3 * v[4 * i], xyz + 3 * v[4 * i + 1],
                                  xyz + 3 * v[4 * i + 2], xyz + 3 * v[4 * i + 3]);
        good &= six > 0;
        sum += six;
    }
    CHECK(good);
    open = open_facets(m, v, neighbor);
    CHECK_EQUAL(open, h);
    /* Outward facets: every cone from the origin has its sign, and they add up to the volume. */
    for (i = 0; i < h; ++i) {
        static const double origin[3] = {0, 0, 0};
        const double *a = xyz + 3 * hull[3 * i], *b = xyz + 3 * hull[3 * i + 1],
                     *c = xyz + 3 * hull[3 * i + 2];
        outside += volume(origin, a, b, c);
        for (j = 0; j < n; ++j)
            good &= j == hull[3 * i] || j == hull[3 * i + 1] || j == hull[3 * i + 2] ||
                    volume(a, b, c, xyz + 3 * j) < 0;
    }
    CHECK(good);
    CHECK(outside > 0.999999 * sum && outside < 1.000001 * sum);
    for (i = 0; i < m; ++i)
        for (j = 0; j < 4; ++j)
            for (k = 0; k < 4; ++k)
                if (v[4 * i + j] < v[4 * i + k]) edge[v[4 * i + j] * n + v[4 * i + k]] = 1;
    for (i = 0; i < e; ++i) {
        char* mark = edge + edges[2 * i] * n + edges[2 * i + 1];
        good &= edges[2 * i] < edges[2 * i + 1] && *mark == 1;
        *mark = 2;
    }
    for (i = 0; i < n * n; ++i) used += edge[i] != 0;
    CHECK(good);
    CHECK_EQUAL(used, e);
    CHECK_EQUAL(n - e + (4 * m + h) / 2 - m, 1); /* Euler, for a ball */
    mgdt_destroy(t);
    free(xyz);
    free(v);
    free(neighbor);
    free(hull);
    free(edges);
    free(edge);
}

/* Every exported array, one after the other. */
static int64_t* everything(const mgdt_triangulation* t, int64_t* size) {
    int64_t *all, *end;
    int a;
    *size = 5 * mgdt_point_count(t) + 1 + mgdt_vertex_tetrahedra_count(t);
    for (a = 0; a < array_count; ++a) *size += arrays[a].width * arrays[a].count(t);
    end = all = calloc((size_t)*size, sizeof *all);
    for (a = 0; a < array_count; ++a) {
        const int64_t width = arrays[a].width * arrays[a].count(t);
        CHECK_EQUAL(arrays[a].get(t, width, end), MGDT_OK);
        end += width;
    }
    CHECK_EQUAL(
        mgdt_get_vertex_tetrahedra(t, mgdt_point_count(t) + 1, end, mgdt_vertex_tetrahedra_count(t),
                                   end + mgdt_point_count(t) + 1),
        MGDT_OK);
    return all;
}

/* The same bytes for every scheme and split; each tetrahedron begins with its least vertices. */
static void canonical(void) {
    const int64_t n = is_small() ? 100 : 1000;
    double* xyz = random_points(n, 12, 32);
    int64_t *expected = NULL, expected_size = 0, b, k;
    int32_t s, scheme = 0;
    for (s = 0; mgdt_order_scheme_at(s, &scheme) == MGDT_OK; ++s)
        for (b = 1; b <= 7; b += 3) {
            mgdt_triangulation* t = NULL;
            int64_t *all, size = 0;
            CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
            CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
            CHECK_EQUAL(mgdt_set_order_scheme(t, scheme), MGDT_OK);
            CHECK_EQUAL(mgdt_set_seed(t, (uint64_t)(s + 1)), MGDT_OK);
            for (k = 0; k < b; ++k)
                CHECK_EQUAL(
                    mgdt_insert_points(t, n * (k + 1) / b - n * k / b, xyz + 3 * (n * k / b)),
                    MGDT_OK);
            all = everything(t, &size);
            if (expected == NULL) {
                const int64_t m = mgdt_tetrahedron_count(t);
                int64_t i;
                int sorted = 1;
                for (i = 0; i < m; ++i) {
                    const int64_t* v = all + 4 * i;
                    sorted &= v[0] < v[1] && v[1] < v[2] && v[1] < v[3];
                    if (i > 0)
                        sorted &=
                            v[-4] < v[0] ||
                            (v[-4] == v[0] &&
                             (v[-3] < v[1] || (v[-3] == v[1] &&
                                               (v[-2] < v[2] || (v[-2] == v[2] && v[-1] < v[3])))));
                }
                CHECK(sorted);
                expected = all;
                expected_size = size;
            } else {
                CHECK(size == expected_size &&
                      memcmp(all, expected, (size_t)size * sizeof *all) == 0);
                free(all);
            }
            mgdt_destroy(t);
        }
    free(expected);
    free(xyz);
}

/* The same points in another order are the same tetrahedra under other indices. */
static void shuffled(void) {
    const int64_t n = is_small() ? 100 : 1000;
    double *xyz = random_points(n, 0, 33), *mixed = malloc((size_t)(3 * n) * sizeof *mixed);
    mgdt_triangulation *a = make(n, xyz), *b = NULL;
    int64_t *v, i;
    int canonical_on;
    /* i -> 7 i + 3 modulo n is a permutation: 7 divides neither 100 nor 1000. */
    for (i = 0; i < n; ++i) memcpy(mixed + 3 * ((7 * i + 3) % n), xyz + 3 * i, 3 * sizeof *xyz);
    b = make(n, mixed);
    for (canonical_on = 0; canonical_on < 2; ++canonical_on) {
        const int64_t m = mgdt_tetrahedron_count(a);
        int64_t *w, *neighbor;
        CHECK_EQUAL(mgdt_tetrahedron_count(b), m);
        CHECK_EQUAL(mgdt_hull_facet_count(a), mgdt_hull_facet_count(b));
        CHECK_EQUAL(mgdt_edge_count(a), mgdt_edge_count(b));
        CHECK_EQUAL(mgdt_set_canonical_output(b, canonical_on), MGDT_OK);
        v = get_array(mgdt_get_tetrahedra, b, 4 * m);
        neighbor = get_array(mgdt_get_neighbors, b, 4 * m);
        /* Neighbours follow the order of the tetrahedra. */
        CHECK_EQUAL(open_facets(m, v, neighbor), mgdt_hull_facet_count(b));
        free(neighbor);
        /* Back through the permutation, the sets agree. */
        w = get_array(mgdt_get_tetrahedra, a, 4 * m);
        for (i = 0; i < 4 * m; ++i) w[i] = (7 * w[i] + 3) % n;
        sort_tetrahedra(v, m);
        sort_tetrahedra(w, m);
        CHECK(memcmp(v, w, (size_t)(4 * m) * sizeof *v) == 0);
        free(v);
        free(w);
    }
    mgdt_destroy(a);
    mgdt_destroy(b);
    free(xyz);
    free(mixed);
}

void test_export(void) {
    double* xyz = random_points(200, 8, 30);
    mgdt_triangulation* t = make(200, xyz);
    int a, on;
    for (on = 0; on < 2; ++on) {
        CHECK_EQUAL(mgdt_set_canonical_output(t, on), MGDT_OK);
        for (a = 0; a < array_count; ++a) one_array(t, a);
        vertex_tetrahedra(t);
    }
    mgdt_destroy(t);
    free(xyz);
    meaning();
    many_neighbors();
    canonical();
    shuffled();
}
