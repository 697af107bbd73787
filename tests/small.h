/* SPDX-License-Identifier: MIT
 * Under Valgrind and the like, tests take smaller sets. In C99 and C++17. */
#ifndef MGDT_TESTS_SMALL_H
#define MGDT_TESTS_SMALL_H

#include <stdlib.h>
#include <string.h>

static inline int is_small(void) {
    const char* const value = getenv("MGDT_TEST_SMALL");
    return value != NULL && *value != '\0' && strcmp(value, "0") != 0;
}

#endif
