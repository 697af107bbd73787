// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/avx2/four_words.hpp"
#include "kernel/avx2/transpose.hpp"
#include "kernel/avx2/vector.hpp"
