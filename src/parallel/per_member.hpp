// SPDX-License-Identifier: MIT
// One object for each thread of a team.
#pragma once

#include "parallel/team.hpp"
#include "platform/objects.hpp"

namespace mgdt {

template <class T>
class PerMember : public Objects<T> {
  public:
    template <class... Arguments>
    PerMember(const Team& team, Allocator& allocator, const Arguments&... arguments)
        : Objects<T>(allocator, team.size(), arguments...) {}
};

}  // namespace mgdt
