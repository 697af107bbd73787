// SPDX-License-Identifier: MIT
// Finds the runners of other libraries. Runners are separate programs, since their licences (GPL,
// AGPL) do not fit this one. They are built in tests/bench/peers and not installed.
#pragma once

#include <string>

namespace mgdt::cli::bench {

// The path of a peer's runner, or an empty string if there is none. The function looks into the
// given folder; without one, beside this program and into its build folder.
std::string find_runner(const std::string& peer, const std::string& directory);

// The message for a user who has no runner.
std::string how_to_get_runner(const std::string& peer, const std::string& directory);

}  // namespace mgdt::cli::bench
