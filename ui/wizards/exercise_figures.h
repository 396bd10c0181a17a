// SPDX-License-Identifier: Apache-2.0
// The performer doing an exercise, as flat figures to be shown one after the other.
#pragma once

#include <map>

#include "core/guide/exercises.h"
#include "ui/views/body_figure.h"

namespace noctule::ui {

class ExerciseFigures {
public:
    /// A number for figure(): changes twice a second.
    static int frameAt(Exercise exercise, double t_s);
    /// Made when it is first shown; of one body, until another is asked for.
    std::shared_ptr<const BodyFigure> figure(int frame, const Actor& actor,
                                             const std::shared_ptr<const SkinnedMesh>& mesh);

private:
    std::map<int, std::shared_ptr<const BodyFigure>> figures_;
    std::string body_;
};

}  // namespace noctule::ui
