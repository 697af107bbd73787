// SPDX-License-Identifier: MIT
// What AVX2 has for vectors of four doubles serves AVX-512, too.
#pragma once

#include "kernel/avx2/four.hpp"
