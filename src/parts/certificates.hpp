// SPDX-License-Identifier: MIT
// What a part has learnt of others: which of its circumballs have no point of theirs.
#pragma once

#include <algorithm>

#include "mesh/tetrahedron.hpp"
#include "order/random.hpp"
#include "parts/transport.hpp"

namespace mgdt {

enum class Answer : std::uint32_t {
    unasked,
    empty,    // no point of that part is in the ball
    unsure,   // a point on the sphere, or too near it
    conflict  // there is one
};

// Answers by tetrahedron, which is known by its vertices, and part. A part's own points stay as
// they are, so an answer holds as long as the tetrahedron does.
class Certificates {
  public:
    explicit Certificates(Allocator& allocator) : entries_(allocator) {}

    void put(const VertexId (&v)[4], PartId part, Answer answer) {
        if (2 * (size_ + 1) > entries_.size()) grow();
        Entry& e = place(sorted(v, part));
        if (e.answer == Answer::unasked) ++size_;
        e.answer = answer;
    }
    Answer of(const VertexId (&v)[4], PartId part) {
        return size_ == 0 ? Answer::unasked : place(sorted(v, part)).answer;
    }

  private:
    struct Entry {
        VertexId v[4];
        PartId part;
        Answer answer;
    };
    static Entry sorted(const VertexId (&v)[4], PartId part) {
        Entry e{{v[0], v[1], v[2], v[3]}, part, Answer::unasked};
        std::sort(e.v, e.v + 4);
        return e;
    }
    static std::size_t hash(const Entry& e) {
        std::uint64_t h = e.part;
        for (const VertexId v : e.v) h = Random::at(h, v);
        return h;
    }
    // Where the entry is, or a free place that is made its own.
    Entry& place(const Entry& e) {
        const std::size_t mask = entries_.size() - 1;
        for (std::size_t at = hash(e) & mask;; at = (at + 1) & mask) {
            Entry& there = entries_[at];
            const bool is_free = there.answer == Answer::unasked;
            if (is_free) there = e;
            if (is_free || (std::equal(e.v, e.v + 4, there.v) && e.part == there.part))
                return there;
        }
    }
    void grow() {
        Buffer<Entry> old(std::move(entries_));
        entries_ = Buffer<Entry>(old.allocator());
        entries_.resize(std::max<std::size_t>(1024, 2 * old.size()), Entry{{}, 0, Answer::unasked});
        for (const Entry& e : old)
            if (e.answer != Answer::unasked) place(e).answer = e.answer;
    }

    Buffer<Entry> entries_;  // open-addressed
    std::size_t size_ = 0;
};

}  // namespace mgdt
