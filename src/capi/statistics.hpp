// SPDX-License-Identifier: MIT
// Numbers of an object by key, which all handles give in the same way.
#pragma once

#include <cstdint>

#include "capi/guard.hpp"

namespace mgdt {

template <class Object>
struct IntegerStatistic {
    std::int32_t key;
    std::size_t (*value)(const Object&);
};

// The body of a function that gives a number of `object`, which the handle has.
template <class Object, std::size_t n>
mgdt_status get_stat(const HandleBase* handle, const Object* object,
                     const IntegerStatistic<Object> (&table)[n], std::int32_t key,
                     std::int64_t* value, const char* name = __builtin_FUNCTION()) {
    return guard(
        handle,
        [&] {
            require_pointer(value, "value");
            for (const IntegerStatistic<Object>& s : table)
                if (s.key == key) {
                    *value = static_cast<std::int64_t>(s.value(*object));
                    return;
                }
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no number %d", static_cast<int>(key));
        },
        name);
}

}  // namespace mgdt
