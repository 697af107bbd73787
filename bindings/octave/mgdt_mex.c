/* SPDX-License-Identifier: MIT
 * The gateway between Octave and mgdt, which mgdt_triangulation.m calls:
 *
 *   [...] = mgdt_mex (COMMAND, HANDLE, ...)
 *
 * To compile it:  mkoctfile --mex $(pkg-config --cflags mgdt) mgdt_mex.c -o mgdt_mex.mex
 *
 * A handle is a pair [slot, serial], so that one that is no longer there is recognised. Errors have
 * an identifier "mgdt:not_finite" and the library's message, before which Octave puts "mgdt_mex: ".
 * Nothing here is allocated but by mxMalloc, which Octave takes back when an error leaves the
 * function. */
#include "mgdt_box.h"
#include "mgdt_diagram.h"
#include "mgdt_mesh.h"

/* ------------------------------------------------------------------------------------ handles */

typedef struct {
    mgdt_triangulation* t; /* NULL where the slot is free */
    double serial;
    int busy; /* being changed, so that a progress function may only cancel */
} slot;

static slot* slots;
static size_t slot_count, live_count;
static double last_serial;

static void destroy_all(void) {
    size_t k;
    close_diagram();
    close_domain();
    close_box();
    for (k = 0; k < slot_count; ++k)
        if (slots[k].t) mgdt.destroy(slots[k].t);
    free(slots);
    slots = NULL;
    slot_count = live_count = 0;
}

static mxArray* create(void) {
    mgdt_triangulation* t;
    mxArray* result = mxCreateDoubleMatrix(1, 2, mxREAL);
    size_t k = 0;
    while (k < slot_count && slots[k].t) ++k;
    if (k == slot_count) {
        const size_t larger = slot_count ? 2 * slot_count : 16;
        slot* const moved = realloc(slots, larger * sizeof *slots);
        if (!moved) ensure(NULL, MGDT_ERR_OUT_OF_MEMORY);
        memset(moved + slot_count, 0, (larger - slot_count) * sizeof *slots);
        slots = moved;
        slot_count = larger;
    }
    ensure(NULL, mgdt.create(&t));
    mgdt.set_index_base(t, 1);
    slots[k].t = t;
    slots[k].serial = ++last_serial;
    slots[k].busy = 0;
    /* "clear all" must not take the code from handles that are in use. */
    if (live_count++ == 0) mexLock();
    mxGetPr(result)[0] = (double)k;
    mxGetPr(result)[1] = last_serial;
    return result;
}

static slot* find(const mxArray* handle) {
    const double* pair;
    if (!handle || !mxIsDouble(handle) || mxGetNumberOfElements(handle) != 2)
        bad_argument("not a handle");
    pair = mxGetPr(handle);
    if (!(pair[0] >= 0 && pair[0] < (double)slot_count) || !slots[(size_t)pair[0]].t ||
        slots[(size_t)pair[0]].serial != pair[1])
        mexErrMsgIdAndTxt("mgdt:null_pointer", "the triangulation is closed");
    return &slots[(size_t)pair[0]];
}

static void destroy(slot* s) {
    mgdt.destroy(s->t);
    s->t = NULL;
    if (--live_count == 0) mexUnlock();
}

typedef mgdt_status (*get_function)(const mgdt_triangulation* t, int64_t capacity, int64_t* v);

static mxArray* export_rows(const mgdt_triangulation* t, get_function get, int64_t count,
                            int width) {
    int64_t* const v = room(count * width, sizeof *v);
    mxArray* result;
    ensure(t, get(t, count * width, v));
    result = rows(v, count, width);
    mxFree(v);
    return result;
}

/* ------------------------------------------------------------------ points in, out and moved */

/* What a call that may take long is given. */
typedef struct {
    int64_t n;
    const int64_t* points; /* or NULL */
    const double* xyz;
} change;

typedef mgdt_status (*change_function)(mgdt_triangulation* t, const change* c);

