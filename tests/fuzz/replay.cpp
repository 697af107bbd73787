// SPDX-License-Identifier: MIT
// Runs a fuzz target on given files, and on every file in given folders, without a fuzzer.
#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "../small.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::filesystem::path current;

// A target that finds something aborts: the file's name comes after its message.
void name_file(int) {
    std::fprintf(stderr, "the input is %s\n", current.c_str());
    std::_Exit(1);
}

std::vector<std::filesystem::path> files_of(int count, char** arguments) {
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < count; ++i) {
        const std::filesystem::path path = arguments[i];
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(path))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGABRT, name_file);
    const std::vector<std::filesystem::path> files = files_of(argc - 1, argv + 1);
    // Under Valgrind and the like, some of them.
    const std::size_t step = is_small() && files.size() > 20 ? 10 : 1;
    std::size_t count = 0;
    for (std::size_t i = 0; i < files.size(); i += step, ++count) {
        current = files[i];
        std::ifstream in(current, std::ios::binary);
        if (!in) {
            std::fprintf(stderr, "%s cannot be read\n", current.c_str());
            return 1;
        }
        const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    std::printf("%zu inputs\n", count);
    return count == 0 ? 1 : 0;
}
