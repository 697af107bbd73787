/* SPDX-License-Identifier: MIT
 * A host that forks: between two calls with threads, and while another of its threads is inside
 * one. */
#define _DEFAULT_SOURCE
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>

#include "linked.h"

static struct points p;
static uint64_t expected;

/* Whether the process ended well. One that waits for a lock which nobody holds any more is ended
 * by its alarm. */
static int ended_well(pid_t child) {
    int status = 0;
    if (child <= 0 || waitpid(child, &status, 0) != child) return 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) == 0 : WTERMSIG(status) == SIGKILL;
}

static void after_a_call(void) {
    mgdt_triangulation* t = NULL;
    pid_t child;
    REQUIRE(mgdt_create(&t) == MGDT_OK);
    REQUIRE(mgdt_set_threads(t, 3) == MGDT_OK);
    REQUIRE(mgdt_set_canonical_output(t, 1) == MGDT_OK);
    REQUIRE(fill_and_locate(&linked, t, p, NULL) == expected);
    REQUIRE(thread_count() == 1);
    child = fork();
    if (child == 0) {
        alarm(120);
        REQUIRE(triangulate(&linked, p, 2, NULL) == expected);
        /* The parent's handle is the child's own now. */
        REQUIRE(fill_and_locate(&linked, t, p, NULL) == expected);
        REQUIRE(mgdt_check(t, MGDT_CHECK_COMBINATORIAL) == MGDT_OK);
        mgdt_destroy(t);
        free_points(p);
        _exit(0);
    }
    REQUIRE(fill_and_locate(&linked, t, p, NULL) == expected);
    REQUIRE(mgdt_check(t, MGDT_CHECK_COMBINATORIAL) == MGDT_OK);
    REQUIRE(ended_well(child));
    mgdt_destroy(t);
}

static int is_over;
static pthread_mutex_t over_mutex = PTHREAD_MUTEX_INITIALIZER;

static int over(int now) {
    int result;
    pthread_mutex_lock(&over_mutex);
    is_over = is_over || now;
    result = is_over;
    pthread_mutex_unlock(&over_mutex);
    return result;
}

static void* call_again_and_again(void* unused) {
    (void)unused;
    while (!over(0)) REQUIRE(triangulate(&linked, p, 2, NULL) == expected);
    return NULL;
}

static void inside_a_call(void) {
    const int forks = is_small() ? 2 : 8;
    pthread_t other;
    int k;
    REQUIRE(pthread_create(&other, NULL, call_again_and_again, NULL) == 0);
    for (k = 0; k < forks; ++k) {
        pid_t child;
        usleep((useconds_t)(3000 + 1700 * k)); /* another moment of the call each time */
        child = fork();
        if (child == 0) {
            alarm(120);
            REQUIRE(thread_count() == 1);
            REQUIRE(triangulate(&linked, p, 2, NULL) == expected);
            /* What the other thread held is lost in the child; this way Valgrind does not count it.
             */
            raise(SIGKILL);
        }
        REQUIRE(ended_well(child));
    }
    over(1);
    REQUIRE(pthread_join(other, NULL) == 0);
}

int main(void) {
    p = make_points(point_count);
    expected = triangulate(&linked, p, 1, NULL);
    after_a_call();
    inside_a_call();
    REQUIRE(thread_count() == 1);
    free_points(p);
    return 0;
}
