/* SPDX-License-Identifier: MIT
 * The rule of keys, which all handles have: options are 1 to 99, statistics 100 to 199, arrays of
 * integers 200 to 299, arrays of doubles 300 to 399. */
#ifndef MGDT_TESTS_KEYS_H
#define MGDT_TESTS_KEYS_H

#include <stdlib.h>

#include "check.h"

/* Counts in `found` the arrays of a handle of mgdt_KIND_ functions, and checks that each key is one
 * thing at most. `option` is the status for an option `key`. */
#define CHECK_KINDS_OF_KEYS(KIND, handle, option, found)                                      \
    do {                                                                                      \
        int64_t* const wide_ = malloc(100000 * sizeof *wide_);                                \
        int32_t* const narrow_ = malloc(100000 * sizeof *narrow_);                            \
        double* const x_ = malloc(100000 * sizeof *x_);                                       \
        (found) = 0;                                                                          \
        for (key = 0; key < 500; ++key) {                                                     \
            int64_t value_;                                                                   \
            int32_t columns_;                                                                 \
            const int is_option = (option) == MGDT_OK,                                        \
                      is_stat = mgdt_##KIND##_get_stat(handle, key, &value_) == MGDT_OK,      \
                      is_array = mgdt_##KIND##_get_size(handle, key, &value_) == MGDT_OK;     \
            const mgdt_status s = mgdt_##KIND##_get_array(handle, key, 100000, wide_),        \
                              t = mgdt_##KIND##_get_doubles(handle, key, 100000, x_);         \
            CHECK(is_option + is_stat + is_array <= 1);                                       \
            CHECK_EQUAL(is_array, (s == MGDT_OK) + (t == MGDT_OK));                           \
            CHECK_EQUAL(mgdt_##KIND##_get_array_i32(handle, key, 100000, narrow_), s);        \
            CHECK_EQUAL(mgdt_##KIND##_array_info(key, &columns_, NULL) == MGDT_OK, is_array); \
            if (is_option) CHECK(key >= 1 && key < 100);                                      \
            if (is_stat) CHECK(key >= 100 && key < 200);                                      \
            if (s == MGDT_OK) CHECK(key >= 200 && key < 300);                                 \
            if (t == MGDT_OK) CHECK(key >= 300 && key < 400);                                 \
            if (s != MGDT_OK) CHECK_EQUAL(s, MGDT_ERR_UNKNOWN_KEY);                           \
            if (t != MGDT_OK) CHECK_EQUAL(t, MGDT_ERR_UNKNOWN_KEY);                           \
            (found) += is_array;                                                              \
        }                                                                                     \
        free(wide_);                                                                          \
        free(narrow_);                                                                        \
        free(x_);                                                                             \
    } while (0)

#endif /* MGDT_TESTS_KEYS_H */
