// SPDX-License-Identifier: Apache-2.0
// The operator's keys of a program without a screen: lines on standard input. The dead man's key is held from
// "engage" to "release"; the end of the input lets it go.
#pragma once

#include <string>
#include <utility>

#include "core/robot/teleoperation.h"

namespace noctule::batch {

class OperatorKeys {
public:
    /// `holds`: the key is held from the beginning, and postures are accepted as soon as they are near.
    explicit OperatorKeys(bool holds, int descriptor = 0) : holds_(holds), descriptor_(descriptor) {}

    /// What is held now, and what was pressed since the last call. Never waits.
    robot::TeleopKeys next();
    /// A line that is no command, until it was taken.
    std::string takeComplaint() { return std::exchange(complaint_, {}); }
    /// One line, without its end.
    void obey(const std::string& line);

private:
    void read();

    bool holds_;
    int descriptor_;
    bool is_open_ = true;
    bool accepts_always_ = false;
    robot::TeleopKeys pressed_;  ///< since the last call
    std::string unfinished_, complaint_;
    bool has_begun_ = false;
};

}  // namespace noctule::batch
