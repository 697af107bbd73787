// SPDX-License-Identifier: MIT
// mgdt triangulate --parts: tetrahedra of more points than memory has room for, a file to a part.
#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <new>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/formats/pieces.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "mgdt/mgdt_parts.h"

namespace mgdt::cli {
namespace {

// Parts as the program uses them, one after another.
class Parts {
  public:
    explicit Parts(int count, const TriangulationOptions& options) : count_(count) {
        if (mgdt_parts_create(count, &handle_) != MGDT_OK) throw std::bad_alloc();
        const auto set = [this](std::int32_t option, std::int64_t value) {
            mgdt_parts_set_option(handle_, option, value);
        };
        set(MGDT_PARTS_THREADS, options.threads);
        set(MGDT_PARTS_MEMORY_LIMIT, static_cast<std::int64_t>(options.memory_limit));
    }
    ~Parts() { mgdt_parts_destroy(handle_); }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    // In equal runs, so that ids are places in the file.
    void insert(const std::vector<double>& points, const std::string& name) {
        const auto n = static_cast<std::int64_t>(points.size() / 3);
        for (std::int32_t p = 0; p < count_; ++p) {
            const std::int64_t first = n / count_ * p + n % count_ * p / count_,
                               last = n / count_ * (p + 1) + n % count_ * (p + 1) / count_;
            check_interrupt();
            require(mgdt_parts_insert_points(handle_, p, last - first, points.data() + 3 * first,
                                             nullptr),
                    name);
        }
    }
    // Writes a file for each part.
    void build(const std::vector<std::string>& files, OutputSet& outputs, const std::string& name,
               bool quiet) {
        Progress progress("triangulating", quiet);
        mgdt_parts_set_progress(handle_, Progress::callback, &progress);
        Looks looks{files, outputs, nullptr};
        const mgdt_status status = mgdt_parts_build_each(handle_, look, &looks);
        mgdt_parts_set_progress(handle_, nullptr, nullptr);
        if (looks.failure) std::rethrow_exception(looks.failure);
        require(status, name);
    }
    std::int64_t number(std::int32_t key) const { return number(handle_, 0, key); }

  private:
    struct Looks {
        const std::vector<std::string>& files;
        OutputSet& outputs;
        std::exception_ptr failure;
    };

    static std::int64_t number(const mgdt_parts* p, std::int32_t part, std::int32_t key) {
        std::int64_t value = 0;
        mgdt_parts_get_stat(p, part, key, &value);
        return value;
    }
    static std::int32_t look(const mgdt_parts* p, std::int32_t part, void* user) {
        Looks& looks = *static_cast<Looks*>(user);
        try {
            write(p, part, looks.outputs.open(looks.files[static_cast<std::size_t>(part)]));
            return 0;
        } catch (...) {
            looks.failure = std::current_exception();
            return 1;
        }
    }
    static void write(const mgdt_parts* p, std::int32_t part, OutputFile& out) {
        Piece piece;
        const auto get = [&](std::int32_t array, std::vector<std::int64_t>& values) {
            std::int64_t size = 0;
            mgdt_parts_get_size(p, part, array, &size);
            values.resize(static_cast<std::size_t>(size));
            if (mgdt_parts_get_array(p, part, array, size, values.data()) != MGDT_OK)
                throw std::bad_alloc();
        };
        get(MGDT_PARTS_LOCAL_CORNERS, piece.corners);
        piece.corners.resize(4 *
                             static_cast<std::size_t>(number(p, part, MGDT_PARTS_OWN_TETRAHEDRA)));
        get(MGDT_PARTS_VERTEX_IDS, piece.ids);
        piece.points.resize(3 * piece.ids.size());
        mgdt_parts_get_coordinates(p, part, static_cast<std::int64_t>(piece.points.size()),
                                   piece.points.data());
        check_interrupt();
        write_piece(piece, out);
        // Many files are not open at once.
        out.close();
    }
    void require(mgdt_status status, const std::string& doing) const {
        if (status == MGDT_OK) return;
        char text[256] = "";
        mgdt_parts_get_error(handle_, sizeof text, text);
        throw_status(status, fmt::format("{}: {}", doing,
                                         text[0] != '\0' ? text : mgdt_status_string(status)));
    }

    mgdt_parts* handle_ = nullptr;
    std::int32_t count_;
};

}  // namespace

int triangulate_in_parts(const TriangulateOptions& options) {
    const OutputOptions& output = options.output;
    if (!options.neighbors.empty() || options.check_level > 0 || options.statistics)
        throw Error(exit_usage, "--parts goes with none of --neighbors, --check and --stats");
    if (!is_pieces_path(output.path) || !output.to.empty())
        throw Error(exit_usage, "--parts writes pieces: say -o FILE.pvtu");
    const std::vector<std::string> files = piece_paths(output.path, options.parts);
    for (const std::string& file : files) check_writable(file);
    check_writable(output.path);

    const std::string name = input_name(options.input.path);
    OutputSet outputs;
    std::int64_t vertices = 0, tetrahedra = 0;
    const auto begin = std::chrono::steady_clock::now();
    {
        Parts parts(options.parts, options.triangulation);
        {
            // Gone before it is triangulated.
            const Mesh mesh = read_input(options.input);
            std::vector<std::string> written = files;
            written.push_back(output.path);
            require_apart(mesh.inputs, written);
            parts.insert(mesh.points, name);
        }
        parts.build(files, outputs, name, options.triangulation.quiet);
        vertices = parts.number(MGDT_PARTS_ALL_VERTICES);
        tetrahedra = parts.number(MGDT_PARTS_ALL_TETRAHEDRA);
    }
    write_index_of_pieces(files, outputs.open(output.path));
    outputs.commit();
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
