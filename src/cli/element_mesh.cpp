// SPDX-License-Identifier: MIT
#include "cli/element_mesh.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mgdt::cli {
namespace {

class Reader {
  public:
    explicit Reader(const std::string& path) : path_(path) {
        std::ifstream file(path, std::ios::binary);
        if (!file) {
            throw std::runtime_error(path + ": " + std::strerror(errno) +
                                     "; the machine and church points are made from the meshes in "
                                     "mgdt's data directory");
        }
        bytes_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        if (file.bad()) throw std::runtime_error(path + ": cannot be read");
    }

    void expect(const std::string& text) {
        if (bytes_.compare(position_, text.size(), text) != 0) fail();
        position_ += text.size();
    }

    // A number in text that ends its line; `size` is the least that one of its items takes, so
    // that a damaged count is found before memory is asked for.
    std::size_t count(std::size_t size) {
        std::size_t n = 0;
        for (;; ++position_) {
            if (position_ == bytes_.size()) fail();
            const char c = bytes_[position_];
            if (c == '\n') break;
            if (c < '0' || c > '9') fail();
            n = 10 * n + static_cast<std::size_t>(c - '0');
            if (n > bytes_.size() / size) fail();
        }
        ++position_;
        return n;
    }

    template <class T>
    T value() {
        T result;
        if (bytes_.size() - position_ < sizeof result) fail();
        std::memcpy(&result, bytes_.data() + position_, sizeof result);
        position_ += sizeof result;
        return result;
    }

    [[noreturn]] void fail() const {
        throw std::runtime_error(path_ + ": byte " + std::to_string(position_) +
                                 ": not a binary MSH 2.2 mesh of tetrahedra");
    }

  private:
    std::string path_;
    std::string bytes_;
    std::size_t position_ = 0;
};

}  // namespace

ElementMesh read_element_mesh(const std::string& path) {
    constexpr std::int32_t tetrahedron = 4;  // Gmsh's element type
    Reader reader(path);
    ElementMesh mesh;

    reader.expect("$MeshFormat\n2.2 1 8\n");
    if (reader.value<std::int32_t>() != 1) reader.fail();  // written in another byte order
    reader.expect("\n$EndMeshFormat\n$Nodes\n");
    mesh.nodes.resize(reader.count(sizeof(std::int32_t) + sizeof(Point)));
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        if (reader.value<std::int32_t>() != static_cast<std::int32_t>(i + 1)) reader.fail();
        mesh.nodes[i] = reader.value<Point>();
    }

    reader.expect("\n$EndNodes\n$Elements\n");
    mesh.tetrahedra.resize(reader.count(5 * sizeof(std::int32_t)));
    if (reader.value<std::int32_t>() != tetrahedron) reader.fail();
    if (reader.value<std::int32_t>() != static_cast<std::int32_t>(mesh.tetrahedra.size())) {
        reader.fail();
    }
    const auto tags = reader.value<std::int32_t>();
    for (auto& vertices : mesh.tetrahedra) {
        reader.value<std::int32_t>();  // its number
        for (std::int32_t i = 0; i < tags; ++i) reader.value<std::int32_t>();
        for (std::uint32_t& v : vertices) {
            v = reader.value<std::uint32_t>() - 1;  // 0 becomes too large
            if (v >= mesh.nodes.size()) reader.fail();
        }
    }
    reader.expect("\n$EndElements\n");
    return mesh;
}

}  // namespace mgdt::cli
