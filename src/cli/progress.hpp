// SPDX-License-Identifier: MIT
// A progress bar on standard error, drawn only where a person can see it.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace mgdt::cli {

class Progress {
  public:
    Progress(std::string what, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(double fraction);

    // An mgdt_progress_fn; `user` is the Progress. Cancels once a signal has come.
    static std::int32_t callback(double fraction, void* user);

  private:
    std::string what_;
    bool shown_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point begin_, last_;
};

}  // namespace mgdt::cli
