/* SPDX-License-Identifier: MIT
 * Stands before malloc, mmap and pthread_create for the whole program, the library included, and
 * refuses when faults.h says so. */
#define _GNU_SOURCE
#include <errno.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdlib.h>
#include <sys/mman.h>

#include "faults.h"
#include "next.h"

static void* counted(void* p) {
    if (p != NULL) fault_took(1);
    return p;
}

static int refused(void) {
    if (!fault_is_due(fault_malloc)) return 0;
    errno = ENOMEM;
    return 1;
}

void* malloc(size_t size) {
    NEXT(void*, malloc, (size_t));
    return refused() ? NULL : counted(next(size));
}

void* calloc(size_t count, size_t size) {
    NEXT(void*, calloc, (size_t, size_t));
    return refused() ? NULL : counted(next(count, size));
}

void* realloc(void* p, size_t size) {
    NEXT(void*, realloc, (void*, size_t));
    if (refused()) return NULL;
    return p == NULL ? counted(next(p, size)) : next(p, size);
}

void* aligned_alloc(size_t align, size_t size) {
    NEXT(void*, aligned_alloc, (size_t, size_t));
    return refused() ? NULL : counted(next(align, size));
}

void* memalign(size_t align, size_t size) {
    NEXT(void*, memalign, (size_t, size_t));
    return refused() ? NULL : counted(next(align, size));
}

int posix_memalign(void** p, size_t align, size_t size) {
    NEXT(int, posix_memalign, (void**, size_t, size_t));
    int result;
    if (refused()) return ENOMEM;
    result = next(p, align, size);
    if (result == 0) fault_took(1);
    return result;
}

void free(void* p) {
    NEXT(void, free, (void*));
    if (p != NULL) fault_took(-1);
    next(p);
}

void* mmap(void* address, size_t size, int protection, int flags, int file, off_t offset) {
    NEXT(void*, mmap, (void*, size_t, int, int, int, off_t));
    void* p = MAP_FAILED;
    if (fault_is_due(fault_map))
        errno = ENOMEM;
    else
        p = next(address, size, protection, flags, file, offset);
    if (p != MAP_FAILED) fault_took(1);
    return p;
}

int munmap(void* p, size_t size) {
    NEXT(int, munmap, (void*, size_t));
    fault_took(-1);
    return next(p, size);
}

void* mremap(void* p, size_t size, size_t new_size, int flags, ...) {
    NEXT(void*, mremap, (void*, size_t, size_t, int, ...));
    if (fault_is_due(fault_map)) {
        errno = ENOMEM;
        return MAP_FAILED;
    }
    return next(p, size, new_size, flags);
}

int madvise(void* p, size_t size, int advice) {
    NEXT(int, madvise, (void*, size_t, int));
    if (fault_is_due(fault_advice)) {
        errno = ENOMEM;
        return -1;
    }
    return next(p, size, advice);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*body)(void*),
                   void* argument) {
    NEXT(int, pthread_create, (pthread_t*, const pthread_attr_t*, void* (*)(void*), void*));
    return fault_is_due(fault_thread) ? EAGAIN : next(thread, attributes, body, argument);
}
