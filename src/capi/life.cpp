// SPDX-License-Identifier: MIT
#include "capi/handle.hpp"

using namespace mgdt;

extern "C" mgdt_status mgdt_create(mgdt_triangulation** out) {
    return mgdt_create_with_allocator(nullptr, nullptr, nullptr, out);
}

extern "C" mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                  void* user, mgdt_triangulation** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    if ((alloc == nullptr) != (release == nullptr)) return MGDT_ERR_INVALID_ARGUMENT;
    constexpr std::size_t size = sizeof(mgdt_triangulation), align = alignof(mgdt_triangulation);
    const FpEnvironment environment;
    void* memory = Allocator::obtain(alloc, user, size, align);
    if (!memory) return MGDT_ERR_OUT_OF_MEMORY;
    try {
        mgdt_triangulation* t = new (memory) mgdt_triangulation(alloc, release, user);
        t->core.allocator().count(size);
        *out = t;
        return MGDT_OK;
    } catch (...) {
        Allocator::give_back(release, user, memory, size, align);
        return MGDT_ERR_OUT_OF_MEMORY;
    }
}

extern "C" void mgdt_destroy(mgdt_triangulation* t) {
    if (!t) return;
    const mgdt_free_fn release = t->core.allocator().release_function();
    void* const user = t->core.allocator().user();
    t->~mgdt_triangulation();
    Allocator::give_back(release, user, t, sizeof *t, alignof(mgdt_triangulation));
}

extern "C" mgdt_status mgdt_clear(mgdt_triangulation* t) {
    return guard(t, [&] { t->core.clear(); });
}

extern "C" mgdt_status mgdt_reserve(mgdt_triangulation* t, int64_t n_points) {
    return guard(t, [&] {
        require_count(n_points);
        t->core.reserve(static_cast<std::size_t>(n_points));
    });
}
