// SPDX-License-Identifier: MIT
// How much stack a call takes: of the thread that makes it and of those that it starts. Each of
// them gets a stack that is painted before and looked at afterwards. A program has this in one
// file, since it defines pthread_create().
#pragma once

#include <dlfcn.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace faults {

// Of a thread at a time. Below it lies a page that nobody may touch.
class PaintedStack {
  public:
    using Body = void* (*)(void*);

    // Of `bytes` in pages.
    void make(std::size_t bytes) {
        const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        size_ = (bytes + page - 1) / page * page;
        void* const p = mmap(nullptr, page + size_, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (p == MAP_FAILED || mprotect(p, page, PROT_NONE) != 0) std::abort();
        mapping_ = static_cast<unsigned char*>(p);
        base_ = reinterpret_cast<std::uint64_t*>(mapping_ + page);
    }
    void drop() {
        if (mapping_) munmap(mapping_, static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + size_);
        mapping_ = nullptr;
    }

    template <class Create>
    int start(Create create, pthread_t* thread, Body body, void* argument) {
        std::fill_n(base_, size_ / sizeof *base_, paint);
        top_ = nullptr;
        body_ = body;
        argument_ = argument;
        pthread_attr_t attributes;
        if (pthread_attr_init(&attributes) != 0 ||
            pthread_attr_setstack(&attributes, base_, size_) != 0)
            std::abort();
        const int result = create(
            thread, &attributes,
            [](void* self) {
                auto* const stack = static_cast<PaintedStack*>(self);
                stack->top_ = static_cast<unsigned char*>(__builtin_frame_address(0));
                return stack->body_(stack->argument_);
            },
            this);
        pthread_attr_destroy(&attributes);
        return result;
    }

    // When the thread is joined: bytes below the first frame, down to the last one written.
    std::size_t used() const {
        if (!top_) return 0;
        const std::uint64_t* const end = base_ + size_ / sizeof *base_;
        const std::uint64_t* const last = std::find_if<const std::uint64_t*>(
            base_, end, [](std::uint64_t word) { return word != paint; });
        return static_cast<std::size_t>(top_ - reinterpret_cast<const unsigned char*>(last));
    }
    // What lies above the first frame: the C library's.
    std::size_t above() const {
        return static_cast<std::size_t>(reinterpret_cast<unsigned char*>(base_) + size_ - top_);
    }

  private:
    static constexpr std::uint64_t paint = 0xA5C35A3CA5C35A3C;

    unsigned char* mapping_ = nullptr;
    std::uint64_t* base_ = nullptr;
    std::size_t size_ = 0;
    unsigned char* top_ = nullptr;
    Body body_ = nullptr;
    void* argument_ = nullptr;
};

inline constexpr unsigned most_workers = 8;
inline PaintedStack caller_stack, worker_stacks[most_workers];
inline std::atomic<unsigned> workers{0};
inline std::atomic<bool> is_measuring{false};

using PthreadCreate = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
inline PthreadCreate real_pthread_create() {
    static const auto real = reinterpret_cast<PthreadCreate>(dlsym(RTLD_NEXT, "pthread_create"));
    return real;
}

// Every thread has so much stack.
inline void make_stacks(std::size_t bytes) {
    real_pthread_create();
    caller_stack.drop();
    caller_stack.make(bytes);
    for (PaintedStack& stack : worker_stacks) {
        stack.drop();
        stack.make(bytes);
    }
}

struct StackUse {
    std::size_t of_caller = 0, of_worker = 0;
    unsigned workers = 0;
};

template <class Call>
StackUse stack_use_of(Call& call) {
    workers = 0;
    is_measuring = true;
    pthread_t thread;
    if (caller_stack.start(
            real_pthread_create(), &thread,
            [](void* call_) -> void* {
                (*static_cast<Call*>(call_))();
                return nullptr;
            },
            &call) != 0)
        std::abort();
    pthread_join(thread, nullptr);
    is_measuring = false;
    StackUse use;
    use.of_caller = caller_stack.used();
    use.workers = workers;
    for (unsigned k = 0; k < use.workers; ++k)
        use.of_worker = std::max(use.of_worker, worker_stacks[k].used());
    return use;
}

}  // namespace faults

// Before the C library's own.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*body)(void*), void* argument) noexcept {
    using namespace faults;
    if (!is_measuring) return real_pthread_create()(thread, attributes, body, argument);
    const unsigned k = workers++;
    if (k >= most_workers) std::abort();
    return worker_stacks[k].start(real_pthread_create(), thread, body, argument);
}
