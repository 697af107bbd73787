// SPDX-License-Identifier: MIT
// What NEON has for vectors of four doubles.
#pragma once

#include "kernel/neon/four_words.hpp"
#include "kernel/neon/transpose.hpp"
#include "kernel/neon/vector.hpp"
