// SPDX-License-Identifier: MIT
// Parts of one triangulation as the program uses them.
#pragma once

#include <cstdint>
#include <string>

#include "cli/output_file.hpp"
#include "cli/program_triangulation.hpp"
#include "mgdt/mgdt_parts.h"

namespace mgdt::cli {

class ProgramParts {
  public:
    // Takes the handle over.
    ProgramParts(mgdt_parts* handle, const TriangulationOptions& options);
    ~ProgramParts() { mgdt_parts_destroy(handle_); }
    ProgramParts(const ProgramParts&) = delete;
    ProgramParts& operator=(const ProgramParts&) = delete;

    mgdt_parts* get() const { return handle_; }
    std::string message(mgdt_status status) const;
    // Throws what the failure of `doing` means for the user.
    void require(mgdt_status status, const std::string& doing) const;
    std::int64_t number(std::int32_t part, std::int32_t key) const;

  private:
    mgdt_parts* handle_;
};

// Writes the tetrahedra that a part owns as a piece of a mesh, and closes the file.
void write_part(const mgdt_parts* parts, std::int32_t part, bool compress, OutputFile& out);

}  // namespace mgdt::cli
