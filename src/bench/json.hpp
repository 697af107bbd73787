// SPDX-License-Identifier: MIT
// The measurement as a JSON object, with the machine it is of.
#pragma once

#include <string>
#include <vector>

#include "bench/row.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli::bench {

void write_json(OutputFile& out, const std::string& command, const std::vector<Row>& rows);

}  // namespace mgdt::cli::bench
