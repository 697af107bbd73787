// SPDX-License-Identifier: MIT
// The settings of a triangulation.
#include "capi/triangulation_handle.hpp"
#include "order/schemes.hpp"

using namespace mgdt;

namespace {

// Checks that a parameter is in (least, most], or in [least, most] if the interval is not open; 0
// stands for the default.
double parameter_or(double value, double by_default, double least, double most, bool open,
                    const char* name) {
    if (value == 0) return by_default;
    if (!(open ? value > least : value >= least) || !(value <= most))
        fail(MGDT_ERR_INVALID_ARGUMENT, "%s is %g; it must be %s %g and at most %g, or 0", name,
             value, open ? "above" : "at least", least, most);
    return value;
}

bool flag(std::int32_t value, const char* name) {
    if (value != 0 && value != 1)
        fail(MGDT_ERR_INVALID_ARGUMENT, "%s is %d; it must be 0 or 1", name,
             static_cast<int>(value));
    return value != 0;
}

// Returns one setting, read(core).
template <class T, class Read>
mgdt_status get(const mgdt_triangulation* t, T* value, Read read,
                const char* name = __builtin_FUNCTION()) {
    return guard_short(
        t,
        [&] {
            require_pointer(value, "the output");
            *value = static_cast<T>(read(t->object));
        },
        name);
}

}  // namespace

extern "C" mgdt_status mgdt_set_order_scheme(mgdt_triangulation* t, int32_t scheme) {
    return guard(t, [&] {
        if (!find_order_scheme(scheme))
            fail(MGDT_ERR_UNKNOWN_SCHEME, "there is no order scheme %d", static_cast<int>(scheme));
        t->object.settings().scheme = scheme;
    });
}

extern "C" mgdt_status mgdt_set_order_parameter(mgdt_triangulation* t, int32_t key, double value) {
    return guard(t, [&] {
        const OrderParameters by_default;
        OrderParameters& order = t->object.settings().order;
        switch (key) {
            case MGDT_PARAMETER_POINTS_PER_CELL:
                order.points_per_cell = parameter_or(value, by_default.points_per_cell, 1, 1e6,
                                                     false, "points per cell");
                break;
            case MGDT_PARAMETER_THRESHOLD:
                order.threshold =
                    parameter_or(value, by_default.threshold, 1, 1e9, false, "threshold");
                break;
            case MGDT_PARAMETER_SEPARATION:
                if (value != 0 && value != 1 && value != 2)
                    fail(MGDT_ERR_INVALID_ARGUMENT, "separation is %g; it must be 0, 1 or 2",
                         value);
                order.separation = static_cast<Separation>(static_cast<int>(value));
                break;
            case MGDT_PARAMETER_ROUND_RATIO:
                order.round_ratio =
                    parameter_or(value, by_default.round_ratio, 1, 1e6, true, "round ratio");
                break;
            default:
                fail(MGDT_ERR_UNKNOWN_KEY, "there is no order parameter %d", static_cast<int>(key));
        }
    });
}

extern "C" mgdt_status mgdt_set_seed(mgdt_triangulation* t, uint64_t seed) {
    return guard(t, [&] { t->object.settings().order.seed = seed; });
}

extern "C" mgdt_status mgdt_set_threads(mgdt_triangulation* t, int32_t n) {
    return guard(t, [&] {
        if (n < 0)
            fail(MGDT_ERR_INVALID_ARGUMENT, "the number of threads is negative (%d)",
                 static_cast<int>(n));
        t->object.settings().threads = n;
    });
}

extern "C" mgdt_status mgdt_set_index_base(mgdt_triangulation* t, int32_t base) {
    return guard(t, [&] { t->object.settings().index_base = flag(base, "the index base"); });
}

extern "C" mgdt_status mgdt_set_memory_limit(mgdt_triangulation* t, int64_t bytes) {
    return guard(t, [&] {
        if (bytes < 0)
            fail(MGDT_ERR_INVALID_ARGUMENT, "the memory limit is negative (%lld)",
                 static_cast<long long>(bytes));
        t->object.allocator().set_limit(limit_of(bytes));
    });
}

