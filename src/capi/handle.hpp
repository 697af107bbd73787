// SPDX-License-Identifier: MIT
// The handle behind the C interface, and the guard that every entry point passes: it sets up the
// floating-point environment, catches everything, and turns it into a status and a message.
#pragma once

#include <cstring>
#include <new>

#include "core/triangulation.hpp"
#include "mgdt/mgdt.h"
#include "platform/atomic.hpp"
#include "platform/error.hpp"
#include "platform/fp_environment.hpp"
#include "query/export.hpp"

struct mgdt_triangulation {
    mgdt_triangulation(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : core(alloc, release, user) {}

    mgdt::Triangulation core;

    // The message of the last failure. Const calls on several threads may fail at once.
    void remember(const char* message) const noexcept {
        const Lock lock(busy_);
        copy(message, message_, sizeof message_);
    }
    void recall(char* to, std::size_t capacity) const noexcept {
        const Lock lock(busy_);
        copy(message_, to, capacity);
    }

  private:
    static void copy(const char* from, char* to, std::size_t capacity) noexcept {
        const std::size_t length = std::strlen(from);
        const std::size_t kept = length < capacity ? length : capacity - 1;
        std::memcpy(to, from, kept);
        to[kept] = '\0';
    }
    struct Lock {
        explicit Lock(mgdt::Atomic<bool>& flag) noexcept : flag_(flag) {
            while (flag_.exchange(true, std::memory_order_acquire)) {
            }
            mgdt::receive(&flag_);
        }
        ~Lock() {
            mgdt::hand_over(&flag_);
            flag_.store(false, std::memory_order_release);
        }
        mgdt::Atomic<bool>& flag_;
    };
    mutable mgdt::Atomic<bool> busy_{false};
    mutable char message_[mgdt::Error::message_size] = {};
};

namespace mgdt {

// Runs `body` for a handle and returns its status.
template <class Handle, class Body>
mgdt_status guard(Handle* t, Body body) noexcept {
    if (!t) return MGDT_ERR_NULL_POINTER;
    const FpEnvironment environment;
    try {
        body();
        return MGDT_OK;
    } catch (const Error& error) {
        t->remember(error.message);
        return error.status;
    } catch (const std::bad_alloc&) {
        t->remember("out of memory: the allocator or the memory limit refused");
        return MGDT_ERR_OUT_OF_MEMORY;
    } catch (...) {
        t->remember("internal error");
        return MGDT_ERR_INTERNAL;
    }
}

// What the exports and queries of a handle read. Tetrahedra are numbered when that is asked for the
// first time.
inline ExportView view_of(Team& team, const mgdt_triangulation* t, bool numbers) {
    const Triangulation& core = t->core;
    return {team,
            core.mesh(),
            numbers ? &core.numbering(team) : nullptr,
            core.allocator(),
            core.settings().index_base,
            core.settings().canonical_output};
}

inline void require_pointer(const void* p, const char* name) {
    if (!p) fail(MGDT_ERR_NULL_POINTER, "%s is NULL", name);
}

inline void require_count(std::int64_t n) {
    if (n < 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the number of points is negative (%lld)",
             static_cast<long long>(n));
}

inline void require_capacity(std::int64_t capacity, std::size_t needed, const char* name) {
    if (capacity < 0)
        fail(MGDT_ERR_INVALID_ARGUMENT, "the capacity of %s is negative (%lld)", name,
             static_cast<long long>(capacity));
    if (static_cast<std::uint64_t>(capacity) < needed)
        fail(MGDT_ERR_BUFFER_TOO_SMALL, "%s holds %lld elements; %zu are needed", name,
             static_cast<long long>(capacity), needed);
}

}  // namespace mgdt
