/* SPDX-License-Identifier: MIT
 * A program as a user writes it: C99, the public header, pkg-config. */
#include <mgdt/mgdt.h>
#include <stdio.h>
#include <stdlib.h>

int main(void) {
    static const double cube[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                                    0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    mgdt_triangulation* t = NULL;
    int64_t count, *v;
    mgdt_status status = mgdt_create(&t);
    if (status == MGDT_OK) status = mgdt_set_order_scheme(t, MGDT_ORDER_MULTI_GRID);
    if (status == MGDT_OK) status = mgdt_insert_points(t, 8, cube);
    if (status == MGDT_OK) status = mgdt_check(t, MGDT_CHECK_CANONICAL);
    count = mgdt_tetrahedron_count(t);
    v = malloc((size_t)(4 * count) * sizeof *v);
    if (status == MGDT_OK) status = mgdt_get_tetrahedra(t, 4 * count, v);
    if (status != MGDT_OK) {
        char message[256] = "";
        mgdt_get_error(t, (int64_t)sizeof message, message);
        fprintf(stderr, "%s: %s\n", mgdt_status_string(status), message);
        return 1;
    }
    printf("mgdt %s: %lld tetrahedra\n", mgdt_version_string(), (long long)count);
    free(v);
    mgdt_destroy(t);
    /* A cube has 5 or 6, whichever diagonals are taken. */
    return count == 5 || count == 6 ? 0 : 1;
}
