// SPDX-License-Identifier: MIT
// mgdt triangulate --parts: tetrahedra of more points than memory has room for, a file to a part.
#include <fmt/core.h>

#include <chrono>
#include <exception>
#include <new>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/formats/pieces.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_parts.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

// Parts in one process, triangulated one after another.
class PartsInTurn {
  public:
    PartsInTurn(int count, const TriangulationOptions& options)
        : parts_(create(count), options), count_(count) {}

    // In equal runs, so that ids are places in the file.
    void insert(const std::vector<double>& points, const std::string& name) {
        const auto n = static_cast<std::int64_t>(points.size() / 3);
        for (std::int32_t p = 0; p < count_; ++p) {
            const std::int64_t first = n / count_ * p + n % count_ * p / count_,
                               last = n / count_ * (p + 1) + n % count_ * (p + 1) / count_;
            check_interrupt();
            parts_.require(mgdt_parts_insert_points(parts_.get(), p, last - first,
                                                    points.data() + 3 * first, nullptr),
                           name);
        }
    }
    // Writes a file for each part.
    void build(const std::vector<std::string>& files, OutputSet& outputs, bool compress,
               const std::string& name, bool quiet) {
        Progress progress("triangulating", quiet);
        mgdt_parts_set_progress(parts_.get(), Progress::callback, &progress);
        Looks looks{files, outputs, compress, nullptr};
        const mgdt_status status = mgdt_parts_build_each(parts_.get(), look, &looks);
        mgdt_parts_set_progress(parts_.get(), nullptr, nullptr);
        if (looks.failure) std::rethrow_exception(looks.failure);
        parts_.require(status, name);
    }
    std::int64_t number(std::int32_t key) const { return parts_.number(0, key); }

  private:
    struct Looks {
        const std::vector<std::string>& files;
        OutputSet& outputs;
        bool compress;
        std::exception_ptr failure;
    };

    static std::int32_t look(const mgdt_parts* p, std::int32_t part, void* user) {
        Looks& looks = *static_cast<Looks*>(user);
        try {
            // Closed there: many files are not open at once.
            write_part(p, part, looks.compress,
                       looks.outputs.open(looks.files[static_cast<std::size_t>(part)]));
            return 0;
        } catch (...) {
            looks.failure = std::current_exception();
            return 1;
        }
    }
    static mgdt_parts* create(std::int32_t count) {
        mgdt_parts* parts = nullptr;
        if (mgdt_parts_create(count, &parts) != MGDT_OK) throw std::bad_alloc();
        return parts;
    }

    ProgramParts parts_;
    std::int32_t count_;
};

}  // namespace

int triangulate_in_parts(const TriangulateOptions& options) {
    const OutputOptions& output = options.output;
    if (!options.neighbors.empty() || !options.point_map.empty() || options.all_points ||
        options.check_level > 0 || options.statistics)
        throw Error(exit_usage,
                    "--parts goes with none of --neighbors, --point-map, --all-points, --check and "
                    "--stats");
    if (!is_pieces_path(output.path) || !output.to.empty())
        throw Error(exit_usage, "--parts writes pieces: say -o FILE.pvtu");
    require_compressible(output.write, vtu_format());
    const std::vector<std::string> files = piece_paths(output.path, options.parts);
    for (const std::string& file : files) check_writable(file);
    check_writable(output.path);

    const std::string name = input_name(options.input.path);
    OutputSet outputs;
    std::int64_t vertices = 0, tetrahedra = 0;
    const auto begin = std::chrono::steady_clock::now();
    {
        PartsInTurn parts(options.parts, options.triangulation);
        {
            // Gone before it is triangulated.
            const Mesh mesh = read_input(options.input);
            if (!options.triangulation.quiet)
                print_left_out(mesh.mid_side_nodes, input_name(options.input.path));
            std::vector<std::string> written = files;
            written.push_back(output.path);
            require_apart(mesh.inputs, written);
            parts.insert(mesh.points, name);
        }
        parts.build(files, outputs, output.write.compress, name, options.triangulation.quiet);
        vertices = parts.number(MGDT_PARTS_ALL_VERTICES);
        tetrahedra = parts.number(MGDT_PARTS_ALL_TETRAHEDRA);
    }
    write_index_of_pieces(files, outputs.open(output.path));
    const std::vector<std::string> left_over = pieces_left_over(output.path, files.size());
    outputs.commit();
    remove_pieces(left_over);
    if (!options.triangulation.quiet)
        fmt::print("{}, {}, {}, {:.2f} s: {}\n",
                   counted(static_cast<std::size_t>(vertices), "vertex", "vertices"),
                   counted(static_cast<std::size_t>(tetrahedra), "tetrahedron", "tetrahedra"),
                   counted(files.size(), "part", "parts"),
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                   printable(output.path));
    return exit_ok;
}

}  // namespace mgdt::cli
