/* SPDX-License-Identifier: MIT
 * What the parts of the gateway share: errors, arguments, results and progress. */
#ifndef MGDT_OCTAVE_SUPPORT_H
#define MGDT_OCTAVE_SUPPORT_H

#include <mex.h>

#include "mgdt_library.h"

/* ------------------------------------------------------------------------------------- errors */

static const char* identifier(mgdt_status s) {
    switch (s) {
#define MGDT_CASE(NAME, name) \
    case MGDT_ERR_##NAME:     \
        return "mgdt:" #name;
        MGDT_ERRORS(MGDT_CASE)
#undef MGDT_CASE
        default:
            return "mgdt:internal";
    }
}

static void ensure(const mgdt_triangulation* t, mgdt_status s) {
    char message[256] = "";
    if (s == MGDT_OK) return;
    if (t) mgdt.get_error(t, (int64_t)sizeof message, message);
    mexErrMsgIdAndTxt(identifier(s), "%s", *message ? message : mgdt.status_string(s));
}

static void bad_argument(const char* what) {
    mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s", what);
}

static void* room(int64_t count, size_t size) {
    return mxMalloc(((size_t)count + 1) * size);
}

/* ---------------------------------------------------------------------------------- arguments */

static double number(const mxArray* a, const char* what) {
    if (!a || mxGetNumberOfElements(a) != 1 || mxIsComplex(a) ||
        !(mxIsNumeric(a) || mxIsLogical(a)))
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s must be one real number", what);
    return mxGetScalar(a);
}

static int64_t integer(const mxArray* a, const char* what, double limit) {
    const double x = number(a, what);
    if (!(x >= -limit && x <= limit) || x != (double)(int64_t)x)
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s is %g; it must be a whole number", what, x);
    return (int64_t)x;
}

static int32_t small(const mxArray* a, const char* what) {
    return (int32_t)integer(a, what, 2147483647.0);
}

static const char* text(const mxArray* a, const char* what) {
    char* string;
    if (!a || !mxIsChar(a)) mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s must be a string", what);
    string = mxArrayToString(a);
    if (!string) bad_argument("out of memory");
    return string;
}

/* Points as an n x 3 matrix of doubles, which is x, y and z in separate arrays; [] for none. */
static const double* columns(const mxArray* a, int width, const char* what, int64_t* n) {
    *n = 0;
    if (!a || !mxIsDouble(a) || mxIsComplex(a) || mxIsSparse(a))
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s must be a full real matrix of doubles",
                          what);
    if (mxIsEmpty(a)) return NULL;
    if (mxGetNumberOfDimensions(a) != 2 || mxGetN(a) != (size_t)width)
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s are %d x %d; they must have %s columns",
                          what, (int)mxGetM(a), (int)(mxGetNumberOfElements(a) / mxGetM(a)),
                          width == 3 ? "three" : "four");
    *n = (int64_t)mxGetM(a);
    return mxGetPr(a);
}

static const double* points(const mxArray* a, int64_t* n) {
    return columns(a, 3, "points", n);
}

/* A vector of whole numbers. */
static const int64_t* whole_numbers(const mxArray* a, const char* what, int64_t* n) {
    int64_t* list;
    int64_t k;
    if (!a || !mxIsDouble(a) || mxIsComplex(a) || mxIsSparse(a))
        mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s must be a full real vector of doubles",
                          what);
    *n = (int64_t)mxGetNumberOfElements(a);
    list = room(*n, sizeof *list);
    for (k = 0; k < *n; ++k) {
        const double x = mxGetPr(a)[k];
        if (!(x >= -9e15 && x <= 9e15) || x != (double)(int64_t)x)
            mexErrMsgIdAndTxt("mgdt:invalid_argument", "%s: %g is no whole number", what, x);
        list[k] = (int64_t)x;
    }
    return list;
}

/* The rows of a matrix one behind the other, as the library wants places. */
static const double* one_by_one(const double* from, int width, int64_t n) {
    double* const x = room(width * n, sizeof *x);
    int64_t k;
    int i;
    for (k = 0; k < n; ++k)
        for (i = 0; i < width; ++i) x[width * k + i] = from[i * n + k];
    return x;
}