/* Makes a change, with a function that hears of progress, or []. */
static void run(slot* s, change_function make, const change* c, const mxArray* function) {
    const size_t at = (size_t)(s - slots);
    mgdt_triangulation* const t = s->t;
    progress p = {NULL, NULL};
    mgdt_status status;
    if (c->n == 0) return;
    if (function && !mxIsEmpty(function)) {
        p.function = mxDuplicateArray(function);
        mgdt.set_progress(t, report, &p);
    }
    s->busy = 1;
    status = make(t, c);
    slots[at].busy = 0; /* the progress function may have made handles, which moves the slots */
    mgdt.set_progress(t, NULL, NULL);
    if (p.problem) mexCallMATLAB(0, NULL, 1, &p.problem, "rethrow");
    ensure(t, status);
}

static mgdt_status make_insertion(mgdt_triangulation* t, const change* c) {
    return mgdt.insert_points_strided(t, c->n, c->xyz, c->xyz + c->n, c->xyz + 2 * c->n, 1);
}

static mgdt_status make_removal(mgdt_triangulation* t, const change* c) {
    return mgdt.remove_points(t, c->n, c->points);
}

static mgdt_status make_move(mgdt_triangulation* t, const change* c) {
    return mgdt.move_points(t, c->n, c->points, c->xyz);
}

static void insert(slot* s, const mxArray* matrix, const mxArray* function) {
    change c = {0, NULL, NULL};
    c.xyz = points(matrix, &c.n);
    run(s, make_insertion, &c, function);
}

/* ------------------------------------------------------------------------------------ queries */

static const double* rows_of_points(const mxArray* matrix, int64_t* n) {
    const double* const from = points(matrix, n);
    return one_by_one(from, 3, *n);
}

static void remove_points(slot* s, const mxArray* list, const mxArray* function) {
    change c = {0, NULL, NULL};
    c.points = whole_numbers(list, "numbers of points", &c.n);
    run(s, make_removal, &c, function);
}

/* With [] for the list: all points. */
static void move_points(slot* s, const mxArray* list, const mxArray* matrix,
                        const mxArray* function) {
    change c = {0, NULL, NULL};
    int64_t listed = 0;
    if (list && !mxIsEmpty(list)) c.points = whole_numbers(list, "numbers of points", &listed);
    c.xyz = rows_of_points(matrix, &c.n);
    if (c.points && listed != c.n)
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "there are %lld points and %lld places",
                          (long long)listed, (long long)c.n);
    run(s, make_move, &c, function);
}

static mxArray* renumber(mgdt_triangulation* t) {
    const int64_t n = mgdt.point_count(t);
    int64_t* const index = room(n, sizeof *index);
    ensure(t, mgdt.renumber_points(t, n, index));
    return rows(index, n, 1);
}

static void locate(const mgdt_triangulation* t, const mxArray* matrix, int nlhs, mxArray** plhs) {
    int64_t n, k;
    int i;
    const double* const xyz = rows_of_points(matrix, &n);
    double* const weights = room(4 * n, sizeof *weights);
    int64_t* const found = room(n, sizeof *found);
    double *numbers, *w;
    ensure(t, mgdt.locate_points(t, n, xyz, found, nlhs > 1 ? weights : NULL));
    plhs[0] = mxCreateDoubleMatrix((mwSize)n, 1, mxREAL);
    numbers = mxGetPr(plhs[0]);
    for (k = 0; k < n; ++k) numbers[k] = found[k] == 0 ? mxGetNaN() : (double)found[k];
    if (nlhs > 1) {
        plhs[1] = mxCreateDoubleMatrix((mwSize)n, 4, mxREAL);
        w = mxGetPr(plhs[1]);
        for (k = 0; k < n; ++k)
            for (i = 0; i < 4; ++i) w[i * n + k] = found[k] == 0 ? mxGetNaN() : weights[4 * k + i];
    }
}

