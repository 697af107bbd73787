// SPDX-License-Identifier: MIT
// Runs a fuzz target without a fuzzer on given inputs: files, or those of a packed corpus (a file
// with the suffix .corpus, see corpus.py).
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../support/small.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

struct CorpusInput {
    std::string where;
    std::string bytes;
};

std::string current;

// A target that finds something aborts: where the input stands comes after its message.
void name_input(int) {
    std::fprintf(stderr, "the input is %s\n", current.c_str());
    std::_Exit(1);
}

[[noreturn]] void give_up(const std::string& where, const char* why) {
    std::fprintf(stderr, "%s %s\n", where.c_str(), why);
    std::exit(1);
}

// The bytes of a line of a packed corpus: a string in double quotes behind the name, if there is
// one.
std::string unquoted(const std::string& line, const std::string& where) {
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (first == last) give_up(where, "has no string in double quotes");
    std::string bytes;
    for (std::size_t i = first + 1; i < last; ++i) {
        if (line[i] != '\\') {
            bytes += line[i];
            continue;
        }
        const char escape = line[++i];
        if (escape == 'x') {
            bytes += static_cast<char>(std::stoi(line.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            bytes += escape == 'n' ? '\n' : escape == 'r' ? '\r' : escape == 't' ? '\t' : escape;
        }
    }
    return bytes;
}

void add_inputs(const std::filesystem::path& path, std::vector<CorpusInput>& inputs) {
    std::ifstream in(path, std::ios::binary);
    if (!in) give_up(path.string(), "cannot be read");
    if (path.extension() != ".corpus") {
        inputs.push_back({path.string(), {std::istreambuf_iterator<char>(in), {}}});
        return;
    }
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        const std::string where = path.string() + ":" + std::to_string(number);
        inputs.push_back({where, unquoted(line, where)});
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGABRT, name_input);
    std::vector<CorpusInput> inputs;
    for (int i = 1; i < argc; ++i) add_inputs(argv[i], inputs);
    // Under Valgrind and the like, some of them.
    const std::size_t step = is_small() && inputs.size() > 20 ? 25 : 1;
    std::size_t count = 0;
    for (std::size_t i = 0; i < inputs.size(); i += step, ++count) {
        current = inputs[i].where;
        // An array of the exact size, so that a sanitizer sees what is read past its end.
        const std::vector<std::uint8_t> bytes(inputs[i].bytes.begin(), inputs[i].bytes.end());
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    std::printf("%zu inputs\n", count);
    return count == 0 ? 1 : 0;
}
