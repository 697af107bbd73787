// SPDX-License-Identifier: MIT
// The functions of the C interface that handles have in common. Each macro defines a group of them
// for the handle mgdt_KIND, as its header documents them:
//
//   MGDT_LIFE(KIND)                create, create_with_allocator, destroy
//   MGDT_OPTIONS(KIND, own)        set_option, get_option
//   MGDT_DOUBLE_OPTIONS(KIND, own) set_double_option, get_double_option
//   MGDT_PROGRESS(KIND)            set_progress, get_progress, cancel
//   MGDT_RESULTS(KIND, Results)    get_stat, array_info, get_size, get_array, get_array_i32
//   MGDT_DOUBLES(KIND, Results)    get_doubles
//   MGDT_MESSAGE(KIND)             get_error
//
// `own` is the list of the options that this handle has beside those of all handles; {} if there
// are none (options.hpp). `Results` is a class with these static members:
//
//   statistics, arrays     the tables of the handle, as statistics.hpp and arrays.hpp define them
//   of(object)             returns the part of the handle's object that has the arrays
//   require(results)       throws if this part has no results yet
#pragma once

#include "capi/arrays.hpp"
#include "capi/options.hpp"
#include "capi/statistics.hpp"

// clang-format off
#define MGDT_LIFE(kind)                                                                           \
    extern "C" mgdt_status mgdt_##kind##_create(mgdt_##kind** out) {                              \
        return create_handle(out, nullptr, nullptr, nullptr);                                     \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_create_with_allocator(                                   \
        mgdt_alloc_fn alloc, mgdt_free_fn release, void* user, mgdt_##kind** out) {               \
        return create_handle(out, alloc, release, user);                                          \
    }                                                                                             \
    extern "C" void mgdt_##kind##_destroy(mgdt_##kind* h) { destroy_handle(h); }

#define MGDT_OPTIONS(kind, own)                                                                   \
    extern "C" mgdt_status mgdt_##kind##_set_option(mgdt_##kind* h, int32_t option,               \
                                                    int64_t value) {                              \
        return set_option(h, option, value, own);                                                 \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_get_option(const mgdt_##kind* h, int32_t option,         \
                                                    int64_t* value) {                             \
        return get_option(h, option, value, own);                                                 \
    }

#define MGDT_DOUBLE_OPTIONS(kind, own)                                                            \
    extern "C" mgdt_status mgdt_##kind##_set_double_option(mgdt_##kind* h, int32_t option,        \
                                                           double value) {                        \
        return set_double_option(h, option, value, own);                                          \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_get_double_option(const mgdt_##kind* h, int32_t option,  \
                                                           double* value) {                       \
        return get_double_option(h, option, value, own);                                          \
    }

#define MGDT_PROGRESS(kind)                                                                       \
    extern "C" mgdt_status mgdt_##kind##_set_progress(mgdt_##kind* h, mgdt_progress_fn fn,        \
                                                      void* user) {                               \
        return set_progress(h, fn, user);                                                         \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_get_progress(const mgdt_##kind* h, mgdt_progress_fn* fn, \
                                                      void** user) {                              \
        return get_progress(h, fn, user);                                                         \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_cancel(mgdt_##kind* h) { return cancel(h); }

#define MGDT_RESULTS(kind, Results)                                                               \
    extern "C" mgdt_status mgdt_##kind##_get_stat(const mgdt_##kind* h, int32_t key,              \
                                                  int64_t* value) {                               \
        return get_stat(h, h ? &h->object : nullptr, Results::statistics, key, value);            \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_array_info(int32_t array, int32_t* columns,              \
                                                    int32_t* is_double) {                         \
        return array_info(Results::arrays, array, columns, is_double);                            \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_get_size(const mgdt_##kind* h, int32_t array,            \
                                                  int64_t* size) {                                \
        return get_size<Results>(h, array, size);                                                 \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_get_array(const mgdt_##kind* h, int32_t array,           \
                                                   int64_t capacity, int64_t* values) {           \
        return get_elements<Results>(h, array, capacity, values);                                 \
    }                                                                                             \
    extern "C" mgdt_status mgdt_##kind##_get_array_i32(const mgdt_##kind* h, int32_t array,       \
                                                       int64_t capacity, int32_t* values) {       \
        return get_elements<Results>(h, array, capacity, values);                                 \
    }

#define MGDT_DOUBLES(kind, Results)                                                               \
    extern "C" mgdt_status mgdt_##kind##_get_doubles(const mgdt_##kind* h, int32_t array,         \
                                                     int64_t capacity, double* values) {          \
        return get_elements<Results>(h, array, capacity, values);                                 \
    }

#define MGDT_MESSAGE(kind)                                                                        \
    extern "C" mgdt_status mgdt_##kind##_get_error(const mgdt_##kind* h, int64_t capacity,        \
                                                   char* buffer) {                                \
        return get_message(h, capacity, buffer);                                                  \
    }
// clang-format on