static mxArray* nearest(const mgdt_triangulation* t, const mxArray* matrix) {
    int64_t n, k;
    const double* const xyz = rows_of_points(matrix, &n);
    int64_t* const found = room(n, sizeof *found);
    mxArray* const result = mxCreateDoubleMatrix((mwSize)n, 1, mxREAL);
    ensure(t, mgdt.nearest_vertices(t, n, xyz, found));
    for (k = 0; k < n; ++k) mxGetPr(result)[k] = found[k] == 0 ? mxGetNaN() : (double)found[k];
    return result;
}

typedef mgdt_status (*lists_getter)(const mgdt_triangulation*, int64_t, int64_t*, int64_t,
                                    int64_t*);

static void lists(const mgdt_triangulation* t, lists_getter get, int64_t length, int nlhs,
                  mxArray** plhs) {
    const int64_t n = mgdt.point_count(t);
    int64_t *const offsets = room(n + 1, sizeof *offsets), *const list = room(length, sizeof *list);
    ensure(t, get(t, n + 1, offsets, length, list));
    plhs[0] = rows(offsets, n + 1, 1);
    if (nlhs > 1) plhs[1] = rows(list, length, 1);
}

typedef mgdt_status (*graph_getter)(const mgdt_triangulation*, int64_t, int64_t*, int64_t*);

static mxArray* graph(const mgdt_triangulation* t, graph_getter get, int64_t most) {
    int64_t *const v = room(2 * most, sizeof *v), count = 0;
    mxArray* result;
    ensure(t, get(t, 2 * most, v, &count));
    result = rows(v, count, 2);
    mxFree(v);
    return result;
}

static void circumcenters(const mgdt_triangulation* t, int nlhs, mxArray** plhs) {
    const int64_t n = mgdt.tetrahedron_count(t);
    double *const xyz = room(3 * n, sizeof *xyz), *const squares = room(n, sizeof *squares);
    ensure(t, mgdt.get_circumcenters(t, n, xyz, squares));
    plhs[0] = rows_of_doubles(xyz, n, 3);
    if (nlhs > 1) plhs[1] = rows_of_doubles(squares, n, 1);
}

static mxArray* alphas(const mgdt_triangulation* t, int32_t dimension) {
    const int64_t n = dimension == 0   ? mgdt.point_count(t)
                      : dimension == 1 ? mgdt.edge_count(t)
                                       : mgdt.tetrahedron_count(t);
    const int width = dimension == 2 ? 4 : 1;
    double* const x = room(width * n, sizeof *x);
    ensure(t, mgdt.get_alphas(t, dimension, width * n, x));
    return rows_of_doubles(x, n, width);
}

static mxArray* tetrahedron_measures(const mgdt_triangulation* t, int32_t measure) {
    const int64_t n = mgdt.tetrahedron_count(t);
    double* const x = room(n, sizeof *x);
    ensure(t, mgdt.get_tetrahedron_measures(t, measure, n, x));
    return rows_of_doubles(x, n, 1);
}

static mxArray* alpha_surface(const mgdt_triangulation* t, const mxArray* alpha2) {
    /* Enough for one surface or some; the count says what others need. */
    int64_t capacity = 2 * mgdt.vertex_count(t) + 4, count = 0, *v;
    mgdt_status status;
    if (!alpha2 || !mxIsDouble(alpha2) || mxIsComplex(alpha2) || mxGetNumberOfElements(alpha2) != 1)
        bad_argument("alpha2 must be a number");
    for (;;) {
        v = room(3 * capacity, sizeof *v);
        status = mgdt.get_alpha_surface(t, mxGetScalar(alpha2), 3 * capacity, v, &count);
        if (status != MGDT_ERR_BUFFER_TOO_SMALL) break;
        mxFree(v);
        capacity = count;
    }
    ensure(t, status);
    return rows(v, count, 3);
}

