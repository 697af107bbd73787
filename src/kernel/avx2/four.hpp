// SPDX-License-Identifier: MIT
// Includes the vectors of four doubles that are written for AVX2.
#pragma once

#include "kernel/avx2/four_words.hpp"
#include "kernel/avx2/transpose.hpp"
#include "kernel/avx2/vector.hpp"
