// SPDX-License-Identifier: MIT
// As in the island avx2: links are short.
#pragma once

#include "kernel/four/apex.hpp"
