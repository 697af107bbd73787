// SPDX-License-Identifier: MIT
#include "parts/in_process.hpp"

namespace mgdt {

void InProcess::gather(const void* mine, std::size_t bytes, void* all) noexcept {
    if (parts_ * bytes > 0) std::memcpy(all, mine, parts_ * bytes);
}

void InProcess::exchange_counts(const Mail* out, Mail* in) noexcept {
    for (PartId to = 0; to < parts_; ++to) {
        std::uint64_t* const begin = in[to].begin.data();
        begin[0] = 0;
        for (PartId from = 0; from < parts_; ++from)
            begin[from + 1] = begin[from] + (out[from].begin[to + 1] - out[from].begin[to]);
    }
}

void InProcess::exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept {
    for (PartId to = 0; to < parts_; ++to)
        for (PartId from = 0; from < parts_; ++from) {
            const std::uint64_t at = in[to].begin[from], count = in[to].begin[from + 1] - at;
            if (count > 0)
                std::memcpy(in[to].bytes.data() + at * record_size,
                            out[from].bytes.data() + out[from].begin[to] * record_size,
                            count * record_size);
        }
}

}  // namespace mgdt