static const double* one_point(const mxArray* matrix) {
    if (!matrix || !mxIsDouble(matrix) || mxIsComplex(matrix) || mxIsSparse(matrix) ||
        mxGetNumberOfElements(matrix) != 3)
        bad_argument("the ends must have 3 coordinates each, as full vectors of doubles");
    return mxGetPr(matrix);
}

static void traverse_segment(const mgdt_triangulation* t, const mxArray* from, const mxArray* to,
                             mxArray** plhs) {
    /* Enough for most segments; the count says what others need. */
    const double *const a = one_point(from), *const b = one_point(to);
    int64_t capacity = 128, count = 0, *found;
    double* parameters;
    mgdt_status status;
    for (;;) {
        found = room(capacity, sizeof *found);
        parameters = room(capacity + 1, sizeof *parameters);
        status = mgdt.traverse_segment(t, a, b, capacity, found, parameters, &count);
        if (status != MGDT_ERR_BUFFER_TOO_SMALL) break;
        mxFree(found);
        mxFree(parameters);
        capacity = count;
    }
    ensure(t, status);
    plhs[0] = rows(found, count, 1);
    plhs[1] = rows_of_doubles(parameters, count == 0 ? 0 : count + 1, 1);
}

/* A matrix with a row for each point. */
static mxArray* cell_measures(const mgdt_triangulation* t, int32_t measure, const mxArray* matrix) {
    const int width = measure == MGDT_MEASURE_CENTROID ? 3 : 1;
    const int64_t n = mgdt.point_count(t);
    double* const x = room(width * n, sizeof *x);
    const double* planes;
    int64_t n_planes;
    planes = columns(matrix, 4, "planes", &n_planes);
    planes = one_by_one(planes, 4, n_planes);
    ensure(t, mgdt.get_cell_measures(t, measure, n_planes, planes, width * n, x));
    return rows_of_doubles(x, n, width);
}

/* The Voronoi diagram as a struct of its arrays. */
static mxArray* voronoi(const mgdt_triangulation* t, const mxArray* matrix, double area,
                        double share) {
    int64_t n_planes;
    const double* const given = columns(matrix, 4, "planes", &n_planes);
    const double* const planes = one_by_one(given, 4, n_planes);
    close_diagram();
    ensure(t, mgdt.voronoi_create(t, n_planes, planes, &diagram));
    return take_diagram(area, share);
}

/* Values of the points, one row for each; the caller's fields. */
static const double* values_of(const mgdt_triangulation* t, const mxArray* matrix,
                               int64_t* fields) {
    const int64_t n = mgdt.point_count(t);
    *fields = matrix ? (int64_t)mxGetN(matrix) : 0;
    if (!matrix || !mxIsDouble(matrix) || mxIsComplex(matrix) || mxIsSparse(matrix) ||
        mxGetNumberOfDimensions(matrix) != 2 || (int64_t)mxGetM(matrix) != n)
        mexErrMsgIdAndTxt("mgdt:invalid_argument",
                          "values must be a full real matrix of doubles with a row for each of the "
                          "%lld points",
                          (long long)n);
    return one_by_one(mxGetPr(matrix), (int)*fields, n);
}

static mxArray* interpolate(const mgdt_triangulation* t, int32_t method, int32_t outside,
                            const mxArray* values, const mxArray* places) {
    int64_t n, fields;
    const double *const xyz = rows_of_points(places, &n), *const given =
                                                              values_of(t, values, &fields);
    double* const out = room(fields * n, sizeof *out);
    ensure(t, mgdt.interpolate(t, method, outside, fields, given, n, xyz, out));
    return rows_of_doubles(out, n, fields);
}

