// SPDX-License-Identifier: MIT
// A transport for parts that are all in one process. With it, one machine triangulates more points
// than one triangulation can number, and other transports are tested against it.
#pragma once

#include "parts/transport.hpp"

namespace mgdt {

class InProcess final : public Transport {
  public:
    explicit InProcess(PartId parts) : parts_(parts) {}

    PartId parts() const noexcept override { return parts_; }
    PartId first_local() const noexcept override { return 0; }
    PartId local_parts() const noexcept override { return parts_; }
    bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept override;
    bool sum(std::uint64_t*, std::size_t) noexcept override { return true; }
    bool least(double*, std::size_t) noexcept override { return true; }
    bool exchange_counts(const Mail* out, Mail* in) noexcept override;
    bool exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept override;

  private:
    PartId parts_;
};

}  // namespace mgdt
