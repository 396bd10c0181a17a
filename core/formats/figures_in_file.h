// SPDX-License-Identifier: Apache-2.0
// Which figures may share a scene file: the motions of one body, or several characters that move at one time.
#pragma once

#include <set>
#include <string>

#include "core/formats/figure.h"

namespace noctule {

class FiguresInFile {
public:
    /// `where` names the file in errors.
    explicit FiguresInFile(std::string where) : where_(std::move(where)) {}

    /// One after the other. kUnusable, and names it, when its frame rate is not that of the first, or when
    /// two have one name. So is a motion of the same body that has other joints, or the same ones elsewhere.
    Status add(const Figure& figure);
    /// Without its frames.
    const MotionClip& first() const { return first_; }

private:
    std::string where_;
    MotionClip first_;
    std::set<std::string> names_;
};

}  // namespace noctule
