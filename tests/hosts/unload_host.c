/* SPDX-License-Identifier: MIT
 * A host that loads the library, calls it with threads, and unloads it, again and again: nothing
 * is left running, mapped or allocated.
 *
 *   unload_host LIBRARY */
#define _DEFAULT_SOURCE
#include <dlfcn.h>
#include <malloc.h>

#include "host.h"

static void* function(void* handle, const char* name) {
    void* const f = dlsym(handle, name);
    REQUIRE(f != NULL);
    return f;
}

static uint64_t load_and_call(const char* path, struct points p, int32_t threads) {
    struct library lib;
    uint64_t result;
    void* const handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (handle == NULL) fprintf(stderr, "%s\n", dlerror());
    REQUIRE(handle != NULL);
    *(void**)&lib.create = function(handle, "mgdt_create");
    *(void**)&lib.destroy = function(handle, "mgdt_destroy");
    *(void**)&lib.set_threads = function(handle, "mgdt_set_threads");
    *(void**)&lib.set_canonical_output = function(handle, "mgdt_set_canonical_output");
    *(void**)&lib.insert_points = function(handle, "mgdt_insert_points");
    *(void**)&lib.tetrahedron_count = function(handle, "mgdt_tetrahedron_count");
    *(void**)&lib.get_tetrahedra = function(handle, "mgdt_get_tetrahedra");
    *(void**)&lib.locate_points = function(handle, "mgdt_locate_points");
    *(void**)&lib.get_stat = function(handle, "mgdt_get_stat");
    result = triangulate(&lib, p, threads, NULL);
    REQUIRE(dlclose(handle) == 0);
    REQUIRE(dlopen(path, RTLD_NOW | RTLD_NOLOAD) == NULL); /* it is really gone */
    return result;
}

/* Exact where the C library keeps no small blocks for each thread. */
static size_t allocated(void) {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    return mallinfo2().uordblks;
#else
    return 0;
#endif
}

int main(int argc, char** argv) {
    const int times = is_small() ? 4 : 50;
    const struct points p = make_points(point_count);
    uint64_t expected;
    size_t before = 0;
    int k;
    REQUIRE(argc == 2);
    expected = load_and_call(argv[1], p, 1);
    for (k = 0; k < times; ++k) {
        REQUIRE(load_and_call(argv[1], p, 3) == expected);
        REQUIRE(thread_count() == 1);
        if (k < times / 2 && allocated() > before) before = allocated();
    }
    REQUIRE(allocated() <= before);
    free_points(p);
    return 0;
}
