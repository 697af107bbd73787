/* SPDX-License-Identifier: MIT
 * A host that gives threads little room, or none: calls do with those that they get. */
#define _GNU_SOURCE
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include "linked.h"

static struct points p;
static uint64_t expected;

/* Calls with four threads when the host's threads have so much stack, and expects so many. */
static void with_stacks_of(size_t bytes, int least, int most) {
    pthread_attr_t before, attributes;
    int threads = 0;
    REQUIRE(pthread_getattr_default_np(&before) == 0);
    REQUIRE(pthread_attr_init(&attributes) == 0);
    REQUIRE(pthread_attr_setstacksize(&attributes, bytes) == 0);
    REQUIRE(pthread_setattr_default_np(&attributes) == 0);
    REQUIRE(triangulate(&linked, p, 4, &threads) == expected);
    REQUIRE(is_small() || (threads >= least && threads <= most));
    REQUIRE(pthread_setattr_default_np(&before) == 0);
    pthread_attr_destroy(&attributes);
    pthread_attr_destroy(&before);
}

static void* triangulate_here(void* threads) {
    REQUIRE(triangulate(&linked, p, 4, threads) == expected);
    return NULL;
}

/* The same from a thread of the host that has so much stack, the C library's share included. */
static void on_a_stack_of(size_t bytes) {
    pthread_attr_t attributes;
    pthread_t thread;
    int threads = 0;
    REQUIRE(pthread_attr_init(&attributes) == 0);
    REQUIRE(pthread_attr_setstacksize(&attributes, bytes) == 0);
    REQUIRE(pthread_create(&thread, &attributes, triangulate_here, &threads) == 0);
    REQUIRE(pthread_join(thread, NULL) == 0);
    REQUIRE(is_small() || threads == 4);
    pthread_attr_destroy(&attributes);
}

/* In a process of its own whose user may have so many threads: as somebody who has no other,
 * where this is run by root, whom the limit does not concern. */
static void with_thread_limit(rlim_t limit, int is_exact) {
    const struct rlimit threads_limit = {limit, limit};
    const uid_t somebody = 64321;
    int status = 0, threads = 0;
    pid_t child;
    if (is_exact && geteuid() != 0) return; /* how many threads the user has is not known */
    child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        if (geteuid() == 0) REQUIRE(setuid(somebody) == 0);
        REQUIRE(setrlimit(RLIMIT_NPROC, &threads_limit) == 0);
        REQUIRE(triangulate(&linked, p, 4, &threads) == expected);
        REQUIRE(is_small() || threads == (int)limit);
        free_points(p);
        _exit(0);
    }
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

int main(void) {
    int threads = 0;
    p = make_points(4 * 8192); /* each of four threads is worth it */
    expected = triangulate(&linked, p, 1, NULL);
    REQUIRE(triangulate(&linked, p, 4, &threads) == expected);
    REQUIRE(is_small() || threads == 4);
    with_stacks_of(128 * 1024, 4, 4); /* as musl has them */
    with_stacks_of(64 * 1024, 4, 4);  /* twice what the library takes */
    on_a_stack_of(64 * 1024);
    with_stacks_of((size_t)1 << 47, 1, 1); /* more than there are addresses: no thread starts */
    with_thread_limit(1, 0);
    with_thread_limit(3, 1);
    REQUIRE(triangulate(&linked, p, 4, &threads) == expected);
    REQUIRE(thread_count() == 1);
    free_points(p);
    return 0;
}
