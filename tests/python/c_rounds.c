/* SPDX-License-Identifier: MIT
 * The C side of overhead.py: reads points from a file of raw doubles, and for each line of standard
 * input does one round of the same work and prints the seconds it took. */
#define _POSIX_C_SOURCE 200112L
#include <mgdt/mgdt.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Inserts the points and takes tetrahedra and neighbours out, as Python does: handle and arrays are
 * kept until the clock has stopped. */
static double round_seconds(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    int32_t *tetrahedra = NULL, *neighbors = NULL;
    int64_t size = 0;
    mgdt_status s;
    double seconds = -1;
    const double begin = now();
    s = mgdt_create(&t);
    if (s == MGDT_OK) s = mgdt_insert_points(t, n, xyz);
    if (s == MGDT_OK) {
        size = 4 * mgdt_tetrahedron_count(t);
        tetrahedra = malloc((size_t)size * sizeof *tetrahedra);
        neighbors = malloc((size_t)size * sizeof *neighbors);
        s = tetrahedra && neighbors ? mgdt_get_tetrahedra_i32(t, size, tetrahedra)
                                    : MGDT_ERR_OUT_OF_MEMORY;
    }
    if (s == MGDT_OK) s = mgdt_get_neighbors_i32(t, size, neighbors);
    if (s == MGDT_OK) seconds = now() - begin;
    free(tetrahedra);
    free(neighbors);
    mgdt_destroy(t);
    return seconds;
}

int main(int argc, char** argv) {
    FILE* file = argc == 3 ? fopen(argv[1], "rb") : NULL;
    const int64_t n = argc == 3 ? atoll(argv[2]) : 0;
    double* xyz = n > 0 ? malloc((size_t)n * 3 * sizeof *xyz) : NULL;
    int c;
    if (!file || !xyz || fread(xyz, 3 * sizeof *xyz, (size_t)n, file) != (size_t)n) {
        fprintf(stderr, "usage: c_rounds FILE NUMBER_OF_POINTS\n");
        return 2;
    }
    fclose(file);
    while ((c = getchar()) != EOF) {
        double seconds;
        if (c != '\n') continue;
        seconds = round_seconds(n, xyz);
        if (seconds < 0) return 1;
        printf("%.6f\n", seconds);
        fflush(stdout);
    }
    free(xyz);
    return 0;
}
