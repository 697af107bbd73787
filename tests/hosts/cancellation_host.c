/* SPDX-License-Identifier: MIT
 * A host that cancels its threads by pthread_cancel() while they are inside a call. No call is a
 * cancellation point, whatever its callbacks do: it ends as always, gives the thread's cancellation
 * state back, and the request acts after it. */
#define _GNU_SOURCE
#include <errno.h>
#include <pthread.h>

#include "linked.h"

/* ---------------------------------------------------------- callbacks that are cancellation points
 */

/* The thread that calls is cancelled from here as well: a worker of the library may be told to end
 * by whoever learns its pthread_t in a callback. */
static void be_a_cancellation_point(void) {
    REQUIRE(pthread_cancel(pthread_self()) == 0);
    pthread_testcancel();
}

static int32_t report(double fraction, void* user) {
    (void)fraction;
    be_a_cancellation_point();
    usleep(1);
    ++*(int*)user;
    return 0;
}

/* Leaves the cancellation state as the library must not have it. */
static int32_t report_and_enable(double fraction, void* user) {
    (void)fraction;
    ++*(int*)user;
    REQUIRE(pthread_setcancelstate(PTHREAD_CANCEL_ENABLE, NULL) == 0);
    return 0;
}

static void* take(size_t size, size_t align, void* user) {
    void* p = NULL;
    if (*(int*)user) be_a_cancellation_point();
    return posix_memalign(&p, align < sizeof p ? sizeof p : align, size) == 0 ? p : NULL;
}

static void give(void* p, size_t size, size_t align, void* user) {
    (void)size;
    (void)align;
    if (*(int*)user) be_a_cancellation_point();
    free(p);
}

/* -------------------------------------------------------------------------------------- the calls
 */

static struct points p;
static double flat[3 * 100];
static int64_t *tetrahedra, *places, *others;
static int64_t tetrahedron_capacity;
static int is_cancellation_point, reports;

static mgdt_status insert(mgdt_triangulation* t) {
    return mgdt_insert_points(t, p.n, p.xyz);
}
static mgdt_status insert_some(mgdt_triangulation* t) {
    mgdt_status status = mgdt_insert_points(t, 3, p.xyz);
    return status == MGDT_OK ? mgdt_insert_points(t, 5, p.xyz + 9) : status;
}
static mgdt_status insert_flat(mgdt_triangulation* t) {
    return mgdt_insert_points_strided(t, 100, flat, flat + 1, flat + 2, 3);
}
static mgdt_status locate(mgdt_triangulation* t) {
    return mgdt_locate_points(t, location_count, p.queries, places, NULL);
}
static mgdt_status locate_one(mgdt_triangulation* t) {
    return mgdt_locate(t, p.queries, places);
}
static mgdt_status nearest(mgdt_triangulation* t) {
    return mgdt_nearest_vertex(t, p.queries, places);
}
static mgdt_status check(mgdt_triangulation* t) {
    return mgdt_check(t, MGDT_CHECK_CANONICAL);
}
static mgdt_status export_all(mgdt_triangulation* t) {
    mgdt_status s = mgdt_get_tetrahedra(t, tetrahedron_capacity, tetrahedra);
    if (s == MGDT_OK) s = mgdt_get_neighbors(t, tetrahedron_capacity, tetrahedra);
    if (s == MGDT_OK) s = mgdt_get_hull_facets(t, tetrahedron_capacity, tetrahedra);
    if (s == MGDT_OK) s = mgdt_get_edges(t, tetrahedron_capacity, tetrahedra);
    if (s == MGDT_OK) s = mgdt_get_point_map(t, tetrahedron_capacity, tetrahedra);
    if (s == MGDT_OK)
        s = mgdt_get_vertex_tetrahedra(t, tetrahedron_capacity, others, tetrahedron_capacity,
                                       tetrahedra);
    return s;
}
static mgdt_status change(mgdt_triangulation* t) {
    mgdt_status s = mgdt_reserve(t, 4 * p.n);
    if (s == MGDT_OK) s = mgdt_set_compact(t, 1);
    if (s == MGDT_OK) s = mgdt_set_compact(t, 0);
    if (s == MGDT_OK) s = mgdt_set_canonical_output(t, 1);
    if (s == MGDT_OK) s = mgdt_set_canonical_output(t, 0);
    if (s == MGDT_OK) s = mgdt_clear(t);
    return s;
}
static mgdt_status create_and_destroy(mgdt_triangulation* t) {
    mgdt_triangulation* other = NULL;
    mgdt_status s = mgdt_create_with_allocator(take, give, &is_cancellation_point, &other);
    if (s == MGDT_OK) s = insert_some(other);
    mgdt_destroy(other);
    return t != NULL ? s : MGDT_ERR_INTERNAL;
}

