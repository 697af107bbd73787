// SPDX-License-Identifier: MIT
// Writes the measurements as a JSON object that describes the machine too.
#pragma once

#include <string>
#include <vector>

#include "bench/row.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli::bench {

void write_json(OutputFile& out, const std::string& command, const std::vector<Row>& rows);

}  // namespace mgdt::cli::bench
