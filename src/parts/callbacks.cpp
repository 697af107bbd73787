// SPDX-License-Identifier: MIT
#include "parts/callbacks.hpp"

#include "platform/callback.hpp"

namespace mgdt {
namespace {

// Whether the host's function returns 0, for success.
template <class Call>
bool succeeds(const Call& call) noexcept {
    return call_back<std::int32_t>(1, call) == 0;
}

}  // namespace

Callbacks::Callbacks(const mgdt_transport& functions, Allocator& allocator)
    : functions_(functions),
      out_begin_(allocator, std::size_t{parts()} + 1),
      in_begin_(allocator, std::size_t{parts()} + 1),
      counts_out_(allocator, parts()),
      counts_in_(allocator, parts()) {}

void Callbacks::set_offsets(std::size_t record_size, const std::uint64_t* begin,
                            Buffer<std::int64_t>& offsets) noexcept {
    for (std::size_t p = 0; p <= parts(); ++p)
        offsets[p] = static_cast<std::int64_t>(begin[p] * record_size);
}

bool Callbacks::gather(const void* mine, const std::uint64_t* begin, void* all) noexcept {
    set_offsets(1, begin, in_begin_);
    return succeeds(
        [&] { return functions_.gather(mine, all, in_begin_.data(), functions_.user); });
}

bool Callbacks::sum(std::uint64_t* numbers, std::size_t n) noexcept {
    return succeeds(
        [&] { return functions_.sum(numbers, static_cast<std::int64_t>(n), functions_.user); });
}

bool Callbacks::least(double* numbers, std::size_t n) noexcept {
    return succeeds(
        [&] { return functions_.least(numbers, static_cast<std::int64_t>(n), functions_.user); });
}

bool Callbacks::exchange_counts(const Mail* out, Mail* in) noexcept {
    for (std::size_t p = 0; p < parts(); ++p) counts_out_[p] = out->begin[p + 1] - out->begin[p];
    if (!succeeds([&] {
            return functions_.exchange_numbers(counts_out_.data(), counts_in_.data(),
                                               functions_.user);
        }))
        return false;
    in->begin[0] = 0;
    for (std::size_t p = 0; p < parts(); ++p) in->begin[p + 1] = in->begin[p] + counts_in_[p];
    return true;
}

bool Callbacks::exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept {
    set_offsets(record_size, out->begin.data(), out_begin_);
    set_offsets(record_size, in->begin.data(), in_begin_);
    return succeeds([&] {
        return functions_.exchange(out->bytes.data(), out_begin_.data(), in->bytes.data(),
                                   in_begin_.data(), functions_.user);
    });
}

}  // namespace mgdt
