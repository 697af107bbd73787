/* SPDX-License-Identifier: MIT
 * Inserts uniform points with one thread: a load for what counts instructions.
 *
 *   insertions N
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "mgdt/mgdt.h"

int main(int argc, char** argv) {
    const int64_t n = argc == 2 ? strtoll(argv[1], NULL, 10) : 0;
    double* xyz = n > 0 && n <= 100000000 ? malloc(3 * (size_t)n * sizeof *xyz) : NULL;
    mgdt_triangulation* t = NULL;
    uint64_t state = 1;
    int64_t i;
    mgdt_status status;
    if (xyz == NULL) {
        fprintf(stderr, "usage: insertions N\n");
        return 2;
    }
    for (i = 0; i < 3 * n; ++i) {
        /* xorshift64 (G. Marsaglia, 2003) */
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        xyz[i] = (double)(state >> 11) / 9007199254740992.0;
    }
    status = mgdt_create(&t);
    if (status == MGDT_OK) status = mgdt_set_threads(t, 1);
    if (status == MGDT_OK) status = mgdt_insert_points(t, n, xyz);
    if (status != MGDT_OK) {
        fprintf(stderr, "insertions: %s\n", mgdt_status_string(status));
        return 1;
    }
    printf("%s, %" PRId64 " points, %" PRId64 " tetrahedra\n", mgdt_isa_name(t), n,
           mgdt_tetrahedron_count(t));
    mgdt_destroy(t);
    free(xyz);
    return 0;
}
