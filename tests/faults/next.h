/* SPDX-License-Identifier: MIT
 * For what stands before functions of the C library: the functions behind. */
#ifndef MGDT_TESTS_FAULTS_NEXT_H
#define MGDT_TESTS_FAULTS_NEXT_H

#include <dlfcn.h> /* which declares RTLD_NEXT where _GNU_SOURCE is defined */
#include <string.h>

/* Once for each pointer; the dynamic linker does not allocate for this. */
#define LOOK_UP(pointer, name)                      \
    if (pointer == NULL) {                          \
        void* const found = dlsym(RTLD_NEXT, name); \
        memcpy(&pointer, &found, sizeof pointer);   \
    }

/* The one of that name, as `next`. */
#define NEXT(result, name, parameters) \
    static result(*next) parameters;   \
    LOOK_UP(next, #name)

#endif
