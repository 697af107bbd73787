// SPDX-License-Identifier: MIT
// pthread_cancel() of the calling thread must not act inside a call: a thread that is unwound in
// the middle leaves a mesh that is half changed, and a team whose frame is gone while it works. So
// cancellation is disabled for the duration of each call, callbacks included. A pending request
// acts at the first cancellation point after the call.
#pragma once

#if (defined(__unix__) || defined(__APPLE__)) && !defined(__ANDROID__)
#include <pthread.h>
#define MGDT_HAVE_PTHREAD_CANCEL 1
#endif

namespace mgdt {

class CancellationDisabled {
  public:
#if MGDT_HAVE_PTHREAD_CANCEL
    // Neither is noexcept: a thread of the asynchronous type may be cancelled before the one and
    // within the other, which unwinds the caller's frame. See run_inside() in capi/handle.hpp.
    CancellationDisabled() {
        pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_);
    }
    ~CancellationDisabled() noexcept(false) {
        pthread_setcancelstate(before_, nullptr);
    }
    // For the rest of a thread's life.
    static void for_good() noexcept {
        pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, nullptr);
    }
#else
    CancellationDisabled() {}
    ~CancellationDisabled() {}
    static void for_good() noexcept {}
#endif
    CancellationDisabled(const CancellationDisabled&) = delete;
    CancellationDisabled& operator=(const CancellationDisabled&) = delete;

#if MGDT_HAVE_PTHREAD_CANCEL
  private:
    int before_;
#endif
};

}  // namespace mgdt
