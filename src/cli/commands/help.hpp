// SPDX-License-Identifier: MIT
// The ends of help texts.
#pragma once

#include <string>

namespace mgdt::cli {

std::string exit_codes();
// The formats that files may have, and the exit codes.
std::string formats_and_exit_codes();

}  // namespace mgdt::cli