/* Places, points and weights, each a column. */
static void interpolation_weights(const mgdt_triangulation* t, int32_t method, int32_t outside,
                                  const mxArray* places, mxArray** plhs) {
    int64_t n, k, i, *points, size;
    const double* const xyz = rows_of_points(places, &n);
    int64_t* const offsets = room(n + 1, sizeof *offsets);
    double *weights, *place;
    mgdt_status status;
    /* Enough for most; the last offset says what others need. */
    size = 24 * n + 8;
    for (;;) {
        points = room(size, sizeof *points);
        weights = room(size, sizeof *weights);
        status = mgdt.get_interpolation_weights(t, method, outside, n, xyz, n + 1, offsets, size,
                                                points, weights);
        if (status != MGDT_ERR_BUFFER_TOO_SMALL) break;
        mxFree(points);
        mxFree(weights);
        size = offsets[n] - offsets[0];
    }
    ensure(t, status);
    size = offsets[n] - offsets[0];
    plhs[0] = mxCreateDoubleMatrix((mwSize)size, 1, mxREAL);
    plhs[1] = rows(points, size, 1);
    plhs[2] = rows_of_doubles(weights, size, 1);
    place = mxGetPr(plhs[0]);
    for (k = 0; k < n; ++k)
        for (i = offsets[k]; i < offsets[k + 1]; ++i) place[i - offsets[0]] = (double)(k + 1);
}

static mxArray* gradients(const mgdt_triangulation* t, const mxArray* values) {
    const int64_t n = mgdt.point_count(t);
    int64_t fields;
    const double* const given = values_of(t, values, &fields);
    double* const out = room(3 * fields * n, sizeof *out);
    ensure(t, mgdt.get_gradients(t, fields, given, out));
    return rows_of_doubles(out, n, 3 * fields);
}

static mxArray* statistics(const mgdt_triangulation* t) {
    mxArray* const result = mxCreateStructMatrix(1, 1, 0, NULL);
    int32_t key;
    for (key = 0; key < 1000; ++key) {
        const char* const name = mgdt.stat_name(key);
        char field[64];
        double value;
        int i;
        if (!name) continue;
        snprintf(field, sizeof field, "%s", name);
        for (i = 0; field[i]; ++i)
            if (field[i] == ' ' || field[i] == '-') field[i] = '_';
        ensure(t, mgdt.get_stat(t, key, &value));
        mxSetFieldByNumber(result, 0, mxAddField(result, field), mxCreateDoubleScalar(value));
    }
    return result;
}

static mxArray* scheme_names(void) {
    const char* names[64];
    int32_t scheme;
    int count = 0, k;
    mxArray* result;
    while (count < 64 && mgdt.order_scheme_at(count, &scheme) == MGDT_OK)
        names[count++] = mgdt.order_scheme_name(scheme);
    result = mxCreateCellMatrix((mwSize)count, 1);
    for (k = 0; k < count; ++k) mxSetCell(result, (mwIndex)k, mxCreateString(names[k]));
    return result;
}

/* ----------------------------------------------------------------------------------- settings */

static void set_order(mgdt_triangulation* t, const mxArray* value) {
    const char* const name = text(value, "the order scheme");
    int32_t scheme;
    if (mgdt.order_scheme_from_name(name, &scheme) != MGDT_OK)
        mexErrMsgIdAndTxt("mgdt:unknown_scheme", "there is no order scheme %s", name);
    ensure(t, mgdt.set_order_scheme(t, scheme));
}

/* The key of a parameter of the order schemes, or 0. */
static int32_t parameter(const char* name) {
    static const struct {
        const char* name;
        int32_t key;
    } parameters[] = {{"points_per_cell", MGDT_PARAMETER_POINTS_PER_CELL},
                      {"threshold", MGDT_PARAMETER_THRESHOLD},
                      {"separation", MGDT_PARAMETER_SEPARATION},
                      {"round_ratio", MGDT_PARAMETER_ROUND_RATIO}};
    size_t k;
    for (k = 0; k < sizeof parameters / sizeof *parameters; ++k)
        if (strcmp(name, parameters[k].name) == 0) return parameters[k].key;
    return 0;
}

