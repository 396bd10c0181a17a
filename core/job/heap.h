// SPDX-License-Identifier: Apache-2.0
// The C library's memory, set up for a program that runs all day with threads that come and go.
#pragma once

namespace noctule {

/// First thing in main(). glibc gives every thread a heap of its own, up to eight for each core, and each
/// keeps what it once held: after an hour of opening and processing takes a hundred megabytes that nobody
/// uses. Two heaps serve as fast, since what computes allocates rarely. Elsewhere this does nothing.
void shareHeaps();

}  // namespace noctule
