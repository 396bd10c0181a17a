// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/exercise_figures.h"

#include <cmath>

#include "core/guide/movement_guide.h"

namespace noctule::ui {
namespace {

constexpr int kFrames = 8;
constexpr double kFrames_per_s = 2;
constexpr double kLasts_s = MovementGuide::kMove_s, kFirst_s = 1.2,
                 kStep_s = 0.7;  // of the exercise, in its middle

}  // namespace

int ExerciseFigures::frameAt(Exercise exercise, double t_s) {
    return static_cast<int>(exercise) * kFrames + static_cast<int>(std::floor(t_s * kFrames_per_s)) % kFrames;
}

std::shared_ptr<const BodyFigure> ExerciseFigures::figure(int frame, const Actor& actor,
                                                          const std::shared_ptr<const SkinnedMesh>& mesh) {
    if (const std::string body = toJson(actor).dump(); body != body_) {
        figures_.clear();
        body_ = body;
    }
    auto& figure = figures_[frame];
    if (!figure)
        figure = std::make_shared<const BodyFigure>(
            actor, mesh,
            exercisePose(actor, static_cast<Exercise>(frame / kFrames),
                         kFirst_s + kStep_s * (frame % kFrames), kLasts_s));
    return figure;
}

}  // namespace noctule::ui
