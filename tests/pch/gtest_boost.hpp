// SPDX-License-Identifier: MIT
// Precompiled for executables of several files with tests that compare with exact numbers.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
