/* SPDX-License-Identifier: MIT
 * Sizes of the sets that tests take. The variable MGDT_TEST_SMALL is 0 or not set for all of them,
 * 1 for smaller ones, and 2 for the smallest, under tools that make each instruction many times as
 * slow. In C99 and C++17. */
#ifndef MGDT_TESTS_SMALL_H
#define MGDT_TESTS_SMALL_H

#include <stdlib.h>
#include <string.h>

static inline int is_small(void) {
    const char* const value = getenv("MGDT_TEST_SMALL");
    return value != NULL && *value != '\0' && strcmp(value, "0") != 0;
}

static inline int is_smallest(void) {
    const char* const value = getenv("MGDT_TEST_SMALL");
    return value != NULL && strcmp(value, "2") == 0;
}

/* A number of cases: a third of them in smaller sets, a tenth in the smallest, and at least one. */
static inline int fewer(int cases) {
    return is_smallest() ? (cases + 9) / 10 : is_small() ? (cases + 2) / 3 : cases;
}

#endif