/* ------------------------------------------------------------------------------------ results */

/* A matrix of doubles, one row for each `width` integers of the library's. */
static mxArray* rows(const int64_t* from, int64_t count, int width) {
    mxArray* const result = mxCreateDoubleMatrix((mwSize)count, (mwSize)width, mxREAL);
    double* const to = mxGetPr(result);
    int64_t k;
    int i;
    for (k = 0; k < count; ++k)
        for (i = 0; i < width; ++i) to[i * count + k] = (double)from[width * k + i];
    return result;
}

/* A matrix of doubles, one row for each `width` of the library's. */
static mxArray* rows_of_doubles(const double* from, int64_t count, int64_t width) {
    mxArray* const result = mxCreateDoubleMatrix((mwSize)count, (mwSize)width, mxREAL);
    double* const to = mxGetPr(result);
    int64_t k, i;
    for (k = 0; k < count; ++k)
        for (i = 0; i < width; ++i) to[i * count + k] = from[width * k + i];
    return result;
}

/* For a handle in a static variable: ensure_HANDLE(), which ends the call with the message of a
 * failure after close() has freed the handle, and array_of_HANDLE(), which reads an array. */
#define DEFINE_READER(handle, kind, close)                                                  \
    static void ensure_##handle(mgdt_status s) {                                            \
        char message[256] = "";                                                             \
        if (s == MGDT_OK) return;                                                           \
        mgdt.kind##_get_error(handle, (int64_t)sizeof message, message);                    \
        close();                                                                            \
        mexErrMsgIdAndTxt(identifier(s), "%s", *message ? message : mgdt.status_string(s)); \
    }                                                                                       \
    static mxArray* array_of_##handle(int32_t key) {                                        \
        int64_t count = 0;                                                                  \
        int32_t width = 1, is_double = 0;                                                   \
        mxArray* result;                                                                    \
        mgdt.kind##_array_info(key, &width, &is_double);                                    \
        ensure_##handle(mgdt.kind##_get_size(handle, key, &count));                         \
        if (is_double) {                                                                    \
            double* const x = room(count, sizeof *x);                                       \
            ensure_##handle(mgdt.kind##_get_doubles(handle, key, count, x));                \
            result = rows_of_doubles(x, count / width, width);                              \
            mxFree(x);                                                                      \
        } else {                                                                            \
            int64_t* const v = room(count, sizeof *v);                                      \
            ensure_##handle(mgdt.kind##_get_array(handle, key, count, v));                  \
            result = rows(v, count / width, width);                                         \
            mxFree(v);                                                                      \
        }                                                                                   \
        return result;                                                                      \
    }

/* ----------------------------------------------------------------------------------- progress */

typedef struct {
    mxArray* function;
    mxArray* problem; /* a struct for rethrow, or NULL */
} progress;

/* Calls `through`, which calls the function with one argument. Destroys the argument. Returns the
 * answer, or NULL: an error must not pass through the library, so it is kept, and raised again
 * afterwards. */
static mxArray* ask(progress* p, const char* through, mxArray* argument) {
    mxArray* arguments[2];
    mxArray* answer[2] = {NULL, NULL};
    arguments[0] = p->function;
    arguments[1] = argument;
    p->problem = mexCallMATLABWithTrap(2, answer, 2, arguments, through);
    mxDestroyArray(argument);
    if (!p->problem && mxIsEmpty(answer[1])) {
        mxDestroyArray(answer[1]);
        return answer[0];
    }
    if (!p->problem) p->problem = answer[1];
    if (answer[0]) mxDestroyArray(answer[0]);
    return NULL;
}

static int32_t report(double fraction, void* user) {
    mxArray* const answer = ask(user, "mgdt_progress", mxCreateDoubleScalar(fraction));
    int32_t stop = 1;
    if (answer) {
        stop = mxGetScalar(answer) != 0;
        mxDestroyArray(answer);
    }
    return stop;
}

#endif /* MGDT_OCTAVE_SUPPORT_H */
