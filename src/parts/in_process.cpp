// SPDX-License-Identifier: MIT
#include "parts/in_process.hpp"

namespace mgdt {

void InProcess::gather(const void* mine, std::size_t bytes, void* all) {
    if (parts_ * bytes > 0) std::memcpy(all, mine, parts_ * bytes);
}

void InProcess::exchange(std::size_t record_size, const Mail* out, Mail* in) {
    for (PartId to = 0; to < parts_; ++to) {
        Mail& mail = in[to];
        mail.begin.resize(std::size_t{parts_} + 1);
        mail.begin[0] = 0;
        for (PartId from = 0; from < parts_; ++from)
            mail.begin[from + 1] =
                mail.begin[from] + (out[from].begin[to + 1] - out[from].begin[to]);
        mail.bytes.resize(mail.count() * record_size);
        for (PartId from = 0; from < parts_; ++from) {
            const std::size_t count = mail.begin[from + 1] - mail.begin[from];
            if (count > 0)
                std::memcpy(mail.bytes.data() + mail.begin[from] * record_size,
                            out[from].bytes.data() + out[from].begin[to] * record_size,
                            count * record_size);
        }
    }
}

}  // namespace mgdt
