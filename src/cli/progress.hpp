// SPDX-License-Identifier: MIT
// A progress bar on standard error, drawn only where a person can see it.
#pragma once

#include <chrono>
#include <string>

namespace mgdt::cli {

class Progress {
  public:
    Progress(std::string what, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(double fraction);

    // The same, for the library: whether a signal has come, which cancels.
    bool update_and_hear(double fraction);

  private:
    std::string what_;
    bool shown_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point begin_, last_;
};

}  // namespace mgdt::cli
