// SPDX-License-Identifier: MIT
// The program mgdt: exact 3D Delaunay triangulation from the command line.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <mgdt/mgdt.hpp>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

// In the order of the help.
const Command* const commands[] = {
    &triangulate_command, &generate_command, &check_command,   &info_command,  &interpolate_command,
    &voronoi_command,     &surface_command,  &hull_command,    &relax_command, &mesh_command,
    &refine_command,      &improve_command,  &validate_command};

// CLI11 would only report that a command is missing.
void require_command(const std::string& name) {
    std::vector<std::string> names;
    for (const Command* command : commands) {
        if (command->name == name) return;
        names.emplace_back(command->name);
    }
    if (name == "bench")
        throw Error(exit_usage, "there is no command bench; it is the program mgdt-bench");
    throw Error(exit_usage, fmt::format("unknown command {}; it is one of {}; see mgdt --help",
                                        quote(name), fmt::join(names, ", ")));
}

int run(const std::vector<std::string>& words) {
    CLI::App app("Exact 3D Delaunay triangulation of any set of points.", "mgdt");
    app.set_version_flag(
        "--version", fmt::format("mgdt {} (ABI {})", mgdt_version_string(), mgdt_abi_version()));
    app.require_subcommand(1);
    app.allow_windows_style_options(false);  // /name is a file
    app.footer([] {
        return formats_and_exit_codes() +
               "\n\nExample:\n  mgdt generate galaxy 1e5 -o points.npy\n"
               "  mgdt triangulate points.npy -o mesh.vtu --stats\n  mgdt check mesh.vtu";
    });
    app.get_formatter()->column_width(28);
    if (words.size() > 1 && words[1].substr(0, 1) != "-") require_command(words[1]);
    const auto named = std::find_if(words.begin() + (words.empty() ? 0 : 1), words.end(),
                                    [](const std::string& w) { return w.substr(0, 1) != "-"; });
    std::function<int()> chosen;
    for (const Command* command : commands) {
        CLI::App* const own = app.add_subcommand(command->name, command->description);
        // To declare the options of all commands would take longer than to mesh a cube.
        if (named != words.end() && *named == command->name)
            own->callback([&chosen, runs = command->declare(*own)] { chosen = runs; });
    }
    try {
        // CLI11 takes arguments in reverse order.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend() - (words.empty() ? 0 : 1)));
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
        const CLI::App* at = &app;
        while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
        const std::string command = at == &app ? "mgdt" : "mgdt " + at->get_name();
        throw Error(exit_usage, fmt::format("{}; see {} --help", e.what(), command));
    }
    return chosen();
}

}  // namespace
}  // namespace mgdt::cli

int main(int argc, char** argv) {
    using namespace mgdt::cli;
    try {
        install_signal_handlers();
        const int code = run(system::arguments(argc, argv));
        // Reports what could not be written to standard output.
        if (std::fflush(stdout) != 0) throw Error(exit_output, "standard output: cannot write");
        return code;
    } catch (...) {
        return report_exception(stderr);
    }
}
