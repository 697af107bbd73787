// SPDX-License-Identifier: MIT
// Each status of the library has an exit code of the program.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "cli/errors.hpp"

namespace {

using namespace mgdt::cli;

TEST(ExitCodes, EveryStatusHasOne) {
    std::ifstream header(MGDT_TEST_HEADER);
    const std::regex enumerator(R"( (MGDT_ERR_[A-Z_]+) = ([0-9]+))");
    std::set<int> statuses;
    for (std::string line; std::getline(header, line);)
        for (std::smatch match; std::regex_search(line, match, enumerator); line = match.suffix()) {
            const int status = std::stoi(match[2]);
            EXPECT_NE(find_failure(status), nullptr) << match[1];
            statuses.insert(status);
        }
    EXPECT_GT(statuses.size(), 12u);
    for (int status = -1; status < 1000; ++status) {
        if (statuses.count(status) == 0) {
            EXPECT_EQ(find_failure(status), nullptr) << status;
        }
    }
}

// What a user has given is no defect of the program.
TEST(ExitCodes, OfInputs) {
    for (const int status :
         {MGDT_ERR_NOT_FINITE, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_INVALID_BOUNDARY,
          MGDT_ERR_RESOLUTION, MGDT_ERR_OPEN_BOUNDARY})
        EXPECT_EQ(failure_of(status, "a file").code(), exit_input);
    EXPECT_EQ(failure_of(MGDT_ERR_CHECK_FAILED, "a file").code(), exit_check_failed);
    EXPECT_EQ(failure_of(MGDT_ERR_BUSY, "a file").code(), exit_internal);
    EXPECT_EQ(failure_of(12345, "a file").code(), exit_internal);
}

}  // namespace
