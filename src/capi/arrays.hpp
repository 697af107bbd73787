// SPDX-License-Identifier: MIT
// Arrays of results by key. A handle has one table of its arrays. From it come sizes, the shapes
// that the caller asks for, the checks of arguments, and the writing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <tuple>
#include <type_traits>

#include "capi/guard.hpp"
#include "platform/memory.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

// What stands for no number in arrays of numbers in 32 bits.

// How the elements of an array are written.
enum class Element : std::uint8_t {
    number,   // from the index base on; no_index becomes the index base - 1
    flagged,  // a number, or, with the highest of 32 bits, k, which is written as -1 - k
    integer,  // as it is
    real      // a double
};

// An array: `read`, a function of the object or one of its members, is a Buffer, Computed or
// Filled.
template <Element E, class Read>
struct Array {
    static constexpr bool is_double = E == Element::real;

    std::int32_t key;
    std::int32_t columns;  // how many elements belong together
    Read read;
};
template <Element E, class Read>
constexpr Array<E, Read> array(std::int32_t key, std::int32_t columns, Read read) {
    return {key, columns, read};
}

// Elements that are computed one by one: each(f) calls f(element) for all of them, in order.
template <class Each>
class Computed {
  public:
    Computed(std::size_t size, Each each) : each(each), size_(size) {}
    std::size_t size() const noexcept { return size_; }
    Each each;

  private:
    std::size_t size_;
};

// Elements that are written by a function: fill(values).
template <class Fill>
class Filled {
  public:
    Filled(std::size_t size, Fill fill) : fill(fill), size_(size) {}
    std::size_t size() const noexcept { return size_; }
    Fill fill;

  private:
    std::size_t size_;
};

// Elements that are of(0), ..., of(size - 1).
template <class Of>
auto computed_each(std::size_t size, const Of& of) {
    return Computed(size, [size, of](const auto& f) {
        for (std::size_t i = 0; i < size; ++i) f(of(i));
    });
}

template <class T, class F>
void for_each_element(const Buffer<T>& of, const F& f) {
    for (const T& element : of) f(element);
}
template <class Each, class F>
void for_each_element(const Computed<Each>& of, const F& f) {
    of.each(f);
}

// The integer that the caller reads.
template <Element E, class T>
std::int64_t written(const T& element, std::int64_t base) noexcept {
    if constexpr (E == Element::integer) {
        return static_cast<std::int64_t>(element);
    } else if constexpr (E == Element::flagged) {
        constexpr std::uint32_t flag = 0x80000000u;
        return (element & flag) != 0 ? -1 - static_cast<std::int64_t>(element & ~flag)
                                     : static_cast<std::int64_t>(element) + base;
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return (element == no_index ? -1 : static_cast<std::int64_t>(element)) + base;
    } else {
        return static_cast<std::int64_t>(element) + base;
    }
}

[[noreturn]] MGDT_NOT_INLINE inline void refuse_large(std::int64_t value) {
    fail(MGDT_ERR_INDEX_RANGE, "%lld does not fit a 32-bit integer", static_cast<long long>(value));
}

template <Element E, class Elements, class Int>
void write_integers(const Elements& elements, std::int64_t base, Int* values) {
    std::int64_t too_large = 0;
    for_each_element(elements, [&](const auto& element) {
        const std::int64_t value = written<E>(element, base);
        *values = static_cast<Int>(value);
        if (*values++ != value) too_large = value;
    });
    if (too_large != 0) refuse_large(too_large);
}
template <Element E, class Fill, class Int>
void write_integers(const Filled<Fill>& elements, std::int64_t base, Int* values) {
    elements.fill(values);
    if (E == Element::number && base != 0)
        for (std::size_t i = 0; i < elements.size(); ++i) values[i] += base;
}

template <Element E, class Read, class Elements, class Int>
void write(const Array<E, Read>&, const Elements& elements, std::int64_t base, Int* values) {
    write_integers<E>(elements, base, values);
}

