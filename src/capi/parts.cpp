// SPDX-License-Identifier: MIT
// Creation, options and points of parts, and collective calls.
#include <algorithm>
#include <functional>

#include "capi/entry_points.hpp"
#include "capi/parts_handle.hpp"
#include "core/point_scan.hpp"
#include "platform/callback.hpp"

using namespace mgdt;

PartsObject::PartsObject(const mgdt_transport* transport, PartId parts, mgdt_alloc_fn alloc,
                         mgdt_free_fn release, void* user)
    : allocator_(alloc, release, user),
      transport_(transport ? static_cast<Transport*>(&callbacks_.emplace(*transport, allocator_))
                           : &in_process_.emplace(parts)),
      collective(*transport_),
      given(allocator_, transport_->local_parts(), std::ref(allocator_)) {
    settings_.watches_reads = false;  // as in 1.2
}

PartId PartsObject::local(std::int32_t part) const {
    if (part == MGDT_PARTS_THIS_PART) {
        if (local_parts() == 1) return 0;
        fail(MGDT_ERR_INVALID_ARGUMENT,
             "MGDT_PARTS_THIS_PART is for a process with one part; this one has %u", local_parts());
    }
    const std::int64_t local = std::int64_t{part} - first_local();
    if (local < 0 || local >= local_parts())
        fail(MGDT_ERR_INVALID_ARGUMENT, "part %d is not among those of this process, %u to %u",
             static_cast<int>(part), first_local(), first_local() + local_parts() - 1);
    return static_cast<PartId>(local);
}

void PartsObject::forget_triangulation() noexcept {
    if (!triangulation) return;
    triangulation->~Parts();
    allocator_.release(triangulation, sizeof(Parts), alignof(Parts));
    triangulation = nullptr;
}

