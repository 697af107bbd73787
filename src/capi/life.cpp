// SPDX-License-Identifier: MIT
#include "capi/handle.hpp"

using namespace mgdt;

namespace {

constexpr std::size_t handle_size = sizeof(mgdt_triangulation),
                      handle_align = alignof(mgdt_triangulation);

// create() and destroy() are not inlined, for the reason at run_inside() in guard.hpp.
MGDT_NOT_INLINE mgdt_status create(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user,
                                   mgdt_triangulation** out) noexcept {
    const FpEnvironment environment;
    void* memory = Allocator::obtain(alloc, user, handle_size, handle_align);
    if (!memory) return MGDT_ERR_OUT_OF_MEMORY;
    try {
        mgdt_triangulation* t = new (memory) mgdt_triangulation(alloc, release, user);
        t->core.allocator().count(handle_size);
        *out = t;
        return MGDT_OK;
    } catch (...) {
        Allocator::give_back(release, user, memory, handle_size, handle_align);
        return MGDT_ERR_OUT_OF_MEMORY;
    }
}

MGDT_NOT_INLINE void destroy(mgdt_triangulation* t) noexcept {
    const mgdt_free_fn release = t->core.allocator().release_function();
    void* const user = t->core.allocator().user();
    t->~mgdt_triangulation();
    Allocator::give_back(release, user, t, handle_size, handle_align);
}

}  // namespace

extern "C" mgdt_status mgdt_create(mgdt_triangulation** out) {
    return mgdt_create_with_allocator(nullptr, nullptr, nullptr, out);
}

extern "C" mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                  void* user, mgdt_triangulation** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    if ((alloc == nullptr) != (release == nullptr)) return MGDT_ERR_INVALID_ARGUMENT;
    const CancellationDisabled uninterrupted;
    return create(alloc, release, user, out);
}

extern "C" void mgdt_destroy(mgdt_triangulation* t) {
    destroy_if_free(t, destroy);
}

extern "C" mgdt_status mgdt_clear(mgdt_triangulation* t) {
    return guard(t, [&] { t->core.clear(); });
}

extern "C" mgdt_status mgdt_reserve(mgdt_triangulation* t, int64_t n_points) {
    return guard(t, [&] { t->core.reserve(require_count(n_points)); });
}

extern "C" mgdt_status mgdt_shrink(mgdt_triangulation* t) {
    return guard(t, [&] { t->core.shrink(); });
}