template <class Elements>
void write_doubles(const Elements& elements, double* values) {
    for_each_element(elements, [&](double element) { *values++ = element; });
}
inline void write_doubles(const Buffer<double>& elements, double* values) {
    std::copy_n(elements.begin(), elements.size(), values);
}
template <class Fill>
void write_doubles(const Filled<Fill>& elements, double* values) {
    elements.fill(values);
}

template <class Read, class Elements>
void write(const Array<Element::real, Read>&, const Elements& elements, std::int64_t,
           double* values) {
    write_doubles(elements, values);
}

[[noreturn]] MGDT_NOT_INLINE inline void refuse_kind(std::int32_t key, bool wants_doubles) {
    fail(MGDT_ERR_UNKNOWN_KEY, "array %d has %s", static_cast<int>(key),
         wants_doubles ? "integers, not doubles" : "doubles, not integers");
}

// Calls f(array) for the array with this key. Throws if there is none.
template <class... Arrays, class F>
void with_array(const std::tuple<Arrays...>& table, std::int32_t key, const F& f) {
    const bool is_found = std::apply(
        [&](const Arrays&... arrays) { return ((arrays.key == key && (f(arrays), true)) || ...); },
        table);
    if (!is_found) fail(MGDT_ERR_UNKNOWN_KEY, "there is no array %d", static_cast<int>(key));
}

// The body of a function that gives the shape of an array.
template <class Table>
mgdt_status array_info(const Table& table, std::int32_t key, std::int32_t* columns,
                       std::int32_t* is_double) noexcept {
    if (!columns && !is_double) return MGDT_ERR_NULL_POINTER;
    mgdt_status status = MGDT_ERR_UNKNOWN_KEY;
    std::apply(
        [&](const auto&... arrays) {
            const auto look = [&](const auto& array) {
                if (array.key != key) return;
                if (columns) *columns = array.columns;
                if (is_double) *is_double = array.is_double ? 1 : 0;
                status = MGDT_OK;
            };
            (look(arrays), ...);
        },
        table);
    return status;
}

// Writes the elements of an array of `object`. require(object) throws if there are none yet.
template <class Value, class Table, class Object, class Require>
void get_array(const Table& table, const Object& object, std::int32_t key, std::int64_t base,
               std::int64_t capacity, Value* values, const Require& require) {
    constexpr bool wants_doubles = std::is_same_v<Value, double>;
    with_array(table, key, [&](const auto& array) {
        if constexpr (std::remove_reference_t<decltype(array)>::is_double != wants_doubles) {
            refuse_kind(key, wants_doubles);
        } else {
            require(object);
            const auto& elements = std::invoke(array.read, object);
            require_capacity(capacity, elements.size(), "values");
            if (elements.size() == 0) return;
            require_pointer(values, "values");
            write(array, elements, base, values);
        }
    });
}

// The bodies of the functions that give the size and the elements of an array of a handle. See
// entry_points.hpp for Results.
template <class Results, class H>
mgdt_status get_size(const H* h, std::int32_t key, std::int64_t* size,
                     const char* name = __builtin_FUNCTION()) {
    return guard(
        h,
        [&] {
            require_pointer(size, "size");
            with_array(Results::arrays, key, [&](const auto& array) {
                Results::require(Results::of(h->object));
                *size = static_cast<std::int64_t>(
                    std::invoke(array.read, Results::of(h->object)).size());
            });
        },
        name);
}
template <class Results, class Value, class H>
mgdt_status get_elements(const H* h, std::int32_t key, std::int64_t capacity, Value* values,
                         const char* name = __builtin_FUNCTION()) {
    return guard(
        h,
        [&] {
            get_array(Results::arrays, Results::of(h->object), key, h->object.settings().index_base,
                      capacity, values, Results::require);
        },
        name);
}

}  // namespace mgdt
