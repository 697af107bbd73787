// SPDX-License-Identifier: MIT
// Points as text and CSV, with the columns as they come and with others chosen.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    mgdt::cli::ReadOptions other;
    other.columns = {{4, 2, 2}};
    fuzz::read(mgdt::cli::text_format(), bytes, "", other);
    if (const auto mesh = fuzz::read(mgdt::cli::text_format(), bytes)) {
        fuzz::points_return(mgdt::cli::text_format(), mesh->points);
        fuzz::points_return(mgdt::cli::csv_format(), mesh->points);
    }
    fuzz::fields_return(mgdt::cli::text_format(), bytes);
    fuzz::fields_return(mgdt::cli::csv_format(), bytes);
    return 0;
}
