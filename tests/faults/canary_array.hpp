// SPDX-License-Identifier: MIT
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>

#include "../property/handle.hpp"

namespace canaries {

// An array of its own pages. What is around it is inaccessible on one side and known on the other.
class Array {
  public:
    enum Place { at_the_end, at_the_begin, off_by_one };
    static constexpr unsigned char known = 0xC5;

    Array(std::size_t elements, std::size_t element_size, Place place)
        : size_(elements * element_size) {
        const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        inner_ = (size_ + element_size + page) / page * page;
        mapped_ = inner_ + 2 * page;
        void* const p = mmap(nullptr, mapped_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (p == MAP_FAILED) throw std::bad_alloc();
        whole_ = static_cast<unsigned char*>(p);
        begin_ = whole_ + page;
        if (mprotect(begin_, inner_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
        std::memset(begin_, known, inner_);
        data_ = place == at_the_end     ? begin_ + inner_ - size_
                : place == at_the_begin ? begin_
                                        : begin_ + element_size;
    }
    Array(Array&& other) noexcept { *this = std::move(other); }
    Array& operator=(Array&& other) noexcept {
        std::swap(whole_, other.whole_);
        std::swap(begin_, other.begin_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(inner_, other.inner_);
        std::swap(mapped_, other.mapped_);
        return *this;
    }
    ~Array() {
        if (whole_) munmap(whole_, mapped_);
    }
    void* data() const { return data_; }
    // Nothing outside was written.
    bool is_whole() const {
        for (const unsigned char* p = begin_; p != begin_ + inner_; ++p)
            if ((p < data_ || p >= data_ + size_) && *p != known) return false;
        return true;
    }
    bool is_untouched() const {
        for (std::size_t i = 0; i < size_; ++i)
            if (data_[i] != known) return false;
        return is_whole();
    }
    // Every element was written: none has all its bytes as they were.
    bool is_written(std::size_t element_size) const {
        for (std::size_t i = 0; i < size_; i += element_size) {
            bool differs = false;
            for (std::size_t k = 0; k < element_size; ++k) differs |= data_[i + k] != known;
            if (!differs) return false;
        }
        return true;
    }

  private:
    unsigned char *whole_ = nullptr, *begin_ = nullptr, *data_ = nullptr;
    std::size_t size_ = 0, inner_ = 0, mapped_ = 0;
};

}  // namespace canaries
