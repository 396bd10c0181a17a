// SPDX-License-Identifier: Apache-2.0
// Text files of others, whole: UTF-8 with or without a byte order mark, or UTF-16 as spreadsheets write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/job/job.h"

namespace noctule {

/// Motions and tables beyond this are refused. An hour of BVH at 120 frames a second takes 0.3 GB.
constexpr size_t kMostTextBytes = size_t{1} << 30;
/// The same of pipes and devices, which need not end.
constexpr size_t kMostStreamBytes = size_t{256} << 20;

/// The file as UTF-8 without a byte order mark. `cancel` ends the wait for a pipe.
Result<std::string> readTextFile(const std::string& path, const CancelFlag* cancel = nullptr);

/// UTF-16 as UTF-8: with a byte order mark, or where every second of the first bytes is zero. Nothing when it
/// is no UTF-16. What is no character becomes U+FFFD.
std::optional<std::string> fromUtf16(std::string_view bytes);

/// Without the mark that some programs put before UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

}  // namespace noctule
