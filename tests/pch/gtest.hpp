// SPDX-License-Identifier: MIT
// Precompiled for executables of several files with tests.
#include <gtest/gtest.h>
