// SPDX-License-Identifier: MIT
// The handle of parts behind the C interface.
#pragma once

#include <optional>

#include "capi/handle.hpp"
#include "mgdt/mgdt_parts.h"
#include "parts/callbacks.hpp"
#include "parts/in_process.hpp"
#include "parts/parts.hpp"

namespace mgdt {

// The points that were inserted into the parts of this process, and the triangulation.
class PartsObject {
  public:
    // Without a transport, all parts are in this process. With one, this process has one part.
    PartsObject(const mgdt_transport* transport, PartId parts, mgdt_alloc_fn alloc,
                mgdt_free_fn release, void* user);
    ~PartsObject() { forget_triangulation(); }

    Allocator& allocator() const noexcept { return allocator_; }
    CallSettings& settings() noexcept { return settings_; }
    const CallSettings& settings() const noexcept { return settings_; }
    StopFlag& stop() const noexcept { return stop_; }

    PartId first_local() const noexcept { return transport_->first_local(); }
    PartId local_parts() const noexcept { return transport_->local_parts(); }
    // The host's transport; all members are null if the parts are in this process.
    mgdt_transport host_transport() const noexcept {
        return callbacks_ ? callbacks_->functions() : mgdt_transport{};
    }
    // The position of a part among the parts of this process. Throws if the part is in another
    // process.
    PartId local(std::int32_t part) const;
    void forget_triangulation() noexcept;

    // The points that were inserted into a part of this process.
    struct Given {
        explicit Given(Allocator& a) : xyz(a), ids(a) {}

        Buffer<double> xyz;
        Buffer<std::int64_t> ids;  // one per point, or none at all

        std::size_t count() const { return xyz.size() / 3; }
        bool has_ids() const { return !ids.empty(); }
    };

  private:
    mutable Allocator allocator_;
    CallSettings settings_;
    mutable StopFlag stop_;
    std::optional<InProcess> in_process_;
    std::optional<Callbacks> callbacks_;
    Transport* transport_;

  public:
    Collective collective;
    Objects<Given> given;
    Parts* triangulation = nullptr;
    // Whether the ids of the triangulation are the caller's, and whether its memory is counted by
    // this handle's allocator.
    bool has_ids = false, passes_through = false;
    bool keeps_tetrahedra = true;  // whether all tetrahedra stay in memory, linked across parts
    // The error of a failed insertion, which the next build reports.
    Error failure{MGDT_OK, ""};
    PartId failed_part = 0;
};

}  // namespace mgdt

struct mgdt_parts : mgdt::Handle<mgdt::PartsObject> {
    using Handle::Handle;
};
