// SPDX-License-Identifier: MIT
// The handle of parts behind the C interface.
#pragma once

#include <optional>

#include "capi/guard.hpp"
#include "mgdt/mgdt_parts.h"
#include "parts/callbacks.hpp"
#include "parts/in_process.hpp"
#include "parts/parts.hpp"

struct mgdt_parts : mgdt::HandleBase {
    // Without a transport, all parts are in this process. With one, this process has one part.
    mgdt_parts(const mgdt_transport* transport, mgdt::PartId parts, mgdt_alloc_fn alloc,
               mgdt_free_fn release, void* user);
    ~mgdt_parts() { forget_triangulation(); }

    bool has_callbacks() const noexcept { return allocator.release_function() != nullptr; }
    mgdt::PartId first_local() const noexcept { return transport_->first_local(); }
    mgdt::PartId local_parts() const noexcept { return transport_->local_parts(); }
    // The host's transport; all members are null if the parts are in this process.
    mgdt_transport host_transport() const noexcept {
        return callbacks_ ? callbacks_->functions() : mgdt_transport{};
    }
    // The position of a part among the parts of this process. Throws if the part is in another
    // process.
    mgdt::PartId local(std::int32_t part) const;
    void forget_triangulation() noexcept;

    // The points that were inserted into a part of this process.
    struct Given {
        explicit Given(mgdt::Allocator& a) : xyz(a), ids(a) {}

        mgdt::Buffer<double> xyz;
        mgdt::Buffer<std::int64_t> ids;  // one per point, or none at all

        std::size_t count() const { return xyz.size() / 3; }
        bool has_ids() const { return !ids.empty(); }
    };

    mutable mgdt::Allocator allocator;

  private:
    std::optional<mgdt::InProcess> in_process_;
    std::optional<mgdt::Callbacks> callbacks_;
    mgdt::Transport* transport_;

  public:
    mgdt::Collective collective;
    mgdt::Objects<Given> given;
    mgdt::Parts* triangulation = nullptr;
    // Whether the ids of the triangulation are the caller's, and whether its memory is counted by
    // this handle's allocator.
    bool has_ids = false, passes_through = false;
    bool keeps_tetrahedra = true;  // whether all tetrahedra stay in memory, linked across parts
    // The error of a failed insertion, which the next build reports.
    mgdt::Error failure{MGDT_OK, ""};
    mgdt::PartId failed_part = 0;
    mgdt::Atomic<bool> cancelled{false};
    std::int32_t index_base = 0, threads = 1;
    mgdt_progress_fn progress = nullptr;
    void* progress_user = nullptr;
};
