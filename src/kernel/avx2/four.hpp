// SPDX-License-Identifier: MIT
// What AVX2 has for vectors of four doubles.
#pragma once

#include "kernel/avx2/four_words.hpp"
#include "kernel/avx2/transpose.hpp"
#include "kernel/avx2/vector.hpp"
