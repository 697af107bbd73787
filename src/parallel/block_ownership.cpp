// SPDX-License-Identifier: MIT
#include "parallel/block_ownership.hpp"

namespace mgdt {

BlockOwners::BlockOwners(Allocator& allocator, std::size_t n, void (*pause)())
    : pause_(pause), shift_(shift_for(n)), owners_(allocator, (n >> shift_) + 1) {}

unsigned BlockOwners::shift_for(std::size_t n) noexcept {
    unsigned shift = least_shift;
    while (shift < most_shift && n >> shift > most_blocks) ++shift;
    return shift;
}

OwnedBlocks::OwnedBlocks(Allocator& allocator, BlockOwners& owners, std::uint8_t who) noexcept
    : owners_(&owners.owners_[0]),
      shift_(owners.shift_),
      who_(who),
      pause_(owners.pause_),
      blocks_(allocator) {}

OwnedBlocks::~OwnedBlocks() {
    release();
}

bool OwnedBlocks::try_own(std::uint32_t item) noexcept {
    if (MGDT_UNLIKELY(pause_ != nullptr)) pause_();
    const std::uint32_t block = item >> shift_;
    std::uint8_t nobody = BlockOwners::nobody;
    if (owners_[block].load(std::memory_order_relaxed) != nobody) return false;
    try {
        blocks_.grow(blocks_.size() + 1);
    } catch (const std::bad_alloc&) {
        return false;  // as if another thread owned the block
    }
    if (!owners_[block].compare_exchange_strong(nobody, who_, std::memory_order_acquire,
                                                std::memory_order_relaxed))
        return false;
    annotate_acquire(owners_ + block);
    blocks_.push_back(block);
    return true;
}

void OwnedBlocks::release(const std::uint32_t* kept, std::size_t count) noexcept {
    std::size_t stay = 0;
    for (const std::uint32_t block : blocks_) {
        bool is_kept = false;
        for (std::size_t i = 0; i < count; ++i) is_kept = is_kept || kept[i] >> shift_ == block;
        if (is_kept) {
            blocks_[stay++] = block;
            continue;
        }
        annotate_release(owners_ + block);
        owners_[block].store(BlockOwners::nobody, std::memory_order_release);
    }
    blocks_.resize_within_capacity(stay);
    if (MGDT_UNLIKELY(pause_ != nullptr)) pause_();
}

}  // namespace mgdt
