// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and a polite kill end a program tidily: they raise a flag. A reader that goes away becomes an error
// of writing.
#pragma once

#include "core/job/job.h"

namespace noctule::batch {

/// The flag of this process; to be called once, before threads are started.
const CancelFlag& cancelOnSignals();
/// The same flag, for what waits outside of a job: an input that is a pipe.
const CancelFlag& signalFlag();

}  // namespace noctule::batch
