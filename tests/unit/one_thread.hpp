// SPDX-License-Identifier: MIT
// A team for tests that do not depend on the number of threads.
#pragma once

#include "parallel/team.hpp"

namespace mgdt {

inline Team& one_thread() {
    static Team team(1);
    return team;
}

}  // namespace mgdt
