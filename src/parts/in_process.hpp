// SPDX-License-Identifier: MIT
// All parts in one process: what the others are tested against, and how one machine holds more
// than one triangulation can number.
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
