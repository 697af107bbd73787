// SPDX-License-Identifier: MIT
#include "improvement/change_round.hpp"

#include <algorithm>

namespace mgdt {

void ChangeRound::begin(std::size_t n) {
    for (Finder& finder : finders_) finder.list.clear();
    found_.clear();
    found_.resize(n, {0, no_index});
    ++mesh_.round;
}

std::size_t ChangeRound::apply() {
    order_.clear();
    for (std::uint32_t k = 0; k < found_.size(); ++k)
        if (found_[k].number != no_index) order_.push_back(k);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t one, std::uint32_t other) {
        return before(one) != before(other) ? before(one) < before(other) : one < other;
    });
    claimed_.grow(mesh_.tetrahedra.size());
    claimed_.resize(mesh_.tetrahedra.size(), 0);
    std::size_t applied = 0;
    for (const std::uint32_t k : order_) {
        finders_[found_[k].member].list.get(found_[k].number, change_);
        if (std::any_of(change_.removed.begin(), change_.removed.end(),
                        [&](std::uint32_t t) { return claimed_[t] == mesh_.round; }))
            continue;
        for (const std::uint32_t t : change_.removed) claimed_[t] = mesh_.round;
        if (mesh_.apply(change_)) ++applied;
    }
    return applied;
}

}  // namespace mgdt
