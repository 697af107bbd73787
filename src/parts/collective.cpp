// SPDX-License-Identifier: MIT
#include "parts/collective.hpp"

namespace mgdt {

// With room for what is said of failures, which must not need memory then.
Collective::Collective(Transport& transport, Allocator& allocator)
    : transport_(transport),
      mine_(allocator, transport.local_parts()),
      all_(allocator, transport.parts()) {}

void Collective::agree(const Error* mine) {
    std::uint64_t failures = mine ? 1 : 0;
    transport_.sum(&failures, 1);
    if (failures == 0) return;
    has_failed_ = true;
    for (Failure& f : mine_) f = Failure{mine ? std::uint64_t{1} : 0, mine ? *mine : Error{}};
    transport_.gather(mine_.data(), sizeof(Failure), all_.data());
    PartId part = 0;
    while (all_[part].has_failed == 0) ++part;
    throw all_[part].error;
}

void Collective::report(const Error& error) {
    // What the others have told is known everywhere.
    if (has_failed_) throw error;
    agree(&error);
    throw error;
}

}  // namespace mgdt
