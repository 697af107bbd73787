// SPDX-License-Identifier: MIT
// Types of the items of arrays, by the names that VTK's XML files have for them.
#pragma once

#include <cstdint>
#include <string_view>

namespace mgdt::cli {

// Calls act with a value of the type. Returns false if it is not a type of numbers.
template <class Act>
bool with_type(std::string_view type, const Act& act) {
    if (type == "Float64") return act(double()), true;
    if (type == "Float32") return act(float()), true;
    if (type == "Int64") return act(std::int64_t()), true;
    if (type == "UInt64") return act(std::uint64_t()), true;
    if (type == "Int32") return act(std::int32_t()), true;
    if (type == "UInt32") return act(std::uint32_t()), true;
    if (type == "Int16") return act(std::int16_t()), true;
    if (type == "UInt16") return act(std::uint16_t()), true;
    if (type == "Int8") return act(std::int8_t()), true;
    if (type == "UInt8") return act(std::uint8_t()), true;
    return false;
}

}  // namespace mgdt::cli
