// SPDX-License-Identifier: MIT
// Text in XML, where five characters are replaced by entities.
#pragma once

#include <string>
#include <string_view>

namespace mgdt::cli {

std::string from_xml(std::string_view text);
std::string to_xml(std::string_view text);

}  // namespace mgdt::cli
