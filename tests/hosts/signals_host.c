/* SPDX-License-Identifier: MIT
 * A host whose timers interrupt it all the time: its handlers run on its own threads, which they
 * may count on, and calls do not mind. */
#define _GNU_SOURCE
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/time.h>

#include "linked.h"

static volatile sig_atomic_t alarms, profiles, elsewhere;
static pid_t host_threads[2];

static void count(int signal) {
    const int before = errno;
    const pid_t self = (pid_t)syscall(SYS_gettid);
    if (self != host_threads[0] && self != host_threads[1]) elsewhere = 1;
    if (signal == SIGALRM)
        ++alarms;
    else
        ++profiles;
    errno = before;
}

static struct points p;
static uint64_t expected;

static void call_until(int least) {
    int calls = 0;
    while (calls < 2 || alarms < least || profiles < least) {
        REQUIRE(triangulate(&linked, p, 2, NULL) == expected);
        REQUIRE(++calls < 10000);
    }
}

/* A second host thread, which has the signals to itself while the first calls. */
static void* listen(void* is_over) {
    sigset_t none;
    host_threads[1] = (pid_t)syscall(SYS_gettid);
    sigemptyset(&none);
    pthread_sigmask(SIG_SETMASK, &none, NULL);
    while (!__atomic_load_n((int*)is_over, __ATOMIC_ACQUIRE)) usleep(1000);
    return NULL;
}

int main(void) {
    const int least = is_small() ? 5 : 20;
    const struct itimerval period = {{0, 500}, {0, 500}}, never = {{0, 0}, {0, 0}};
    struct sigaction action;
    sigset_t timers, mask;
    pthread_t other;
    int is_over = 0;
    p = make_points(point_count);
    expected = triangulate(&linked, p, 1, NULL);
    host_threads[0] = host_threads[1] = (pid_t)syscall(SYS_gettid);

    memset(&action, 0, sizeof action);
    action.sa_handler = count; /* without SA_RESTART: what can be interrupted is */
    REQUIRE(sigaction(SIGALRM, &action, NULL) == 0 && sigaction(SIGPROF, &action, NULL) == 0);
    REQUIRE(setitimer(ITIMER_REAL, &period, NULL) == 0);
    REQUIRE(setitimer(ITIMER_PROF, &period, NULL) == 0);
    call_until(least);

    /* The host's mask is left as it was. */
    sigemptyset(&timers);
    sigaddset(&timers, SIGALRM);
    sigaddset(&timers, SIGPROF);
    REQUIRE(pthread_sigmask(SIG_BLOCK, &timers, NULL) == 0);
    REQUIRE(pthread_create(&other, NULL, listen, &is_over) == 0);
    alarms = profiles = 0;
    call_until(least);
    REQUIRE(pthread_sigmask(SIG_BLOCK, NULL, &mask) == 0);
    REQUIRE(sigismember(&mask, SIGALRM) == 1 && sigismember(&mask, SIGPROF) == 1);
    REQUIRE(sigismember(&mask, SIGINT) == 0 && sigismember(&mask, SIGTERM) == 0);

    REQUIRE(setitimer(ITIMER_REAL, &never, NULL) == 0);
    REQUIRE(setitimer(ITIMER_PROF, &never, NULL) == 0);
    __atomic_store_n(&is_over, 1, __ATOMIC_RELEASE);
    REQUIRE(pthread_join(other, NULL) == 0);
    REQUIRE(!elsewhere);
    free_points(p);
    return 0;
}