namespace {

constexpr std::int32_t most_parts = 1 << 20;

// Not inlined, for the reason at run_inside() in guard.cpp.
MGDT_NOT_INLINE void free_parts(mgdt_parts* p) noexcept {
    const mgdt_transport transport = p->object.host_transport();
    free_handle_in_environment(p);
    if (transport.destroy)
        call_back<std::int32_t>(0, [&] {
            transport.destroy(transport.user);
            return 0;
        });
}

// Whether this version of the library can read the transport. A caller that is built for a later
// version has a larger structure, whose further members are 0 unless the caller needs them.
bool is_readable_transport(const mgdt_transport* from) noexcept {
    if (from->size < sizeof *from) return false;
    const auto* const bytes = reinterpret_cast<const unsigned char*>(from);
    return std::all_of(bytes + sizeof *from, bytes + from->size,
                       [](unsigned char byte) { return byte == 0; });
}

void insert(PartsObject& p, std::int32_t part, std::int64_t n, const double* xyz,
            const std::int64_t* ids) {
    PartsObject::Given& given = p.given[p.local(part)];
    const std::size_t count = require_count(n);
    if (count == 0) return;
    require_pointer(xyz, "xyz");
    if (count > static_cast<std::size_t>(-1) / (3 * sizeof(double)))
        fail(MGDT_ERR_TOO_LARGE, "%zu points are more than memory can hold", count);
    const std::size_t before = given.count();
    for (std::size_t i = 0; i < 3 * count; ++i)
        require_finite(xyz[i], i % 3,
                       static_cast<long long>(before + i / 3) + p.settings().index_base);
    if (before > 0 && given.has_ids() != (ids != nullptr))
        fail(MGDT_ERR_INVALID_ARGUMENT, "%s",
             ids ? "the points before these have no ids" : "the points before these have ids");
    given.xyz.grow(3 * (before + count));
    if (ids) given.ids.grow(before + count);
    given.xyz.resize(3 * (before + count));
    std::memcpy(given.xyz.data() + 3 * before, xyz, 3 * count * sizeof(double));
    if (!ids) return;
    given.ids.resize(before + count);
    std::memcpy(given.ids.data() + before, ids, count * sizeof *ids);
}

// Checks that all processes have the same index base, and ids for all points or for none.
void require_agreement(PartsObject& p) {
    constexpr std::uint64_t with_ids = 1, without_ids = 2, base_one = 4;
    Buffer<std::uint64_t> mine(p.allocator()), all(p.allocator());
    for (const PartsObject::Given& given : p.given)
        mine.push_back((given.count() == 0 ? 0
                        : given.has_ids()  ? with_ids
                                           : without_ids) |
                       (p.settings().index_base == 1 ? base_one : 0));
    p.collective.gather(mine, all);
    PartId first_with_ids = 0;
    while (first_with_ids < all.size() && (all[first_with_ids] & with_ids) == 0) ++first_with_ids;
    p.has_ids = first_with_ids < all.size();
    p.collective.each_local([&](PartId i) {
        if (p.has_ids && (mine[i] & without_ids) != 0)
            fail(MGDT_ERR_INVALID_ARGUMENT, "its points have no ids, those of part %u have",
                 first_with_ids);
        if ((mine[i] & base_one) != (all[0] & base_one))
            fail(MGDT_ERR_INVALID_ARGUMENT, "its index base is not that of part 0");
    });
}

// Builds with Parts::build_each() if `visit` is given, else with Parts::build().
void build(PartsObject& p, const Parts::Visit* visit) {
    p.forget_triangulation();
    const Error failure = std::exchange(p.failure, Error{MGDT_OK, ""});
    p.collective.each_local([&](PartId i) {
        if (failure.status != MGDT_OK && i == p.failed_part) throw failure;
    });
    require_agreement(p);
    Buffer<GivenPoints> given(p.allocator());
    Buffer<const std::int64_t*> ids(p.allocator());
    for (const PartsObject::Given& g : p.given) {
        given.push_back({g.xyz.data(), g.count()});
        ids.push_back(g.ids.data());
    }
    const bool passes_through =
        p.allocator().limit() > 0 || p.allocator().release_function() != nullptr;
    void* const memory = p.allocator().allocate(sizeof(Parts), alignof(Parts));
    try {
        p.triangulation =
            new (memory) Parts(p.collective, passes_through ? Allocator::allocate_from : nullptr,
                               passes_through ? Allocator::release_to : nullptr, &p.allocator());
    } catch (...) {
        p.allocator().release(memory, sizeof(Parts), alignof(Parts));
        throw;
    }
    p.passes_through = passes_through;
    p.triangulation->set_threads(p.settings().threads);
    StageProgress progress(p.settings(), p.stop());
    const std::int64_t* const* const all_ids = p.has_ids ? ids.data() : nullptr;
    p.keeps_tetrahedra = visit == nullptr;
    if (visit)
        p.triangulation->build_each(given.data(), all_ids, progress, *visit);
    else
        p.triangulation->build(given.data(), all_ids, progress);
}

// Builds the triangulation. Frees what a failed build leaves.
void run_build(PartsObject& p, const Parts::Visit* visit) {
    const StopFlag::Call call(p.stop());
    try {
        p.collective.run([&] { build(p, visit); });
    } catch (...) {
        p.forget_triangulation();
        throw;
    }
}

const OwnOptions<CallSettings> parts_options = {
    {MGDT_PARTS_READ_PROGRESS, &CallSettings::watches_reads}};

}  // namespace

MGDT_OPTIONS(parts, parts_options)
MGDT_PROGRESS(parts)
MGDT_MESSAGE(parts)

extern "C" mgdt_status mgdt_parts_create(int32_t parts, mgdt_parts** out) {
    return mgdt_parts_create_with_allocator(parts, nullptr, nullptr, nullptr, out);
}

extern "C" mgdt_status mgdt_parts_create_with_allocator(int32_t parts, mgdt_alloc_fn alloc,
                                                        mgdt_free_fn release, void* user,
                                                        mgdt_parts** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    if (parts < 1 || parts > most_parts) return MGDT_ERR_INVALID_ARGUMENT;
    const mgdt_transport* const none = nullptr;
    return create_handle(out, alloc, release, user, none, static_cast<PartId>(parts));
}

