/* SPDX-License-Identifier: MIT
 * The library's functions, for hosts that are linked with it. */
#ifndef MGDT_TESTS_HOSTS_LINKED_H
#define MGDT_TESTS_HOSTS_LINKED_H

#include "host.h"

static const struct library linked = {
    mgdt_create,        mgdt_destroy,           mgdt_set_threads,    mgdt_set_canonical_output,
    mgdt_insert_points, mgdt_tetrahedron_count, mgdt_get_tetrahedra, mgdt_locate_points,
    mgdt_get_stat};

#endif
