// SPDX-License-Identifier: MIT
// Remembers which tries to improve a mesh have failed. A try is not repeated until tetrahedra there
// have changed.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

class FailedTries {
  public:
    // Several kinds of tries, with one bit for each.
    using Kinds = std::uint8_t;
    struct Kind {
        Kinds bit;
        Kinds implied;  // the kinds that fail wherever this one fails, with its own bit
    };

    explicit FailedTries(Allocator& allocator) : items_(allocator) {}

    // What is tried is a tetrahedron or a vertex: there are `count`.
    void resize(std::size_t count) {
        items_.grow(count);
        items_.resize(count, {0, 0});
    }
    // Whether tries of this kind have failed in a round after the last change.
    bool has(std::size_t i, Kind kind, std::uint32_t last_change) const noexcept {
        return last_change < items_[i].round && (items_[i].kinds & kind.bit) != 0;
    }
    // A try of this kind has failed in a round. Threads add different i.
    void add(std::size_t i, Kind kind, std::uint32_t round, std::uint32_t last_change) noexcept {
        Item& item = items_[i];
        if (last_change >= item.round) item.kinds = 0;
        item.kinds = static_cast<Kinds>(item.kinds | kind.implied);
        item.round = round;
    }

  private:
    struct Item {
        std::uint32_t round;
        Kinds kinds;
    };
    Buffer<Item> items_;
};

}  // namespace mgdt
