/* SPDX-License-Identifier: MIT
 * An allocator of a host that counts its blocks, may refuse one of its calls, and may do something
 * else at one of them, such as to cancel. In C99, after _POSIX_C_SOURCE, and C++17. */
#ifndef MGDT_TESTS_COUNTING_ALLOCATOR_H
#define MGDT_TESTS_COUNTING_ALLOCATOR_H

#include <stdint.h>

#include "aligned.h"

typedef struct {
    int64_t blocks; /* that were not given back */
    int64_t calls;
    int64_t refuse_at, act_at; /* numbers of calls, from 1; 0 for none */
    void (*act)(void* on);
    void* on;
} counting_allocator;

/* `user` is the counting_allocator. */
static inline void* counted_allocate(size_t size, size_t align, void* user) {
    counting_allocator* const a = (counting_allocator*)user;
    void* p;
    if (++a->calls == a->refuse_at) return NULL;
    if (a->calls == a->act_at) a->act(a->on);
    p = allocate_aligned(size, align);
    if (p != NULL) ++a->blocks;
    return p;
}
static inline void counted_release(void* p, size_t size, size_t align, void* user) {
    (void)size;
    (void)align;
    --((counting_allocator*)user)->blocks;
    free_aligned(p);
}

#endif