extern "C" mgdt_status mgdt_set_compact(mgdt_triangulation* t, int32_t on) {
    return guard(t, [&] { t->object.set_compact(flag(on, "compact storage")); });
}

extern "C" mgdt_status mgdt_set_read_progress(mgdt_triangulation* t, int32_t on) {
    return guard(t, [&] {
        t->object.settings().watches_reads = flag(on, "the progress of calls that read");
    });
}

extern "C" mgdt_status mgdt_set_progress(mgdt_triangulation* t, mgdt_progress_fn fn, void* user) {
    return set_progress(t, fn, user);
}

extern "C" mgdt_status mgdt_cancel(mgdt_triangulation* t) {
    return cancel(t);
}

extern "C" mgdt_status mgdt_set_isa(mgdt_triangulation* t, const char* name) {
    return guard(t, [&] {
        const Kernel* kernel = find_kernel(name);
        if (!kernel)
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "instruction set \"%.32s\" is unknown or not in this processor", name);
        t->object.set_kernel(*kernel);
    });
}

extern "C" mgdt_status mgdt_set_canonical_output(mgdt_triangulation* t, int32_t on) {
    return guard(t, [&] {
        t->object.settings().canonical_output = flag(on, "canonical output");
        t->object.forget_numbering();
    });
}

extern "C" mgdt_status mgdt_get_order_parameter(const mgdt_triangulation* t, int32_t key,
                                                double* value) {
    return get(t, value, [&](const Triangulation& c) -> double {
        const OrderParameters& order = c.settings().order;
        switch (key) {
            case MGDT_PARAMETER_POINTS_PER_CELL:
                return order.points_per_cell;
            case MGDT_PARAMETER_THRESHOLD:
                return order.threshold;
            case MGDT_PARAMETER_SEPARATION:
                return static_cast<double>(order.separation);
            case MGDT_PARAMETER_ROUND_RATIO:
                return order.round_ratio;
            default:
                fail(MGDT_ERR_UNKNOWN_KEY, "there is no order parameter %d", static_cast<int>(key));
        }
    });
}

extern "C" mgdt_status mgdt_get_progress(const mgdt_triangulation* t, mgdt_progress_fn* fn,
                                         void** user) {
    return get_progress(t, fn, user);
}

extern "C" mgdt_status mgdt_get_order_scheme(const mgdt_triangulation* t, int32_t* scheme) {
    return get(t, scheme, [](const Triangulation& c) { return c.settings().scheme; });
}

extern "C" mgdt_status mgdt_get_seed(const mgdt_triangulation* t, uint64_t* seed) {
    return get(t, seed, [](const Triangulation& c) { return c.settings().order.seed; });
}

extern "C" mgdt_status mgdt_get_threads(const mgdt_triangulation* t, int32_t* n) {
    return get(t, n, [](const Triangulation& c) { return c.settings().threads; });
}

extern "C" mgdt_status mgdt_get_index_base(const mgdt_triangulation* t, int32_t* base) {
    return get(t, base, [](const Triangulation& c) { return c.settings().index_base; });
}

extern "C" mgdt_status mgdt_get_memory_limit(const mgdt_triangulation* t, int64_t* bytes) {
    return get(t, bytes, [](const Triangulation& c) { return c.allocator().limit(); });
}

extern "C" mgdt_status mgdt_get_compact(const mgdt_triangulation* t, int32_t* on) {
    return get(t, on, [](const Triangulation& c) { return !c.mesh().tetrahedra.has_spheres(); });
}

extern "C" mgdt_status mgdt_get_read_progress(const mgdt_triangulation* t, int32_t* on) {
    return get(t, on, [](const Triangulation& c) { return c.settings().watches_reads; });
}

extern "C" mgdt_status mgdt_get_canonical_output(const mgdt_triangulation* t, int32_t* on) {
    return get(t, on, [](const Triangulation& c) { return c.settings().canonical_output; });
}
