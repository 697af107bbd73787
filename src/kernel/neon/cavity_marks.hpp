// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/four/cavity_marks.hpp"
