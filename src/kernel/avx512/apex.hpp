// SPDX-License-Identifier: MIT
// This island tests four vertices at a time, like avx2, since links are short: see kernel/apex.hpp.
#pragma once

#include "kernel/four/apex.hpp"
