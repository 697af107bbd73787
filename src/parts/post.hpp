// SPDX-License-Identifier: MIT
// Mail as it is written: records in whatever order they come, and replies.
#pragma once

#include <algorithm>

#include "parts/transport.hpp"

namespace mgdt {

// Records for parts; sent by part, they keep their order.
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
    // Where the k-th record is in the mail, if `places` is given.
    void put(PartId parts, Mail& mail, Buffer<std::uint64_t>* places) const {
        mail.begin.clear();
        mail.begin.resize(std::size_t{parts} + 1, 0);
        for (const PartId to : to_) ++mail.begin[std::size_t{to} + 1];
        for (PartId p = 0; p < parts; ++p) mail.begin[std::size_t{p} + 1] += mail.begin[p];
        Buffer<std::uint64_t> next(to_.allocator(), parts);
        std::copy_n(mail.begin.data(), parts, next.data());
        mail.bytes.resize(to_.size() * sizeof(Record));
        if (places) places->resize(to_.size());
        for (std::size_t k = 0; k < to_.size(); ++k) {
            const std::uint64_t place = next[to_[k]]++;
            mail.records<Record>()[place] = records_[k];
            if (places) (*places)[k] = place;
        }
    }

  private:
    Buffer<Record> records_;
    Buffer<PartId> to_;
};

// Room for a reply to each record that has come, in their order.
template <class Reply>
Reply* begin_replies(const Mail& in, Mail& out) {
    out.begin.resize(in.begin.size());
    std::copy(in.begin.begin(), in.begin.end(), out.begin.data());
    out.bytes.resize(bytes_of(in.count(), sizeof(Reply)));
    return out.records<Reply>();
}

}  // namespace mgdt
