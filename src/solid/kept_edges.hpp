// SPDX-License-Identifier: MIT
// The edges that a mesh keeps: parts of segments, and of edges of facets.
#pragma once

#include "solid/pair_table.hpp"

namespace mgdt {

class KeptEdges {
  public:
    // What the caller knows of an edge.
    struct Origin {
        std::uint32_t segment;  // or no_index
        std::int32_t marker;
    };

    explicit KeptEdges(Allocator& allocator) : pairs_(allocator), records_(allocator) {}

    bool has(std::uint32_t a, std::uint32_t b) const noexcept {
        const std::uint32_t e = pairs_.find(a, b);
        return e != no_index && !records_[e].is_lost;
    }
    // An edge that there is.
    Origin origin(std::uint32_t a, std::uint32_t b) const noexcept {
        return records_[pairs_.find(a, b)].origin;
    }
    void add(std::uint32_t a, std::uint32_t b, Origin origin) {
        const std::uint32_t e = pairs_.add(a, b);
        if (e == records_.size()) records_.push_back({});
        records_[e] = {a, b, origin, false};
    }
    void remove(std::uint32_t a, std::uint32_t b) noexcept {
        records_[pairs_.find(a, b)].is_lost = true;
    }
    // Calls f(a, b, origin) for each edge, in the order in which they were added.
    template <class F>
    void for_each(const F& f) const {
        for (std::uint32_t e = 0; e < records_.size(); ++e)
            if (!records_[e].is_lost) f(records_[e].a, records_[e].b, records_[e].origin);
    }

  private:
    struct Record {
        std::uint32_t a, b;
        Origin origin;
        bool is_lost;
    };
    PairTable pairs_;
    Buffer<Record> records_;
};

}  // namespace mgdt
