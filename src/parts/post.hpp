// SPDX-License-Identifier: MIT
// Collects records for a Mail in any order, and replies to records that have arrived.
#pragma once

#include <algorithm>

#include "parts/transport.hpp"

namespace mgdt {

// Records addressed to parts. Records to the same part keep their order.
template <class Record>
class Post {
  public:
    explicit Post(Allocator& allocator) : records_(allocator), to_(allocator) {}

    void reserve(std::size_t count) {
        records_.reserve(count);
        to_.reserve(count);
    }
    void add(PartId to, const Record& record) {
        to_.push_back(to);
        records_.push_back(record);
    }
    // Writes the records to the mail. (*positions)[k] becomes the position of record k, unless
    // `positions` is null.
    void put(PartId parts, Mail& mail, Buffer<std::uint64_t>* positions) const {
        mail.begin.clear();
        mail.begin.resize(std::size_t{parts} + 1, 0);
        for (const PartId to : to_) ++mail.begin[std::size_t{to} + 1];
        for (PartId p = 0; p < parts; ++p) mail.begin[std::size_t{p} + 1] += mail.begin[p];
        Buffer<std::uint64_t> next(to_.allocator(), parts);
        std::copy_n(mail.begin.data(), parts, next.data());
        mail.bytes.resize(to_.size() * sizeof(Record));
        if (positions) positions->resize(to_.size());
        for (std::size_t k = 0; k < to_.size(); ++k) {
            const std::uint64_t position = next[to_[k]]++;
            mail.records<Record>()[position] = records_[k];
            if (positions) (*positions)[k] = position;
        }
    }

  private:
    Buffer<Record> records_;
    Buffer<PartId> to_;
};

// Makes room in `out` for one reply to each record of `in`, in the order of the records. Returns
// the first reply.
template <class Reply>
Reply* begin_replies(const Mail& in, Mail& out) {
    out.begin.resize(in.begin.size());
    std::copy(in.begin.begin(), in.begin.end(), out.begin.data());
    out.bytes.resize(bytes_of(in.count(), sizeof(Reply)));
    return out.records<Reply>();
}

}  // namespace mgdt
