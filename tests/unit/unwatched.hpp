// SPDX-License-Identifier: MIT
// The progress of a call that nobody watches and nobody stops.
#pragma once

#include "platform/stage_progress.hpp"

struct Unwatched {
    mgdt::StopFlag stop;
    mgdt::StageProgress progress{mgdt::CallSettings(), stop};

    operator mgdt::StageProgress&() { return progress; }  // NOLINT: meant to convert
};