static const struct {
    const char* name;
    mgdt_status (*call)(mgdt_triangulation*);
    int on_filled; /* the handle has the points before */
} calls[] = {{"insert", insert, 0},
             {"insert on top", insert, 1},
             {"insert some", insert_some, 0},
             {"insert flat", insert_flat, 0},
             {"locate", locate, 1},
             {"locate one", locate_one, 1},
             {"nearest", nearest, 1},
             {"check", check, 1},
             {"export", export_all, 1},
             {"change", change, 1},
             {"create and destroy", create_and_destroy, 0}};
enum { call_count = sizeof calls / sizeof calls[0] };

/* ------------------------------------------------------------------------------------- the threads
 */

struct visit {
    mgdt_triangulation* t;
    mgdt_status (*call)(mgdt_triangulation*);
    mgdt_status status;
    int state, type; /* of the thread when it calls */
    int is_pending;  /* the request is made before the call */
    int has_started, has_returned, has_gone_on;
};

static void* call(void* argument) {
    struct visit* v = argument;
    int state = -1, type = -1;
    REQUIRE(pthread_setcancelstate(v->state, NULL) == 0);
    if (v->is_pending) REQUIRE(pthread_cancel(pthread_self()) == 0);
    __atomic_store_n(&v->has_started, 1, __ATOMIC_RELEASE);
    REQUIRE(pthread_setcanceltype(v->type, NULL) == 0);
    v->status = v->call(v->t);
    __atomic_store_n(&v->has_returned, 1, __ATOMIC_RELEASE);
    REQUIRE(pthread_setcanceltype(PTHREAD_CANCEL_DEFERRED, &type) == 0);
    REQUIRE(pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &state) == 0);
    REQUIRE(state == v->state && type == v->type);
    REQUIRE(pthread_setcancelstate(v->state, NULL) == 0);
    pthread_testcancel();
    v->has_gone_on = 1;
    return NULL;
}

static void start(pthread_t* thread, struct visit* v) {
    REQUIRE(pthread_create(thread, NULL, call, v) == 0);
}

/* What the call has done is complete: nothing of it is left inside the handle. */
static void require_whole(struct visit* v) {
    is_cancellation_point = 0;
    REQUIRE(mgdt_set_progress(v->t, NULL, NULL) == MGDT_OK);
    REQUIRE(mgdt_check(v->t, v->call == insert ? MGDT_CHECK_GEOMETRIC : MGDT_CHECK_COMBINATORIAL) ==
            MGDT_OK);
    REQUIRE(mgdt_insert_points(v->t, 100, p.xyz) == MGDT_OK);
    REQUIRE(mgdt_check(v->t, MGDT_CHECK_COMBINATORIAL) == MGDT_OK);
    REQUIRE(thread_count() == 1);
}

static mgdt_triangulation* make(int own_allocator, int32_t threads, int is_filled) {
    mgdt_triangulation* t = NULL;
    is_cancellation_point = 0;
    if (own_allocator)
        REQUIRE(mgdt_create_with_allocator(take, give, &is_cancellation_point, &t) == MGDT_OK);
    else
        REQUIRE(mgdt_create(&t) == MGDT_OK);
    REQUIRE(mgdt_set_threads(t, threads) == MGDT_OK);
    if (is_filled) REQUIRE(mgdt_insert_points(t, p.n, p.xyz) == MGDT_OK);
    return t;
}

/* A request that is there before the call acts at whatever is a cancellation point: at none of the
 * call's, its callbacks' included, and at the first that comes after it. */
