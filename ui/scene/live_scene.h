// SPDX-License-Identifier: Apache-2.0
// The scene of a suit that is worn right now: its body in the newest pose and a ray for every pair that heard
// each other just before.
#pragma once

#include <memory>
#include <optional>

#include "core/body/actor.h"
#include "core/body/floor_move.h"
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

/// Another performer beside the one that is shown.
struct LiveCompanion {
    LiveWearer wearer;
    std::shared_ptr<const LiveFrame> frame;
    int performer = 0;     ///< 0 for A
    bool is_lost = false;  ///< the frame is the last one before its link broke
    FloorMove floor{};     ///< of its body, before it is put into the row
};

class LiveScene {
public:
    /// Several performers stand in a row, since nothing tells live where they are to each other.
    static constexpr double kApart_m = 1.2;

    /// Whose body this is among the others; none: nobody else is there.
    void setCompany(int performer, std::vector<LiveCompanion> others);
    bool isInCompany() const { return !others_.empty(); }
    void setWearer(LiveWearer wearer) { wearer_ = std::move(wearer); }
    const LiveWearer& wearer() const { return wearer_; }
    /// Lost: the frame is the last one before the link broke. Its body is faded and hears nothing.
    /// `floor`: of its body, before it is put into the row.
    void setFrame(std::shared_ptr<const LiveFrame> frame, bool is_lost, const FloorMove& floor = {}) {
        frame_ = std::move(frame);
        is_lost_ = is_lost;
        floor_ = floor;
    }
    const std::shared_ptr<const LiveFrame>& frame() const { return frame_; }
    const FloorMove& floor() const { return floor_; }

    ComposedScene compose(ReviewContext& review, const SceneLayers& layers);

private:
    void addPairs(ComposedScene& composed) const;
    void addOther(ComposedScene& composed, const LiveCompanion& other, size_t index, ReviewContext& review,
                  const SceneLayers& layers, const SceneColors& in_view);

    LiveWearer wearer_;
    std::shared_ptr<const LiveFrame> frame_;
    bool is_lost_ = false;
    FloorMove floor_;
    FittedBody body_;
    int performer_ = 0;
    std::vector<LiveCompanion> others_;
    std::vector<FittedBody> bodies_;  ///< of the others
};

}  // namespace noctule::ui
