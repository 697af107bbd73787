/* SPDX-License-Identifier: MIT
 * A host with many threads, each with handles of its own that start threads of theirs, and handles
 * that pass from thread to thread. */
#include <pthread.h>

#include "linked.h"

enum { host_threads = 8 };

static struct points p;
static uint64_t expected;
static mgdt_triangulation* passed_on[host_threads];

static void* call(void* argument) {
    const int k = (int)(intptr_t)argument;
    const int calls = is_small() ? 1 : 3;
    int i;
    for (i = 0; i < calls; ++i) REQUIRE(triangulate(&linked, p, 1 + (k + i) % 4, NULL) == expected);
    REQUIRE(mgdt_create(&passed_on[k]) == MGDT_OK);
    REQUIRE(mgdt_set_threads(passed_on[k], 2) == MGDT_OK);
    REQUIRE(mgdt_set_canonical_output(passed_on[k], 1) == MGDT_OK);
    REQUIRE(mgdt_insert_points(passed_on[k], p.n / 2, p.xyz) == MGDT_OK);
    return NULL;
}

/* Goes on with the handle of another thread, which has ended. */
static void* go_on(void* argument) {
    mgdt_triangulation* const t = passed_on[host_threads - 1 - (int)(intptr_t)argument];
    REQUIRE(mgdt_clear(t) == MGDT_OK);
    REQUIRE(fill_and_locate(&linked, t, p, NULL) == expected);
    mgdt_destroy(t);
    return NULL;
}

static void on_all(void* (*body)(void*)) {
    pthread_t threads[host_threads];
    int k;
    for (k = 0; k < host_threads; ++k)
        REQUIRE(pthread_create(&threads[k], NULL, body, (void*)(intptr_t)k) == 0);
    for (k = 0; k < host_threads; ++k) REQUIRE(pthread_join(threads[k], NULL) == 0);
}

int main(void) {
    p = make_points(point_count);
    expected = triangulate(&linked, p, 1, NULL);
    on_all(call);
    on_all(go_on);
    REQUIRE(thread_count() == 1);
    free_points(p);
    return 0;
}
