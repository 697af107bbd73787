// SPDX-License-Identifier: MIT
// Gmsh reference manual, "MSH file format" and "Legacy formats".
#include "cli/formats/gmsh_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "cli/formats/format.hpp"
#include "cli/formats/text_rows.hpp"

namespace mgdt::cli {
namespace {

constexpr std::int32_t triangle_type = 2, tetrahedron_type = 4, surface = 2, volume = 3;

// An entity of the model, with the number of its place among those of its dimension, from 1.
struct Entity {
    std::int32_t dimension, tag, type;
    std::int32_t group;
    std::string name;                       // of the group, or none
    const std::vector<MeshIndex>& corners;  // of the elements of all entities of this dimension
    std::vector<std::size_t> elements;

    std::size_t size() const { return static_cast<std::size_t>(dimension) + 1; }
    const MeshIndex* element(std::size_t i) const { return &corners[size() * elements[i]]; }
};

// Surfaces, then volumes. A mesh without markers is one volume.
std::vector<Entity> entities_of(const Mesh& mesh) {
    std::vector<Entity> entities;
    const auto add = [&](std::int32_t dimension, std::int32_t type,
                         const std::vector<MeshIndex>& corners, std::vector<MarkerGroup> groups,
                         const char* what, const MarkerNames& names) {
        std::int32_t tag = 0, free = groups.empty() ? 1 : std::max(groups.back().marker, 0) + 1;
        for (MarkerGroup& g : groups) {
            const auto found = names.find(g.marker);
            std::string name = found != names.end() ? found->second : "";
            if (g.marker <= 0 && name.empty() && what != nullptr)
                name = fmt::format("{} {}", what, g.marker);
            entities.push_back({dimension, ++tag, type, g.marker > 0 ? g.marker : free++,
                                std::move(name), corners, std::move(g.members)});
        }
    };
    add(surface, triangle_type, mesh.faces.corners, groups_of(mesh.faces.markers), "facets",
        mesh.faces.names);
    if (mesh.regions.empty())
        add(volume, tetrahedron_type, mesh.tetrahedra,
            groups_of(std::vector<std::int32_t>(mesh.tetrahedron_count())), nullptr, {});
    else
        add(volume, tetrahedron_type, mesh.tetrahedra, groups_of(mesh.regions), "region", {});
    return entities;
}

void write_names(const std::vector<Entity>& entities, OutputFile& out) {
    const auto count = std::count_if(entities.begin(), entities.end(),
                                     [](const Entity& e) { return !e.name.empty(); });
    if (count == 0) return;
    out.write(fmt::format("$PhysicalNames\n{}\n", count));
    for (const Entity& e : entities)
        if (!e.name.empty()) out.write(fmt::format("{} {} \"{}\"\n", e.dimension, e.group, e.name));
    out.write("$EndPhysicalNames\n");
}

class BinaryWriter {
  public:
    BinaryWriter(const Mesh& mesh, OutputFile& out)
        : mesh_(mesh), out_(out), entities_(entities_of(mesh)) {}

    void run() {
        out_.write("$MeshFormat\n4.1 1 8\n");
        out_.write_value<std::int32_t>(1);
        out_.write("\n$EndMeshFormat\n");
        write_names(entities_, out_);
        if (!mesh_.regions.empty()) write_entities();
        write_nodes();
        write_elements();
    }

  private:
    void size(std::size_t value) { out_.write_value(static_cast<std::uint64_t>(value)); }
    void integer(std::int32_t value) { out_.write_value(value); }
    std::size_t count(std::int32_t dimension) const {
        return static_cast<std::size_t>(
            std::count_if(entities_.begin(), entities_.end(),
                          [&](const Entity& e) { return e.dimension == dimension; }));
    }

    // Each has its box and its physical group. The entities around it are left out.
    void write_entities() {
        out_.write("$Entities\n");
        for (const std::size_t n : {std::size_t{0}, std::size_t{0}, count(surface), count(volume)})
            size(n);
        for (const Entity& e : entities_) {
            integer(e.tag);
            double box[6];
            std::fill_n(box, 3, std::numeric_limits<double>::infinity());
            std::fill_n(box + 3, 3, -std::numeric_limits<double>::infinity());
            for (std::size_t i = 0; i < e.elements.size(); ++i)
                for (std::size_t k = 0; k < e.size(); ++k)
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double x =
                            mesh_.points[3 * static_cast<std::size_t>(e.element(i)[k]) + c];
                        box[c] = std::min(box[c], x);
                        box[3 + c] = std::max(box[3 + c], x);
                    }
            out_.write_values(box, 6);
            size(1);
            integer(e.group);
            size(0);
        }
        out_.write("\n$EndEntities\n");
    }

    void write_nodes() {
        const std::size_t points = mesh_.point_count();
        out_.write("$Nodes\n");
        for (const std::size_t n :
             {std::size_t{points > 0}, points, std::size_t{points > 0}, points})
            size(n);
        if (points > 0) {
            for (const std::int32_t n : {volume, 1, 0}) integer(n);
            size(points);
            for (std::size_t i = 1; i <= points; ++i) size(i);
            out_.write_values(mesh_.points.data(), mesh_.points.size());
        }
        out_.write("\n$EndNodes\n");
    }

    void write_elements() {
        const std::size_t elements = mesh_.faces.size() + mesh_.tetrahedron_count();
        out_.write("$Elements\n");
        for (const std::size_t n :
             {entities_.size(), elements, std::size_t{elements > 0}, elements})
            size(n);
        std::size_t number = 0;
        for (const Entity& e : entities_) {
            for (const std::int32_t n : {e.dimension, e.tag, e.type}) integer(n);
            size(e.elements.size());
            for (std::size_t i = 0; i < e.elements.size(); ++i) {
                size(++number);
                for (std::size_t k = 0; k < e.size(); ++k)
                    size(static_cast<std::size_t>(e.element(i)[k]) + 1);
            }
        }
        out_.write("\n$EndElements\n");
    }

    const Mesh& mesh_;
    OutputFile& out_;
    const std::vector<Entity> entities_;
};

}  // namespace

void write_gmsh_4(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                  const WriteOptions&) {
    BinaryWriter(mesh, outputs.open(path)).run();
}

void write_gmsh_2(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                  const WriteOptions&) {
    OutputFile& out = outputs.open(path);
    out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    const std::vector<Entity> entities = entities_of(mesh);
    write_names(entities, out);
    out.write(fmt::format("$Nodes\n{}\n", mesh.point_count()));
    write_points(mesh.points, {1, " "}, out);
    out.write(
        fmt::format("$EndNodes\n$Elements\n{}\n", mesh.faces.size() + mesh.tetrahedron_count()));
    std::size_t number = 0;
    for (const Entity& e : entities) {
        const std::string tags = fmt::format(" {} 2 {} {}", e.type, e.group, e.tag);
        for (std::size_t i = 0; i < e.elements.size(); ++i) {
            out.write_integer(static_cast<std::int64_t>(++number));
            out.write(tags);
            for (std::size_t k = 0; k < e.size(); ++k) {
                out.write(" ");
                out.write_integer(std::int64_t{e.element(i)[k]} + 1);
            }
            out.write("\n");
        }
    }
    out.write("$EndElements\n");
}

}  // namespace mgdt::cli
