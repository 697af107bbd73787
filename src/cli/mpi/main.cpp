// SPDX-License-Identifier: MIT
// The program mgdt-mpi: the Delaunay triangulation of a file of points on the ranks of MPI, each of
// which reads a share of the points and writes a piece of the mesh.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <new>
#include <numeric>
#include <optional>

#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/formats/pieces.hpp"
#include "cli/input_share.hpp"
#include "cli/interrupt.hpp"
#include "cli/mpi/ranks.hpp"
#include "cli/program_parts.hpp"
#include "mgdt/mgdt_mpi.h"

namespace mgdt::cli {
namespace {

struct Options {
    InputOptions input;
    std::string output;
    TriangulationOptions triangulation;
    int check_level = 0;
    bool compress = false;
};

// Parses the arguments. Returns nothing for --help and --version, whose text is printed if `speaks`
// is true, as on the first rank.
std::optional<Options> parse(int argc, char** argv, bool speaks) {
    Options o;
    CLI::App app(
        "Exact 3D Delaunay triangulation of a file of points, by the ranks of MPI together:\n"
        "mpiexec -n 4 mgdt-mpi points.npy -o mesh.pvtu",
        "mgdt-mpi");
    app.set_version_flag("--version", fmt::format("mgdt-mpi {} (ABI {})", mgdt_version_string(),
                                                  mgdt_abi_version()));
    app.add_option("input", o.input.path,
                   "Points: each rank reads its share of an .npy or .f64 file; of other formats, "
                   "and of standard input, the first rank reads all")
        ->required()
        ->type_name("FILE");
    app.add_option("--from", o.input.from, "Format of the input")->type_name("FORMAT");
    app.add_flag("--allow-empty", o.input.allow_empty,
                 "Take an input without any text or bytes as no points");
    app.add_option("-o,--output", o.output,
                   "FILE.pvtu, which names the pieces FILE_0.vtu and so on, one from each rank")
        ->type_name("FILE");
    app.add_option("--threads", o.triangulation.threads,
                   "Threads of each rank; 0 for all cores (default 1)")
        ->check(CLI::Range(0, 1 << 20))
        ->type_name("N");
    app.add_option("--memory-limit", o.triangulation.memory_limit,
                   "Most memory of the triangulation on each rank, such as 500MB or 4GB")
        ->transform(CLI::AsSizeValue(false))
        ->type_name("SIZE");
    app.add_option("--check", o.check_level,
                   "Prove the result before writing: 1 combinatorial, 2 geometric, 3 canonical")
        ->check(CLI::Range(1, 3))
        ->type_name("LEVEL");
    app.add_flag("--compress", o.compress, "Compress the pieces");
    app.add_flag("-q,--quiet", o.triangulation.quiet, "Print nothing but errors");
    app.footer("Formats and exit codes are those of mgdt: see mgdt triangulate --help");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() != 0)
            throw Error(exit_usage, fmt::format("{}; see mgdt-mpi --help", e.what()));
        if (speaks) app.exit(e);
        return std::nullopt;
    }
    if (!o.output.empty() && !is_pieces_path(o.output))
        throw Error(exit_usage, "mgdt-mpi writes pieces: say -o FILE.pvtu");
    if (o.compress) require_compressible({0, true}, vtu_format());
    if (o.output.empty() && o.check_level == 0)
        throw Error(exit_usage, "nothing to do; say where to write with -o, or ask for a --check");
    return o;
}

// Creates the part of this rank. The creation fails on all ranks or on none.
Parts make_part() {
    mgdt_parts* part = nullptr;
    const mgdt_status status = mgdt_mpi_create(MPI_COMM_WORLD, &part);
    if (status != MGDT_OK) throw failure_of(status, mgdt_status_string(status));
    return Parts(part);
}

void insert(Parts& parts, const Share& share) {
    std::vector<std::int64_t> places(share.points.size() / 3);
    std::iota(places.begin(), places.end(), share.first);
    try {
        parts.insert(share.points, places);
    } catch (...) {
        rethrow_failure("points", parts.last_error());
    }
}

void check(Parts& parts, const std::string& name, int level) {
    try {
        parts.check(static_cast<Check>(level));
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_CHECK_FAILED) rethrow_failure(name, parts.last_error());
        throw Error(exit_check_failed,
                    fmt::format("{}: check at level {} failed: {}; nothing was written", name,
                                level, e.what()));
    }
}

