/* SPDX-License-Identifier: MIT
 * An allocator that knows how much it has out, for test_life.f90. */
#include <stdint.h>
#include <stdlib.h>

void* counting_alloc(size_t size, size_t align, void* user) {
    void* p = NULL;
    if (posix_memalign(&p, align < sizeof(void*) ? sizeof(void*) : align, size) != 0) return NULL;
    *(int64_t*)user += (int64_t)size;
    return p;
}

void counting_free(void* p, size_t size, size_t align, void* user) {
    (void)align;
    *(int64_t*)user -= (int64_t)size;
    free(p);
}
