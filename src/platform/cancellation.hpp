// SPDX-License-Identifier: MIT
// Disables pthread_cancel() during each call of the library, callbacks included. If a thread were
// unwound inside a call, the mesh would be left half changed, and a team of threads would work on a
// stack frame that is gone. A pending request takes effect at the first cancellation point after
// the call.
#pragma once

#if (defined(__unix__) || defined(__APPLE__)) && !defined(__ANDROID__)
#include <pthread.h>
#define MGDT_HAVE_PTHREAD_CANCEL 1
#endif

namespace mgdt {

class CancellationDisabled {
  public:
#if MGDT_HAVE_PTHREAD_CANCEL
    // Neither the constructor nor the destructor is noexcept: a thread whose cancellation type is
    // asynchronous may be cancelled before the constructor takes effect, or within the destructor.
    // See run_inside() in capi/guard.hpp.
    CancellationDisabled() {
        pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_);
    }
    ~CancellationDisabled() noexcept(false) {
        pthread_setcancelstate(before_, nullptr);
    }
    // Disables cancellation for the rest of the thread's life.
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
