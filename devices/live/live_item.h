// SPDX-License-Identifier: Apache-2.0
// One thing that a device told, as those who record and those who process take it: in the terms of take files
// (core/recording/README.md, section 2), sound shared and never copied.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "core/acoustics/range.h"
#include "core/recording/robot_rows.h"
#include "core/recording/rows.h"
#include "devices/driver_box/messages.h"

namespace noctule {

struct ArrivedBlock {
    std::shared_ptr<const link::SoundBlock> sound;  ///< on the device's clock
    int64_t arrived_ns = 0;                         ///< of its last byte, std::chrono::steady_clock
    int64_t origin = 0;                             ///< the device's sample that is 0 here

    int64_t firstSample() const { return sound->first_sample - origin; }
    int64_t sampleCount() const { return sound->sampleCount(); }
    int64_t endSample() const { return firstSample() + sampleCount(); }
};

/// Pulses carry the ids that the take's table will give them; robot rows belong to the drive that began last.
using LiveItem = std::variant<ArrivedBlock, std::vector<Pulse>, GapRow, StatusRow, MarkerRow, NoteRow,
                              RobotDriveRow, RobotRows>;

/// Reasons of gap rows.
inline constexpr const char *kGapOfLink = "link", *kGapOfBox = "box", *kGapOfStudio = "studio",
                            *kGapOfBoard = "board";

}  // namespace noctule