static double separation(const mxArray* value) {
    static const char* const names[] = {"none", "passes", "rounds"};
    const char* name;
    int k;
    if (!mxIsChar(value)) return number(value, "separation");
    name = text(value, "separation");
    for (k = 0; k < 3; ++k)
        if (strcmp(name, names[k]) == 0) return k;
    mexErrMsgIdAndTxt("mgdt:invalid_argument",
                      "separation is %s; it must be none, passes or rounds", name);
    return 0;
}

static void set(mgdt_triangulation* t, const char* name, const mxArray* value) {
    const int32_t key = parameter(name);
    if (key != 0) {
        const double x = key == MGDT_PARAMETER_SEPARATION ? separation(value) : number(value, name);
        ensure(t, mgdt.set_order_parameter(t, key, x));
        return;
    }
    if (strcmp(name, "order") == 0) {
        set_order(t, value);
    } else if (strcmp(name, "seed") == 0) {
        const int64_t seed = integer(value, name, 9007199254740992.0);
        if (seed < 0) bad_argument("seed is negative");
        ensure(t, mgdt.set_seed(t, (uint64_t)seed));
    } else if (strcmp(name, "threads") == 0) {
        ensure(t, mgdt.set_threads(t, small(value, name)));
    } else if (strcmp(name, "memory_limit") == 0) {
        ensure(t, mgdt.set_memory_limit(t, integer(value, name, 9007199254740992.0)));
    } else if (strcmp(name, "compact") == 0) {
        ensure(t, mgdt.set_compact(t, number(value, name) != 0));
    } else if (strcmp(name, "canonical") == 0) {
        ensure(t, mgdt.set_canonical_output(t, number(value, name) != 0));
    } else if (strcmp(name, "isa") == 0) {
        ensure(t, mgdt.set_isa(t, mxIsEmpty(value) ? NULL : text(value, name)));
    } else {
        mexErrMsgIdAndTxt("mgdt:unknown_key", "there is no setting %s", name);
    }
}

static mxArray* get(const mgdt_triangulation* t, const char* name) {
    const int32_t key = parameter(name);
    int32_t number32 = 0;
    int64_t bytes = 0;
    uint64_t seed = 0;
    double value = 0;
    if (key != 0) {
        ensure(t, mgdt.get_order_parameter(t, key, &value));
    } else if (strcmp(name, "order") == 0) {
        ensure(t, mgdt.get_order_scheme(t, &number32));
        return mxCreateString(mgdt.order_scheme_name(number32));
    } else if (strcmp(name, "seed") == 0) {
        ensure(t, mgdt.get_seed(t, &seed));
        value = (double)seed;
    } else if (strcmp(name, "threads") == 0) {
        ensure(t, mgdt.get_threads(t, &number32));
        value = number32;
    } else if (strcmp(name, "memory_limit") == 0) {
        ensure(t, mgdt.get_memory_limit(t, &bytes));
        value = (double)bytes;
    } else if (strcmp(name, "compact") == 0) {
        ensure(t, mgdt.get_compact(t, &number32));
        return mxCreateLogicalScalar(number32 != 0);
    } else if (strcmp(name, "canonical") == 0) {
        ensure(t, mgdt.get_canonical_output(t, &number32));
        return mxCreateLogicalScalar(number32 != 0);
    } else if (strcmp(name, "isa") == 0) {
        return mxCreateString(mgdt.isa_name(t));
    } else {
        mexErrMsgIdAndTxt("mgdt:unknown_key", "there is no setting %s", name);
    }
    return mxCreateDoubleScalar(value);
}

/* ------------------------------------------------------------------------------------ gateway */

