// SPDX-License-Identifier: MIT
// The same as in the island avx2, since links are short.
#pragma once

#include "kernel/four/apex.hpp"
