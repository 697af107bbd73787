/* SPDX-License-Identifier: MIT
 * Refusals at will: the N-th request for memory, pages or a thread fails. Requests to the handle's
 * allocator are counted by handle_take(); those to the system by what interpose.c puts in its
 * way, where that is linked. */
#ifndef MGDT_TESTS_FAULTS_FAULTS_H
#define MGDT_TESTS_FAULTS_FAULTS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    fault_handle = 1,  /* the allocator given to mgdt_create_with_allocator() */
    fault_malloc = 2,  /* malloc and its kin, operator new */
    fault_map = 4,     /* mmap, mremap */
    fault_advice = 8,  /* madvise */
    fault_thread = 16, /* pthread_create */
    fault_kinds = 5
};

/* From here on requests of these kinds are counted, and those from the `from`-th to the one before
 * the `to`-th, counted from 1 over all of these kinds, are refused. */
void fault_arm(unsigned kinds, int64_t from, int64_t to);
/* Refuses nothing any more; how many requests were counted. */
int64_t fault_disarm(void);
/* How many requests of one kind there were since fault_arm(), armed for it or not. */
int64_t fault_requests(unsigned kind);

/* Counts a request; whether it is to be refused. */
int fault_is_due(unsigned kind);
/* Blocks taken and not given back, by anybody in the process. */
int64_t fault_balance(void);
void fault_took(int64_t blocks);

/* An allocator of handles, which checks that blocks come back as they were taken. */
void* handle_take(size_t size, size_t align, void* user);
void handle_give(void* p, size_t size, size_t align, void* user);
/* Blocks that came back with another size or alignment, or twice. */
int64_t handle_errors(void);

#ifdef __cplusplus
}
#endif

#endif
