/* SPDX-License-Identifier: MIT
 * The mgdt library, loaded when it is first needed: the one that MGDT_LIBRARY names, or else
 * libmgdt.so.1 as the loader finds it. So compiling takes the header alone. */
#ifndef MGDT_OCTAVE_LIBRARY_H
#define MGDT_OCTAVE_LIBRARY_H

#include <dlfcn.h>
#include <mgdt/mgdt.h>
#include <mgdt/mgdt_domain.h>
#include <mgdt/mgdt_mesh.h>
#include <mgdt/mgdt_periodic.h>
#include <mgdt/mgdt_voronoi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mgdt_interface.h"

#if defined(__APPLE__)
#define MGDT_LIBRARY_NAME "libmgdt.1.dylib"
#else
#define MGDT_LIBRARY_NAME "libmgdt.so.1"
#endif

/* The library's functions: mgdt.create is mgdt_create. */
static struct {
#define MGDT_MEMBER(name) __typeof__(&mgdt_##name) name
    MGDT_FUNCTIONS(MGDT_MEMBER)
#undef MGDT_MEMBER
} mgdt;

/* A function's address as dlsym gives it, stored where a pointer to a function is. */
static int mgdt_find(void* library, const char* name, void* to) {
    void* const address = dlsym(library, name);
    memcpy(to, &address, sizeof address);
    return address != NULL;
}

/* Loads the library. Gives 1, or 0 and what was tried in `problem`. */
static int mgdt_load(char* problem, size_t size) {
    static void* library;
    const char* const chosen = getenv("MGDT_LIBRARY");
    const int is_chosen = chosen && *chosen;
    const char* const name = is_chosen ? chosen : MGDT_LIBRARY_NAME;
    __typeof__(&mgdt_abi_version) abi_version;

    if (library) return 1;
    library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        snprintf(problem, size,
                 "the mgdt library was not found; set MGDT_LIBRARY to its file. Tried:\n  %s%s: %s",
                 name, is_chosen ? " (from MGDT_LIBRARY)" : "", dlerror());
        return 0;
    }
    if (!mgdt_find(library, "mgdt_abi_version", &abi_version)) {
        snprintf(problem, size, "%s is not the mgdt library: it has no mgdt_abi_version", name);
    } else if (abi_version() != 1) {
        snprintf(problem, size, "%s has ABI version %d; mgdt_mex needs 1", name,
                 (int)abi_version());
    } else {
        const char* missing = NULL;
#define MGDT_FIND(function) \
    if (!mgdt_find(library, "mgdt_" #function, &mgdt.function)) missing = "mgdt_" #function
        MGDT_FUNCTIONS(MGDT_FIND)
#undef MGDT_FIND
        if (!missing) return 1;
        snprintf(problem, size, "%s has no %s", name, missing);
    }
    dlclose(library);
    library = NULL;
    return 0;
}

#endif /* MGDT_OCTAVE_LIBRARY_H */
