// SPDX-License-Identifier: MIT
// Creation and destruction of a triangulation.
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

extern "C" mgdt_status mgdt_create(mgdt_triangulation** out) {
    return create_handle(out, nullptr, nullptr, nullptr);
}

extern "C" mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                  void* user, mgdt_triangulation** out) {
    return create_handle(out, alloc, release, user);
}

extern "C" void mgdt_destroy(mgdt_triangulation* t) {
    destroy_handle(t);
}

extern "C" mgdt_status mgdt_clear(mgdt_triangulation* t) {
    return guard(t, [&] { t->object.clear(); });
}

extern "C" mgdt_status mgdt_reserve(mgdt_triangulation* t, int64_t n_points) {
    return guard(t, [&] { t->object.reserve(require_count(n_points)); });
}

extern "C" mgdt_status mgdt_shrink(mgdt_triangulation* t) {
    return guard(t, [&] { t->object.shrink(); });
}
