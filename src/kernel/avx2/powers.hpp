// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/four/powers.hpp"