static mxArray* count_of(const mgdt_triangulation* t, const char* what) {
    if (strcmp(what, "points") == 0) return mxCreateDoubleScalar((double)mgdt.point_count(t));
    if (strcmp(what, "vertices") == 0) return mxCreateDoubleScalar((double)mgdt.vertex_count(t));
    if (strcmp(what, "dimension") == 0) return mxCreateDoubleScalar((double)mgdt.dimension(t));
    if (strcmp(what, "tetrahedra") == 0)
        return mxCreateDoubleScalar((double)mgdt.tetrahedron_count(t));
    if (strcmp(what, "hull_facets") == 0)
        return mxCreateDoubleScalar((double)mgdt.hull_facet_count(t));
    if (strcmp(what, "edges") == 0) return mxCreateDoubleScalar((double)mgdt.edge_count(t));
    bad_argument("no such count");
    return NULL;
}

static mxArray* export_of(const mgdt_triangulation* t, const char* what) {
    const int64_t tetrahedra = mgdt.tetrahedron_count(t);
    if (strcmp(what, "tetrahedra") == 0) return export_rows(t, mgdt.get_tetrahedra, tetrahedra, 4);
    if (strcmp(what, "neighbors") == 0) return export_rows(t, mgdt.get_neighbors, tetrahedra, 4);
    if (strcmp(what, "hull_facets") == 0)
        return export_rows(t, mgdt.get_hull_facets, mgdt.hull_facet_count(t), 3);
    if (strcmp(what, "edges") == 0) return export_rows(t, mgdt.get_edges, mgdt.edge_count(t), 2);
    if (strcmp(what, "gabriel_edges") == 0)
        return graph(t, mgdt.get_gabriel_edges, mgdt.edge_count(t));
    if (strcmp(what, "spanning_tree") == 0)
        return graph(t, mgdt.get_spanning_tree, mgdt.vertex_count(t));
    if (strcmp(what, "point_map") == 0)
        return export_rows(t, mgdt.get_point_map, mgdt.point_count(t), 1);
    bad_argument("no such export");
    return NULL;
}

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
    char problem[2048];
    const char* command;
    const mxArray *first, *second;
    slot* s;

    if (!mgdt_load(problem, sizeof problem)) mexErrMsgIdAndTxt("mgdt:library", "%s", problem);
    mexAtExit(destroy_all);
    command = text(nrhs > 0 ? prhs[0] : NULL, "the command");
    if (strcmp(command, "create") == 0) {
        plhs[0] = create();
        return;
    }
    if (strcmp(command, "version") == 0) {
        plhs[0] = mxCreateString(mgdt.version_string());
        return;
    }
    if (strcmp(command, "mesh_places") == 0) {
        mesh_places(nlhs, plhs, nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "refine") == 0) {
        plhs[0] = refined_mesh(nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "improve") == 0) {
        plhs[0] = improved_mesh(nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "domain_mesh") == 0) {
        plhs[0] = domain_mesh(nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "periodic_box") == 0) {
        plhs[0] = periodic_box(nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "clean_surface") == 0) {
        plhs[0] = clean_surface(nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "offending_pairs") == 0) {
        plhs[0] = offending_pairs(nrhs - 1, prhs + 1);
        return;
    }
    if (strcmp(command, "schemes") == 0) {
        plhs[0] = scheme_names();
        return;
    }

    s = find(nrhs > 1 ? prhs[1] : NULL);
    first = nrhs > 2 ? prhs[2] : NULL;
    second = nrhs > 3 ? prhs[3] : NULL;
    if (strcmp(command, "cancel") == 0) {
        mgdt.cancel(s->t);
        return;
    }
    if (s->busy)
        mexErrMsgIdAndTxt("mgdt:busy",
                          "a progress function may not call its triangulation, except cancel");
    if (strcmp(command, "destroy") == 0) {
        destroy(s);
    } else if (strcmp(command, "clear") == 0) {
        ensure(s->t, mgdt.clear(s->t));
    } else if (strcmp(command, "reserve") == 0) {
        ensure(s->t, mgdt.reserve(s->t, integer(first, "the number of points", 9e15)));
    } else if (strcmp(command, "set") == 0) {
        if (!second) bad_argument("a setting without a value");
        set(s->t, text(first, "the setting"), second);
    } else if (strcmp(command, "shrink") == 0) {
        ensure(s->t, mgdt.shrink(s->t));
    } else if (strcmp(command, "get") == 0) {
        plhs[0] = get(s->t, text(first, "the setting"));
    } else if (strcmp(command, "insert") == 0) {
        insert(s, first, second);
    } else if (strcmp(command, "remove") == 0) {
        remove_points(s, first, second);
    } else if (strcmp(command, "move") == 0) {
        move_points(s, first, second, nrhs > 4 ? prhs[4] : NULL);
    } else if (strcmp(command, "renumber") == 0) {
        plhs[0] = renumber(s->t);
    } else if (strcmp(command, "count") == 0) {
        plhs[0] = count_of(s->t, text(first, "the count"));
    } else if (strcmp(command, "export") == 0) {
        plhs[0] = export_of(s->t, text(first, "the export"));
    } else if (strcmp(command, "vertex_tetrahedra") == 0) {
        lists(s->t, mgdt.get_vertex_tetrahedra, mgdt.vertex_tetrahedra_count(s->t), nlhs, plhs);
    } else if (strcmp(command, "vertex_neighbors") == 0) {
        lists(s->t, mgdt.get_vertex_neighbors, mgdt.vertex_neighbors_count(s->t), nlhs, plhs);
    } else if (strcmp(command, "circumcenters") == 0) {
        circumcenters(s->t, nlhs, plhs);
    } else if (strcmp(command, "alphas") == 0) {
        plhs[0] = alphas(s->t, small(first, "the dimension"));
    } else if (strcmp(command, "tetrahedron_measures") == 0) {
        plhs[0] = tetrahedron_measures(s->t, small(first, "the measure"));
    } else if (strcmp(command, "alpha_surface") == 0) {
        plhs[0] = alpha_surface(s->t, first);
    } else if (strcmp(command, "solid_alpha") == 0) {
        double alpha2 = 0;
        ensure(s->t, mgdt.get_solid_alpha(s->t, &alpha2));
        plhs[0] = mxCreateDoubleScalar(alpha2);
    } else if (strcmp(command, "cell_measures") == 0) {
        plhs[0] = cell_measures(s->t, small(first, "the measure"), second);
    } else if (strcmp(command, "voronoi") == 0) {
        plhs[0] = voronoi(s->t, first, number(second, "the least area"),
                          number(nrhs > 4 ? prhs[4] : NULL, "the least share"));
    } else if (strcmp(command, "interpolate") == 0) {
        plhs[0] = interpolate(s->t, small(first, "the method"), small(second, "what is outside"),
                              nrhs > 4 ? prhs[4] : NULL, nrhs > 5 ? prhs[5] : NULL);
    } else if (strcmp(command, "interpolation_weights") == 0) {
        if (nlhs != 3) bad_argument("there are three results");
        interpolation_weights(s->t, small(first, "the method"), small(second, "what is outside"),
                              nrhs > 4 ? prhs[4] : NULL, plhs);
    } else if (strcmp(command, "gradients") == 0) {
        plhs[0] = gradients(s->t, first);
    } else if (strcmp(command, "locate") == 0) {
        locate(s->t, first, nlhs, plhs);
    } else if (strcmp(command, "traverse_segment") == 0) {
        if (nlhs != 2) bad_argument("there are two results");
        traverse_segment(s->t, first, second, plhs);
    } else if (strcmp(command, "nearest") == 0) {
        plhs[0] = nearest(s->t, first);
    } else if (strcmp(command, "check") == 0) {
        ensure(s->t, mgdt.check(s->t, small(first, "the level")));
    } else if (strcmp(command, "statistics") == 0) {
        plhs[0] = statistics(s->t);
    } else {
        bad_argument("no such command");
    }
}
