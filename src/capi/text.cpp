// SPDX-License-Identifier: MIT
// Statistics, names and messages.
#include <cstring>

#include "capi/triangulation_handle.hpp"
#include "order/schemes.hpp"

using namespace mgdt;

namespace {

struct NamedStatistic {
    std::int32_t key;
    const char* name;
    double (*value)(const Triangulation&);
};
constexpr NamedStatistic statistics[] = {
    {MGDT_STAT_POINTS_INSERTED, "points inserted",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().points_inserted); }},
    {MGDT_STAT_DUPLICATES, "duplicates",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().duplicates); }},
    {MGDT_STAT_POINTS_REMOVED, "points removed",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().removed); }},
    {MGDT_STAT_POINTS_MOVED, "points moved",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().moved); }},
    {MGDT_STAT_PUT_BACK, "put back",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().put_back); }},
    {MGDT_STAT_REBUILDS, "rebuilds",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().rebuilds); }},
    {MGDT_STAT_WALK_STEPS, "walk steps",
     [](const Triangulation& t) { return static_cast<double>(t.counters().walk_steps); }},
    {MGDT_STAT_WALK_TESTS, "walk tests",
     [](const Triangulation& t) { return static_cast<double>(t.counters().walk_tests); }},
    {MGDT_STAT_CONFLICT_TESTS, "conflict tests",
     [](const Triangulation& t) { return static_cast<double>(t.counters().conflict_tests); }},
    {MGDT_STAT_TETRAHEDRA_REMOVED, "tetrahedra removed",
     [](const Triangulation& t) { return static_cast<double>(t.counters().removed); }},
    {MGDT_STAT_TETRAHEDRA_CREATED, "tetrahedra created",
     [](const Triangulation& t) { return static_cast<double>(t.counters().created); }},
    {MGDT_STAT_LINK_VERTICES, "link vertices",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().link_vertices); }},
    {MGDT_STAT_EXACT_CALLS, "exact calls",
     [](const Triangulation& t) { return static_cast<double>(t.counters().exact_calls); }},
    {MGDT_STAT_PUT_OFF, "put off",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().deferred); }},
    {MGDT_STAT_INSERTED_ALONE, "inserted alone",
     [](const Triangulation& t) { return static_cast<double>(t.statistics().inserted_alone); }},
    {MGDT_STAT_ORDER_SECONDS, "order seconds",
     [](const Triangulation& t) { return t.statistics().order_seconds; }},
    {MGDT_STAT_INSERT_SECONDS, "insert seconds",
     [](const Triangulation& t) { return t.statistics().insert_seconds; }},
    {MGDT_STAT_REMOVE_SECONDS, "remove seconds",
     [](const Triangulation& t) { return t.statistics().remove_seconds; }},
    {MGDT_STAT_MOVE_SECONDS, "move seconds",
     [](const Triangulation& t) { return t.statistics().move_seconds; }},
    {MGDT_STAT_GRID_LEVELS, "grid levels",
     [](const Triangulation& t) { return t.statistics().levels; }},
    {MGDT_STAT_ROUNDS, "rounds", [](const Triangulation& t) { return t.statistics().rounds; }},
    {MGDT_STAT_THREADS, "threads", [](const Triangulation& t) { return t.statistics().threads; }},
    {MGDT_STAT_MEMORY_BYTES, "memory bytes",
     [](const Triangulation& t) { return static_cast<double>(t.allocator().bytes()); }},
    {MGDT_STAT_PEAK_MEMORY_BYTES, "peak memory bytes",
     [](const Triangulation& t) { return static_cast<double>(t.allocator().peak()); }},
};

const NamedStatistic* find_statistic(std::int32_t key) {
    for (const NamedStatistic& s : statistics)
        if (s.key == key) return &s;
    return nullptr;
}

}  // namespace

