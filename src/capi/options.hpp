// SPDX-License-Identifier: MIT
// Options by key: those that all handles have, and those of one handle.
#pragma once

#include <initializer_list>
#include <limits>

#include "capi/handle.hpp"

namespace mgdt {

// The keys that the options of all handles have: MGDT_PARTS_INDEX_BASE and so on.
enum CommonOption : std::int32_t {
    option_index_base = 10,
    option_threads = 20,
    option_memory_limit = 30
};

// An option of one handle: a switch, which is 0 or 1, or a number from 0 to `most`.
template <class Settings>
class OwnOption {
  public:
    constexpr OwnOption(std::int32_t key, bool Settings::*value)
        : key(key), most(1), flag_(value) {}
    constexpr OwnOption(std::int32_t key, std::int32_t Settings::*value, std::int32_t most)
        : key(key), most(most), number_(value) {}

    std::int64_t get(const Settings& settings) const {
        return flag_ ? (settings.*flag_ ? 1 : 0) : settings.*number_;
    }
    void set(Settings& settings, std::int64_t value) const {
        if (flag_)
            settings.*flag_ = value != 0;
        else
            settings.*number_ = static_cast<std::int32_t>(value);
    }
    std::int32_t key, most;

  private:
    bool Settings::*flag_ = nullptr;
    std::int32_t Settings::*number_ = nullptr;
};
template <class Settings>
using OwnOptions = std::initializer_list<OwnOption<Settings>>;

// A double of one handle, at least 0 and below `bound`.
template <class Settings>
struct DoubleOption {
    std::int32_t key;
    double Settings::*value;
    double bound;
};

template <class Object, class Settings>
void set_option(Object& object, const OwnOptions<Settings>& own, std::int32_t key,
                std::int64_t value) {
    const auto require_up_to = [&](std::int64_t most) {
        if (value < 0 || value > most)
            fail(MGDT_ERR_INVALID_ARGUMENT, "%lld is out of the range of option %d",
                 static_cast<long long>(value), static_cast<int>(key));
    };
    switch (key) {
        case option_index_base:
            require_up_to(1);
            object.settings().index_base = static_cast<std::int32_t>(value);
            return;
        case option_threads:
            require_up_to(std::numeric_limits<std::int32_t>::max());
            object.settings().threads = static_cast<std::int32_t>(value);
            return;
        case option_memory_limit:
            require_up_to(std::numeric_limits<std::int64_t>::max());
            object.allocator().set_limit(limit_of(value));
            return;
        default:
            break;
    }
    for (const OwnOption<Settings>& option : own)
        if (option.key == key) {
            require_up_to(option.most);
            option.set(object.settings(), value);
            return;
        }
    fail(MGDT_ERR_UNKNOWN_KEY, "there is no option %d", static_cast<int>(key));
}

template <class Object, class Settings>
std::int64_t option_of(const Object& object, const OwnOptions<Settings>& own, std::int32_t key) {
    switch (key) {
        case option_index_base:
            return object.settings().index_base;
        case option_threads:
            return object.settings().threads;
        case option_memory_limit:
            return static_cast<std::int64_t>(object.allocator().limit());
        default:
            break;
    }
    for (const OwnOption<Settings>& option : own)
        if (option.key == key) return option.get(object.settings());
    fail(MGDT_ERR_UNKNOWN_KEY, "there is no option %d", static_cast<int>(key));
}

template <class Options>
const auto& double_option(const Options& own, std::int32_t key) {
    for (const auto& option : own)
        if (option.key == key) return option;
    fail(MGDT_ERR_UNKNOWN_KEY, "there is no option %d with a double", static_cast<int>(key));
}
// The bodies of the functions that set and get a double.
template <class H, class Options>
mgdt_status set_double_option(H* handle, std::int32_t key, double value, const Options& own,
                              const char* name = __builtin_FUNCTION()) {
    return guard(
        handle,
        [&] {
            const auto& option = double_option(own, key);
            if (!(value >= 0 && value < option.bound))
                fail(MGDT_ERR_INVALID_ARGUMENT,
                     "%g is out of the range of option %d, which is from 0 to less than %g", value,
                     static_cast<int>(key), option.bound);
            handle->object.settings().*option.value = value;
        },
        name);
}
template <class H, class Options>
mgdt_status get_double_option(const H* handle, std::int32_t key, double* value, const Options& own,
                              const char* name = __builtin_FUNCTION()) {
    return guard_short(
        handle,
        [&] {
            require_pointer(value, "value");
            const auto& option = double_option(own, key);
            *value = handle->object.settings().*option.value;
        },
        name);
}

// The bodies of the functions that set and get an option.
template <class H, class Settings = CallSettings>
mgdt_status set_option(H* handle, std::int32_t key, std::int64_t value,
                       const OwnOptions<Settings>& own = {},
                       const char* name = __builtin_FUNCTION()) {
    return guard(
        handle, [&] { set_option(handle->object, own, key, value); }, name);
}
template <class H, class Settings = CallSettings>
mgdt_status get_option(const H* handle, std::int32_t key, std::int64_t* value,
                       const OwnOptions<Settings>& own = {},
                       const char* name = __builtin_FUNCTION()) {
    return guard_short(
        handle,
        [&] {
            require_pointer(value, "value");
            *value = option_of(handle->object, own, key);
        },
        name);
}

}  // namespace mgdt
