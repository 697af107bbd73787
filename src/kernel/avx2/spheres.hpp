// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/four/spheres.hpp"