extern "C" const char* mgdt_status_string(mgdt_status s) {
    switch (s) {
        case MGDT_OK:
            return "success";
        case MGDT_ERR_NULL_POINTER:
            return "a pointer that must not be NULL is NULL";
        case MGDT_ERR_INVALID_ARGUMENT:
            return "a value is out of its range";
        case MGDT_ERR_NOT_FINITE:
            return "a coordinate is NaN or infinite";
        case MGDT_ERR_UNKNOWN_SCHEME:
            return "no such order scheme";
        case MGDT_ERR_UNKNOWN_KEY:
            return "no such key";
        case MGDT_ERR_NOT_BUILT:
            return "there is no result: the call that makes it comes first";
        case MGDT_ERR_BUFFER_TOO_SMALL:
            return "an output array is too small";
        case MGDT_ERR_INDEX_RANGE:
            return "an index does not fit a 32-bit integer";
        case MGDT_ERR_OUT_OF_MEMORY:
            return "out of memory";
        case MGDT_ERR_TOO_LARGE:
            return "more points or tetrahedra than can be numbered";
        case MGDT_ERR_CANCELLED:
            return "cancelled";
        case MGDT_ERR_BUSY:
            return "another call is inside the handle";
        case MGDT_ERR_TRANSPORT:
            return "the transport between parts failed";
        case MGDT_ERR_CHECK_FAILED:
            return "the check found a defect";
        case MGDT_ERR_INVALID_BOUNDARY:
            return "facets, segments or points of the domain cross, touch or are flat";
        case MGDT_ERR_RESOLUTION:
            return "the mesh needs points nearer to each other than double precision allows";
        case MGDT_ERR_OPEN_BOUNDARY:
            return "the facets of the domain enclose nothing";
        case MGDT_ERR_INTERNAL:
            return "internal error";
        default:
            return "unknown status";
    }
}

extern "C" mgdt_status mgdt_get_error(const mgdt_triangulation* t, int64_t capacity, char* buffer) {
    return get_message(t, capacity, buffer);
}

extern "C" const char* mgdt_order_scheme_name(int32_t scheme) {
    const OrderScheme* const found = find_order_scheme(scheme);
    return found ? found->name : nullptr;
}

extern "C" mgdt_status mgdt_order_scheme_from_name(const char* name, int32_t* scheme) {
    if (!name || !scheme) return MGDT_ERR_NULL_POINTER;
    for (const OrderScheme& s : order_schemes()) {
        if (std::strcmp(s.name, name) != 0) continue;
        *scheme = s.number;
        return MGDT_OK;
    }
    return MGDT_ERR_UNKNOWN_SCHEME;
}

extern "C" mgdt_status mgdt_order_scheme_at(int32_t index, int32_t* scheme) {
    if (!scheme) return MGDT_ERR_NULL_POINTER;
    const OrderSchemes all = order_schemes();
    if (index < 0 || index >= all.end() - all.begin()) return MGDT_ERR_UNKNOWN_SCHEME;
    *scheme = all.begin()[index].number;
    return MGDT_OK;
}

extern "C" mgdt_status mgdt_get_stat(const mgdt_triangulation* t, int32_t key, double* value) {
    return guard_short(t, [&] {
        require_pointer(value, "value");
        const NamedStatistic* s = find_statistic(key);
        if (!s) fail(MGDT_ERR_UNKNOWN_KEY, "there is no statistic %d", static_cast<int>(key));
        *value = s->value(t->object);
    });
}

extern "C" const char* mgdt_stat_name(int32_t key) {
    const NamedStatistic* s = find_statistic(key);
    return s ? s->name : nullptr;
}

extern "C" const char* mgdt_version_string(void) {
    return MGDT_VERSION;
}

extern "C" int32_t mgdt_abi_version(void) {
    return 1;
}

extern "C" const char* mgdt_isa_name(const mgdt_triangulation* t) {
    return t && !t->calls.is_held_alone() ? t->object.kernel().isa : "";
}
