/* SPDX-License-Identifier: MIT
 * Aligned memory for the hosts' allocators in tests. In C99, after _POSIX_C_SOURCE, and C++17. */
#ifndef MGDT_TESTS_ALIGNED_H
#define MGDT_TESTS_ALIGNED_H

#include <stdlib.h>
#if defined(_WIN32)
#include <malloc.h>
#endif

static inline void* allocate_aligned(size_t bytes, size_t align) {
#if defined(_WIN32)
    return _aligned_malloc(bytes, align);
#else
    void* p = NULL;
    return posix_memalign(&p, align < sizeof p ? sizeof p : align, bytes) == 0 ? p : NULL;
#endif
}
static inline void free_aligned(void* p) {
#if defined(_WIN32)
    _aligned_free(p);
#else
    free(p);
#endif
}

#endif
