// SPDX-License-Identifier: MIT
// What calls that read a mesh are given: the threads, the memory and the numbers that they use.
#pragma once

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "query/numbering.hpp"

namespace mgdt {

struct MeshView {
    Team& team;
    const Mesh& mesh;
    const Numbering* numbering;  // nullptr if no numbers of tetrahedra are needed
    Allocator& allocator;
    std::int32_t base;
    bool canonical;
};

}  // namespace mgdt
