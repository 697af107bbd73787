// SPDX-License-Identifier: MIT
// The main function of an executable that has the tests of several files. With --file=NAME it runs
// the tests of the file NAME alone; a filter of GoogleTest takes precedence.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <string>

namespace {

// The names of the tests in a file, as a filter of GoogleTest.
std::string filter_of(const std::string& file) {
    std::string filter;
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int k = 0; k < suite.total_test_count(); ++k) {
            const testing::TestInfo& test = *suite.GetTestInfo(k);
            const std::string path = test.file();
            const std::size_t folder = path.find_last_of("/\\");
            if (path.substr(folder == std::string::npos ? 0 : folder + 1) == file)
                filter += std::string(filter.empty() ? "" : ":") + suite.name() + "." + test.name();
        }
    }
    return filter;
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (std::strncmp(argv[i], "--file=", 7) != 0) {
            std::fprintf(stderr, "usage: %s [--file=NAME] [options of GoogleTest]\n", argv[0]);
            return 2;
        }
        if (GTEST_FLAG_GET(filter) != "*") continue;
        const std::string filter = filter_of(argv[i] + 7);
        if (filter.empty()) {
            std::fprintf(stderr, "%s: no tests in %s\n", argv[0], argv[i] + 7);
            return 2;
        }
        GTEST_FLAG_SET(filter, filter);
    }
    return RUN_ALL_TESTS();
}
