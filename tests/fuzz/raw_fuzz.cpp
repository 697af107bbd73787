// SPDX-License-Identifier: MIT
// Points as bare doubles, and from there through every format that holds points.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    if (const auto mesh = fuzz::read(mgdt::cli::raw_format(), bytes)) {
        for (const mgdt::cli::Format* format : mgdt::cli::all_formats())
            if (format->write_points) fuzz::points_return(*format, mesh->points);
    }
    return 0;
}
