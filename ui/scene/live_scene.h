// SPDX-License-Identifier: Apache-2.0
// The scene of a suit that is worn right now: its body in the newest pose and a ray for every pair that heard
// each other just before.
#pragma once

#include <memory>
#include <optional>

#include "core/body/actor.h"
#include "core/suit/calibration.h"
#include "devices/live/live_processor.h"
#include "ui/scene/take_scene.h"

namespace noctule::ui {

/// Who wears what; without a calibration poses are not to be trusted, and none is shown.
struct LiveWearer {
    Actor actor;
    Suit suit;
    std::optional<Calibration> calibration;
    int sample_rate_hz = 150000;
};

class LiveScene {
public:
    void setWearer(LiveWearer wearer) { wearer_ = std::move(wearer); }
    const LiveWearer& wearer() const { return wearer_; }
    void setFrame(std::shared_ptr<const LiveFrame> frame) { frame_ = std::move(frame); }
    const std::shared_ptr<const LiveFrame>& frame() const { return frame_; }

    ComposedScene compose(Studio& studio, const SceneLayers& layers);

private:
    void addPairs(ComposedScene& composed) const;

    LiveWearer wearer_;
    std::shared_ptr<const LiveFrame> frame_;
    FittedBody body_;
};

}  // namespace noctule::ui
