// SPDX-License-Identifier: MIT
// A transport that calls functions of the host. Each process has one part.
#pragma once

#include "mgdt/mgdt_parts.h"
#include "parts/transport.hpp"

namespace mgdt {

class Callbacks final : public Transport {
  public:
    Callbacks(const mgdt_transport& functions, Allocator& allocator);

    const mgdt_transport& functions() const noexcept { return functions_; }

    PartId parts() const noexcept override { return static_cast<PartId>(functions_.processes); }
    PartId first_local() const noexcept override { return static_cast<PartId>(functions_.process); }
    PartId local_parts() const noexcept override { return 1; }
    bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept override;
    bool sum(std::uint64_t* numbers, std::size_t n) noexcept override;
    bool least(double* numbers, std::size_t n) noexcept override;
    bool exchange_counts(const Mail* out, Mail* in) noexcept override;
    bool exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept override;

  private:
    // Converts offsets that count records of `record_size` bytes to offsets in bytes. `offsets` has
    // its size already, since a transport call must not allocate memory.
    void set_offsets(std::size_t record_size, const std::uint64_t* begin,
                     Buffer<std::int64_t>& offsets) noexcept;

    mgdt_transport functions_;
    Buffer<std::int64_t> out_begin_, in_begin_;
    Buffer<std::uint64_t> counts_out_, counts_in_;
};

}  // namespace mgdt
