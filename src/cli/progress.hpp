// SPDX-License-Identifier: MIT
// A progress bar on standard error. It is drawn on terminals only.
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

    // The same as a callback for the library: returns whether a signal has arrived, which cancels.
    bool update_and_hear(double fraction);

  private:
    std::string what_;
    bool shown_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point begin_, last_;
};

}  // namespace mgdt::cli
