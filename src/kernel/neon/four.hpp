// SPDX-License-Identifier: MIT
// Includes the vectors of four doubles that are written for NEON.
#pragma once

#include "kernel/neon/four_words.hpp"
#include "kernel/neon/transpose.hpp"
#include "kernel/neon/vector.hpp"
