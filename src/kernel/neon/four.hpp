// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/neon/four_words.hpp"
#include "kernel/neon/transpose.hpp"
#include "kernel/neon/vector.hpp"
