// SPDX-License-Identifier: MIT
#include "cli/commands/help.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "cli/formats/format.hpp"

namespace mgdt::cli {

std::string exit_codes() {
    return "Exit codes:\n"
           "  0    success\n"
           "  1    a check failed: not a valid Delaunay triangulation\n"
           "  2    wrong usage\n"
           "  3    an input cannot be read or is malformed\n"
           "  4    an output cannot be written; no partial file is left\n"
           "  5    out of memory, or too large\n"
           "  6    a defect in mgdt\n"
           "  7    nothing to check: a mesh of other cells than tetrahedra\n"
           "  130  cancelled by Ctrl-C (in general 128 + the signal's number)";
}

std::string formats_and_exit_codes() {
    std::string text = "Formats (chosen by extension, or with --from and --to):\n";
    for (const Format* f : all_formats()) {
        const std::string extensions = fmt::format("{}", fmt::join(f->extensions, " "));
        const std::string does =
            fmt::format("{}{}{}{}{}", f->read ? "read" : "", f->write_points ? ", points" : "",
                        f->write_mesh ? ", tetrahedra" : "", f->write_fields ? ", values" : "",
                        f->write_surface ? ", triangles" : "");
        text += fmt::format("  {:<8} {:<25} {} [{}]\n", f->name, extensions, f->description, does);
    }
    return text +
           "  [points, tetrahedra, values, triangles: what can be written; values are read "
           "too]\n\n" +
           exit_codes();
}

}  // namespace mgdt::cli
