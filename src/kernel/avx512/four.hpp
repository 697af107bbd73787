// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/avx2/four.hpp"
