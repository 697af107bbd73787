// SPDX-License-Identifier: MIT
// Arguments that several commands have. Each function declares some of them; their values are in
// `options` when the command runs.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

#include "cli/domain_program.hpp"
#include "cli/opening.hpp"
#include "cli/periodic_box.hpp"
#include "cli/program_triangulation.hpp"
#include "cli/region.hpp"

namespace mgdt::cli {

// The input of points, with its format and its columns.
void add_input(CLI::App& app, InputOptions& options, const char* description);
// The input of a surface.
void add_facets_input(CLI::App& app, InputOptions& options);
// The columns of an input; `whose` says of which text, in the help.
void add_columns(CLI::App& app, const char* option, InputOptions& options, const char* whose);
void add_output(CLI::App& app, OutputOptions& options, bool required);
void add_index_base(CLI::App& app, OutputOptions& options);
void add_compress(CLI::App& app, OutputOptions& options);
void add_limits(CLI::App& app, int& threads, std::uint64_t& memory_limit,
                const char* memory = "Most memory, such as 500MB or 4GB");
void add_triangulation(CLI::App& app, TriangulationOptions& options);
// --clean, --weld and --flat.
void add_cleaning(CLI::App& app, CleanOptions& options);
void add_periodic(CLI::App& app, PeriodicOptions& options);
void add_region(CLI::App& app, RegionOptions& options);
void add_scheme_parameters(CLI::App& app, TriangulationOptions& options);

// Like CLI::Range, but refuses nan.
CLI::Validator number_between(double low, double high);

}  // namespace mgdt::cli
