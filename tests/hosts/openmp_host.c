/* SPDX-License-Identifier: MIT
 * A host with OpenMP: calls with threads of their own from every thread of a parallel region,
 * beside one that computes, and between two. */
#include <omp.h>

#include "linked.h"

enum { region = 4 };

int main(void) {
    const struct points p = make_points(point_count);
    const uint64_t expected = triangulate(&linked, p, 1, NULL);
    int same = 0, before, in_region = 0;
    double sum = 0;

#pragma omp parallel num_threads(region) reduction(+ : same)
    {
        same += triangulate(&linked, p, 2, NULL) == expected;
#pragma omp single
        in_region = omp_get_num_threads();
    }
    REQUIRE(in_region == region);
    REQUIRE(same == region);

    /* The host's threads wait in its pool; none is added to it, none is taken. */
    before = thread_count();
    REQUIRE(triangulate(&linked, p, 2, NULL) == expected);
    REQUIRE(thread_count() == before);

    same = 0;
#pragma omp parallel num_threads(region) reduction(+ : sum, same)
    {
        if (omp_get_thread_num() == 1) {
            same += triangulate(&linked, p, 2, NULL) == expected;
        } else {
            int i;
            for (i = 1; i <= 1000000; ++i) sum += 1.0 / i;
        }
    }
    REQUIRE(same == 1);
    REQUIRE(sum > 3 * 14.39 && sum < 3 * 14.40);
    free_points(p);
    REQUIRE(omp_pause_resource_all(omp_pause_hard) == 0); /* ends the pool */
    return 0;
}