// Each rank its piece; none gets its name before all are complete.
void write(const Options& o, Ranks& ranks, const Parts& parts,
           const std::vector<std::string>& files) {
    OutputSet outputs;
    ranks.together([&] {
        write_part(parts, Parts::this_part, o.compress,
                   outputs.open(files[static_cast<std::size_t>(ranks.rank())]));
        if (ranks.is_first()) write_index_of_pieces(files, outputs.open(o.output));
    });
    // Each rank first completes its files under temporary names. If a rank fails to, or was
    // interrupted, no rank gives its files their final names.
    std::vector<std::string> left_over;
    ranks.together([&] {
        outputs.close();
        if (ranks.is_first()) left_over = pieces_left_over(o.output, files.size());
    });
    ranks.together([&] { outputs.commit(); });
    remove_pieces(left_over);
}

// The first rank looks at the file: a name may lead elsewhere on another, and a file may grow.
std::optional<RowLayout> layout_for_all(const InputOptions& input, Ranks& ranks) {
    struct {
        RowLayout layout;
        bool is_there;
    } found = {};
    ranks.together([&] {
        if (!ranks.is_first()) return;
        const std::optional<RowLayout> layout = shared_layout(input);
        found.is_there = layout.has_value();
        if (layout) found.layout = *layout;
    });
    MPI_Bcast(&found, static_cast<int>(sizeof found), MPI_BYTE, 0, MPI_COMM_WORLD);
    if (!found.is_there) return std::nullopt;
    return found.layout;
}

void triangulate(const Options& o, Ranks& ranks) {
    const int rank = ranks.rank();
    const bool speaks = ranks.is_first() && !o.triangulation.quiet;
    const std::string name = input_name(o.input.path);
    std::vector<std::string> files;
    Parts parts = make_part();
    set_options(parts, o.triangulation);
    const std::optional<RowLayout> layout = layout_for_all(o.input, ranks);
    ranks.together([&] {
        std::vector<std::string> written;  // by all ranks: one may have read the whole input
        if (!o.output.empty()) {
            files = piece_paths(o.output, ranks.count());
            written = files;
            written.push_back(o.output);
            check_writable(files[static_cast<std::size_t>(rank)]);
            check_writable(o.output);
        }
        const Share share = read_share(o.input, layout, rank, ranks.count());
        if (!o.triangulation.quiet) print_left_out(share.mid_side_nodes, name);
        require_apart(share.inputs, written);
        insert(parts, share);
    });

    const auto begin = std::chrono::steady_clock::now();
    ranks.together([&] { with_progress(parts, name, !speaks, [&] { parts.build(); }); });
    const auto end = std::chrono::steady_clock::now();
    if (o.check_level > 0) {
        ranks.together([&] { check(parts, name, o.check_level); });
        if (speaks) fmt::print("check at level {} passed\n", o.check_level);
    }
    if (!o.output.empty()) write(o, ranks, parts, files);
    if (!speaks) return;
    const auto counts = [&](PartsNumber key, const char* one, const char* many) {
        return counted(static_cast<std::size_t>(parts.number(key)), one, many);
    };
    fmt::print("{}, {}, {}, {:.2f} s{}{}\n",
               counts(PartsNumber::all_vertices, "vertex", "vertices"),
               counts(PartsNumber::all_tetrahedra, "tetrahedron", "tetrahedra"),
               counted(static_cast<std::size_t>(ranks.count()), "rank", "ranks"),
               std::chrono::duration<double>(end - begin).count(), o.output.empty() ? "" : ": ",
               printable(o.output));
}

int run(int argc, char** argv, Ranks& ranks) {
    try {
        std::optional<Options> options;
        ranks.together([&] { options = parse(argc, argv, ranks.is_first()); });
        if (options) triangulate(*options, ranks);
        ranks.together([] {
            if (std::fflush(stdout) != 0) throw Error(exit_output, "standard output: cannot write");
        });
        return exit_ok;
    } catch (const Ranks::Elsewhere& failure) {
        return failure.code;
    }
}

}  // namespace
}  // namespace mgdt::cli

int main(int argc, char** argv) {
    using namespace mgdt::cli;
    Ranks ranks(&argc, &argv);
    try {
        install_signal_handlers(true);
        return run(argc, argv, ranks);
    } catch (...) {
        const int code = report_exception(stderr);
        if (!ranks.is_over()) MPI_Abort(MPI_COMM_WORLD, code);
        return code;
    }
}