extern "C" mgdt_status mgdt_parts_create_with_transport(const mgdt_transport* transport,
                                                        mgdt_parts** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    if (!transport) return MGDT_ERR_NULL_POINTER;
    if (!is_readable_transport(transport)) return MGDT_ERR_INVALID_ARGUMENT;
    const mgdt_transport& t = *transport;
    if (!t.gather || !t.exchange_numbers || !t.exchange || !t.sum || !t.least)
        return MGDT_ERR_NULL_POINTER;
    if (t.processes < 1 || t.processes > most_parts || t.process < 0 || t.process >= t.processes)
        return MGDT_ERR_INVALID_ARGUMENT;
    return create_handle(out, nullptr, nullptr, nullptr, transport, PartId{1});
}

extern "C" void mgdt_parts_destroy(mgdt_parts* p) {
    destroy_handle(p, free_parts);
}

extern "C" mgdt_status mgdt_parts_clear(mgdt_parts* p) {
    return guard(p, [&] {
        PartsObject& parts = p->object;
        parts.stop().forget();
        parts.forget_triangulation();
        parts.failure.status = MGDT_OK;
        for (PartsObject::Given& given : parts.given) {
            given.xyz.reset();
            given.ids.reset();
        }
    });
}

extern "C" mgdt_status mgdt_parts_insert_points(mgdt_parts* p, int32_t part, int64_t n,
                                                const double* xyz, const int64_t* ids) {
    return guard(p, [&] {
        PartsObject& parts = p->object;
        const auto remember = [&](const Error& error) {
            parts.failure = error;
            const std::int64_t local = std::int64_t{part} - parts.first_local();
            parts.failed_part =
                local >= 0 && local < parts.local_parts() ? static_cast<PartId>(local) : 0;
        };
        try {
            insert(parts, part, n, xyz, ids);
        } catch (const Error& error) {
            remember(error);
            throw;
        } catch (const std::bad_alloc&) {
            remember(Error{MGDT_ERR_OUT_OF_MEMORY, "out of memory"});
            throw;
        }
    });
}

extern "C" mgdt_status mgdt_parts_build(mgdt_parts* p) {
    return guard(p, [&] { run_build(p->object, nullptr); });
}

extern "C" mgdt_status mgdt_parts_build_each(mgdt_parts* p, mgdt_part_fn look, void* user) {
    return guard(p, [&] {
        require_pointer(reinterpret_cast<const void*>(look), "look");
        if (p->object.local_parts() != p->object.collective.parts())
            fail(MGDT_ERR_INVALID_ARGUMENT, "the parts are in %u processes",
                 p->object.collective.parts());
        const auto show = [&](PartId i) {
            p->calls.let_read();
            const std::int32_t answer = call_back<std::int32_t>(
                1, [&] { return look(p, static_cast<std::int32_t>(i), user); });
            p->calls.be_alone_again();
            if (answer != 0) fail(MGDT_ERR_CANCELLED, "cancelled by the look at the part");
        };
        // A function object with one reference allocates no memory.
        const Parts::Visit visit = [&show](PartId i) { show(i); };
        run_build(p->object, &visit);
    });
}

extern "C" mgdt_status mgdt_parts_check(mgdt_parts* p, int32_t level) {
    // Other processes have to hear of a request to stop, so only the collective part polls.
    const auto check = [&](StageProgress& progress) {
        p->object.collective.run([&] {
            if (level < MGDT_CHECK_COMBINATORIAL || level > MGDT_CHECK_CANONICAL)
                fail(MGDT_ERR_INVALID_ARGUMENT, "there is no check level %d",
                     static_cast<int>(level));
            if (!p->object.triangulation || !p->object.keeps_tetrahedra)
                fail(MGDT_ERR_INVALID_ARGUMENT, "there is no triangulation to check");
            p->object.triangulation->check(level, progress);
        });
    };
    return guard(p, [&] {
        const CallSettings& settings = p->object.settings();
        read_for_long(p, settings, p->object.stop(), settings.watches_reads, false, check,
                      "mgdt_parts_check");
    });
}
