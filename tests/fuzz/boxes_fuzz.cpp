// SPDX-License-Identifier: MIT
// Files with periodic boxes: LAMMPS dumps and data files, POSCAR, and extended .xyz, which is the
// reader of text files. The first byte says which.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const mgdt::cli::Format* const formats[4] = {
        &mgdt::cli::lammps_dump_format(), &mgdt::cli::lammps_data_format(),
        &mgdt::cli::poscar_format(), &mgdt::cli::text_format()};
    const mgdt::cli::Format& format = *formats[data[0] % 4];
    const std::string_view bytes = fuzz::text_of(data + 1, size - 1);
    fuzz::guess(bytes);
    mgdt::cli::ReadOptions with_fields;
    with_fields.has_fields = true;
    fuzz::read(format, bytes, "", with_fields);
    const auto mesh = fuzz::read(format, bytes);
    if (!mesh || !mesh->box) return 0;
    for (const double x : mesh->box->vectors) FUZZ_REQUIRE(std::isfinite(x), "a vector");
    return 0;
}
