// SPDX-License-Identifier: MIT
// Includes the vectors of four doubles of AVX2, which AVX-512 uses too.
#pragma once

#include "kernel/avx2/four.hpp"
