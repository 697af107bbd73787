// SPDX-License-Identifier: MIT
// An input of a fuzz target taken apart, and what a target says when it has found something.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace fuzz {

// The bytes from first to last. After the end come zeros, so that every input means something.
class Input {
  public:
    Input(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

    bool empty() const { return at_ == end_; }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    unsigned byte() { return empty() ? 0u : *at_++; }
    // Less than n, which is at most 256.
    unsigned below(unsigned n) { return byte() % n; }
    bool flag() { return (byte() & 1) != 0; }

    template <class T>
    T value() {
        unsigned char bytes[sizeof(T)];
        for (unsigned char& b : bytes) b = static_cast<unsigned char>(byte());
        T out;
        std::memcpy(&out, bytes, sizeof out);
        return out;
    }

  private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
};

// A finding ends the process: the fuzzer keeps the input, and a test fails.
[[noreturn]] inline void report(const char* file, int line, const std::string& what) {
    std::fprintf(stderr, "%s:%d: %s\n", file, line, what.c_str());
    std::abort();
}

}  // namespace fuzz

// `text` may be any expression that gives a std::string; it is evaluated in case of failure.
#define FUZZ_REQUIRE(condition, text)                                                          \
    do {                                                                                       \
        if (!(condition))                                                                      \
            ::fuzz::report(__FILE__, __LINE__, std::string(#condition) + " fails: " + (text)); \
    } while (false)
