// SPDX-License-Identifier: MIT
// NumPy arrays, as points and as tetrahedra.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    if (const auto mesh = fuzz::read(mgdt::cli::npy_format(), bytes))
        fuzz::points_return(mgdt::cli::npy_format(), mesh->points);
    fuzz::fields_return(mgdt::cli::npy_format(), bytes);
    const std::vector<char> copy(bytes.begin(), bytes.end());
    const fuzz::Source source{"file", "", {copy.data(), copy.size()}};
    if (const auto f =
            fuzz::attempt(bytes.size(), [&] { return mgdt::cli::read_npy_values(source); })) {
        FUZZ_REQUIRE(f->components > 0 && f->values.size() % f->components == 0, "values");
    }

    const auto rows_of = [](std::string_view file, int base) {
        const std::vector<char> exact(file.begin(), file.end());
        const fuzz::Source source{"file", "", {exact.data(), exact.size()}};
        return fuzz::attempt(file.size(), [&] {
            return mgdt::cli::read_npy_tetrahedra(source, base, 20, "points");
        });
    };
    for (int base = 0; base < 2; ++base) {
        const auto rows = rows_of(bytes, base);
        if (!rows) continue;
        const std::string path = fuzz::Scratch::get().file("rows");
        mgdt::cli::OutputSet outputs;
        mgdt::cli::write_npy_rows_of_4(*rows, base, outputs.open(path));
        outputs.commit();
        const auto again = rows_of(fuzz::bytes_of(path), base);
        FUZZ_REQUIRE(again == rows, "rows of a round trip");
    }
    return 0;
}
