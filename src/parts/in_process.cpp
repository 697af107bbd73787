// SPDX-License-Identifier: MIT
#include "parts/in_process.hpp"

namespace mgdt {

bool InProcess::gather(const void* mine, const std::uint64_t* begin, void* all) noexcept {
    if (begin[parts_] > 0) std::memcpy(all, mine, static_cast<std::size_t>(begin[parts_]));
    return true;
}

bool InProcess::exchange_counts(const Mail* out, Mail* in) noexcept {
    for (PartId to = 0; to < parts_; ++to) {
        std::uint64_t* const begin = in[to].begin.data();
        begin[0] = 0;
        for (PartId from = 0; from < parts_; ++from)
            begin[from + 1] = begin[from] + (out[from].begin[to + 1] - out[from].begin[to]);
    }
    return true;
}

bool InProcess::exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept {
    for (PartId to = 0; to < parts_; ++to)
        for (PartId from = 0; from < parts_; ++from) {
            const std::uint64_t at = in[to].begin[from], count = in[to].begin[from + 1] - at;
            if (count > 0)
                std::memcpy(in[to].bytes.data() + at * record_size,
                            out[from].bytes.data() + out[from].begin[to] * record_size,
                            static_cast<std::size_t>(count * record_size));
        }
    return true;
}

}  // namespace mgdt