static void pending(int k, int32_t threads, int own_allocator, mgdt_progress_fn progress) {
    struct visit v;
    pthread_t thread;
    void* result = NULL;
    memset(&v, 0, sizeof v);
    v.t = make(own_allocator, threads, calls[k].on_filled);
    v.call = calls[k].call;
    v.state = PTHREAD_CANCEL_ENABLE;
    v.type = PTHREAD_CANCEL_DEFERRED;
    v.is_pending = 1;
    reports = 0;
    REQUIRE(mgdt_set_progress(v.t, progress, &reports) == MGDT_OK);
    is_cancellation_point = own_allocator;
    start(&thread, &v);
    REQUIRE(pthread_join(thread, &result) == 0);
    if (!v.has_returned || v.status != MGDT_OK || result != PTHREAD_CANCELED || v.has_gone_on)
        fprintf(stderr, "%s, %d threads\n", calls[k].name, (int)threads);
    REQUIRE(v.has_returned && v.status == MGDT_OK);
    REQUIRE(result == PTHREAD_CANCELED && !v.has_gone_on);
    REQUIRE(progress == NULL || calls[k].call != insert || reports > 2);
    require_whole(&v);
    mgdt_destroy(v.t);
}

/* A thread that must not be cancelled still must not be after the call. */
static void disabled(int k) {
    struct visit v;
    pthread_t thread;
    void* result = NULL;
    memset(&v, 0, sizeof v);
    v.t = make(0, 2, calls[k].on_filled);
    v.call = calls[k].call;
    v.state = PTHREAD_CANCEL_DISABLE;
    v.type = PTHREAD_CANCEL_DEFERRED;
    v.is_pending = 1;
    start(&thread, &v);
    REQUIRE(pthread_join(thread, &result) == 0);
    REQUIRE(v.has_returned && v.status == MGDT_OK && v.has_gone_on && result == NULL);
    require_whole(&v);
    mgdt_destroy(v.t);
}

/* The request comes from another thread at any moment. With the asynchronous type it acts when the
 * call has ended or before it has begun, and the handle has all of it or nothing. */
static void from_elsewhere(int32_t threads, int type, int rounds) {
    unsigned delay = 1;
    int k;
    for (k = 0; k < rounds; ++k) {
        struct visit v;
        pthread_t thread;
        void* result = NULL;
        int64_t vertices;
        int error;
        memset(&v, 0, sizeof v);
        v.t = make(0, threads, 0);
        v.call = k % 3 == 2 ? insert_some : insert;
        v.state = PTHREAD_CANCEL_ENABLE;
        v.type = type;
        start(&thread, &v);
        while (!__atomic_load_n(&v.has_started, __ATOMIC_ACQUIRE)) usleep(10);
        delay = delay * 1103515245u + 12345u;
        usleep(delay / 65536 % (k % 3 == 2 ? 60 : 40000));
        error = pthread_cancel(thread);
        REQUIRE(error == 0 || error == ESRCH);
        REQUIRE(pthread_join(thread, &result) == 0);
        vertices = mgdt_vertex_count(v.t);
        if (type == PTHREAD_CANCEL_DEFERRED) REQUIRE(v.has_returned && v.status == MGDT_OK);
        if (v.has_returned) REQUIRE(v.status == MGDT_OK);
        if (v.call == insert) REQUIRE(vertices == (v.has_returned ? p.n : vertices ? p.n : 0));
        require_whole(&v);
        mgdt_destroy(v.t);
    }
}

int main(void) {
    static const mgdt_progress_fn progress[] = {NULL, report, report_and_enable};
    int k, threads, own, i;
    p = make_points(point_count);
    for (i = 0; i < 100; ++i) {
        flat[3 * i] = i % 10;
        flat[3 * i + 1] = i / 10;
    }
    tetrahedron_capacity = 64 * p.n;
    tetrahedra = malloc((size_t)tetrahedron_capacity * sizeof *tetrahedra);
    others = malloc((size_t)tetrahedron_capacity * sizeof *others);
    places = malloc(location_count * sizeof *places);
    REQUIRE(tetrahedra != NULL && others != NULL && places != NULL);

    for (k = 0; k < call_count; ++k) {
        for (threads = 1; threads <= 3; threads += 2)
            for (own = 0; own < 2; ++own) pending(k, threads, own, progress[0]);
        disabled(k);
    }
    for (k = 0; k < 4; ++k)
        for (threads = 1; threads <= 3; threads += 2)
            for (i = 1; i < 3; ++i) pending(k, threads, 1, progress[i]);
    for (threads = 1; threads <= 2; ++threads) {
        from_elsewhere(threads, PTHREAD_CANCEL_DEFERRED, is_small() ? 3 : 6);
        from_elsewhere(threads, PTHREAD_CANCEL_ASYNCHRONOUS, is_small() ? 6 : 24);
    }
    free(tetrahedra);
    free(others);
    free(places);
    free_points(p);
    return 0;
}
