// SPDX-License-Identifier: MIT
// Where the runners of other libraries are. These are programs apart, since their licences (GPL,
// AGPL) are not for this one; they are built in tests/bench/peers and not installed.
#pragma once

#include <string>

namespace mgdt::cli::bench {

// The path of a peer's runner: in the folder that is named, or else beside this program or in its
// build folder. Empty if there is none.
std::string find_runner(const std::string& peer, const std::string& directory);

// The message for a user who has no runner.
std::string how_to_get_runner(const std::string& peer, const std::string& directory);

}  // namespace mgdt::cli::bench
