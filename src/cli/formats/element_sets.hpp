// SPDX-License-Identifier: MIT
// The sets of elements of an Abaqus file, and the regions that they stand for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/formats/node_numbers.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {

// Where sets have the names that mgdt writes, REGION_7 or REGION_M7 for -7, these are the regions.
// Otherwise the regions are the sets of *SOLID SECTION, or if there are none, those that *ELEMENT
// names; they have markers from 1 in the order in which they appear. Elements of no region have the
// marker 0.
class ElementSets {
  public:
    // The next tetrahedron has this number and is in a set, or in none if the name is empty. Calls
    // fail(message), which throws, if another one has the number.
    template <class Fail>
    void add_tetrahedron(std::int64_t number, const std::string& set, const Fail& fail) {
        numbers_.add(number, fail);
        ++count_;
        if (!set.empty()) set_of(set, true).members.push_back(number);
    }
    void add_member(const std::string& set, std::int64_t number) {
        set_of(set, false).members.push_back(number);
    }
    void add_section(const std::string& set) { set_of(set, false).has_section = true; }

    // The markers of all tetrahedra; empty if there are no regions.
    std::vector<std::int32_t> markers() const {
        bool has_named = false, has_sections = false, has_any = false;
        for (const Set& set : sets_) {
            has_named |= marker_in(set.name) != 0;
            has_sections |= set.has_section;
            has_any |= set.is_of_elements;
        }
        if (!has_named && !has_sections && !has_any) return {};
        std::vector<std::int32_t> found(count_, 0);
        std::int32_t next = 0;
        for (const Set& set : sets_) {
            const bool is_region = has_named      ? marker_in(set.name) != 0
                                   : has_sections ? set.has_section
                                                  : set.is_of_elements;
            if (!is_region) continue;
            const std::int32_t marker = has_named ? marker_in(set.name) : ++next;
            for (const std::int64_t number : set.members)
                if (const std::int64_t t = numbers_.find_if(number); t >= 0)
                    found[static_cast<std::size_t>(t)] = marker;
        }
        // A set of all elements says nothing.
        if (!has_named && std::all_of(found.begin(), found.end(),
                                      [&](std::int32_t m) { return m == found.front(); }))
            found.clear();
        return found;
    }

  private:
    struct Set {
        std::string name;
        std::vector<std::int64_t> members;  // numbers of elements
        bool is_of_elements, has_section;
    };
    Set& set_of(const std::string& name, bool is_of_elements) {
        for (Set& set : sets_)
            if (set.name == name) {
                set.is_of_elements |= is_of_elements;
                return set;
            }
        sets_.push_back({name, {}, is_of_elements, false});
        return sets_.back();
    }
    // The marker in a name such as REGION_7; 0 if there is none.
    static std::int32_t marker_in(const std::string& name) {
        constexpr std::string_view prefix = "REGION_";
        if (name.compare(0, prefix.size(), prefix) != 0) return 0;
        const bool is_negative = name.size() > prefix.size() && name[prefix.size()] == 'M';
        std::int64_t value = 0;
        if (!parse_integer(std::string_view(name).substr(prefix.size() + (is_negative ? 1 : 0)),
                           value) ||
            value < 0 || value > INT32_MAX)
            return 0;
        return static_cast<std::int32_t>(is_negative ? -value : value);
    }

    std::vector<Set> sets_;
    NodeNumbers numbers_{"element"};  // of the tetrahedra
    std::size_t count_ = 0;
};

}  // namespace mgdt::cli
