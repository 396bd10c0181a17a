// SPDX-License-Identifier: Apache-2.0
// A written animation file is opened again and held against its take. The check shares nothing with the
// export but the readers and kinematics: it samples the run itself, and where the root was held it compares
// what holding must leave alone (height, tilt, shape) and what it must have made (one spot, one heading).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/processing/export_take.h"
#include "core/recording/rows.h"

namespace noctule {

/// A board that delivered nothing for a while within the exported time; the filter went on without it.
struct SilentBoard {
    int board = -1;  ///< -1: all boards
    std::string segment;
    double from_s = 0, to_s = 0;  ///< of the take's clock, cut to the exported time
    size_t frames = 0;            ///< of the file
};

/// What keeps the figure of a run at its height above the floor.
enum class HeldBy {
    kLevelFloor,    ///< feet that stand, on one floor
    kNothing,       ///< the run knew of no feet that stand, though the readings may tell of them
    kUnevenGround,  ///< feet that stand, as high as each finds the ground
    kTreadmill,
    kRoom,         ///< anchors
    kOtherSystem,  ///< its root was given, or the whole motion was imported
};

HeldBy heldBy(const DerivedRun& pose_run);

/// What helps a figure below the floor. kNone: nothing need or can be done.
enum class FloorRemedy { kNone, kHoldFeet, kLevelGround, kMoveUp, kOtherSystem, kRoom };

struct ExportCheck {
    std::string path;
    std::string run;
    int64_t bytes = 0;
    size_t frames = 0, expected_frames = 0;
    double frames_per_second = 0;                ///< as the file says
    bool has_figure = false;                     ///< the file tells height, lowest point and facing
    double height_m = 0, expected_height_m = 0;  ///< of the zero pose; CSV: of the first frame's joints
    double lowest_m = 0;                         ///< lowest joint or tip of all frames; 0 is the floor
    double usual_lowest_m = 0;                   ///< the same of each frame, median over the frames
    HeldBy held_by = HeldBy::kLevelFloor;
    /// Heading of the zero pose or of the first frame (CSV): 0 faces +Z with the left side to +X,
    /// positive turns towards +X.
    double facing_rad = 0, expected_facing_rad = 0;
    int joints = 0, expected_joints = 0;
    bool is_picture = false;  ///< picture or film: nothing but frames, rate and size is known of it
    PictureSize size{0, 0};   ///< of a picture or film
    bool has_angles = false;  ///< the file states angles
    double largest_angle_rad = 0, largest_position_m = 0;
    double position_limit_m = 0;  ///< what rounding in this kind of file can explain
    std::vector<SilentBoard> silent;
    std::vector<std::string> held;    ///< whole sentences: who stands still where no pose was captured
    std::vector<std::string> faults;  ///< whole sentences; empty: the file holds what the take holds

    bool ok() const { return faults.empty(); }
    /// A figure that is held and goes below the floor for moments has none: a landing, a hand, a rolling
    /// foot.
    FloorRemedy floorRemedy() const;
    /// Feet that a run holds roll less deep through the floor.
    static constexpr double kOnFloor_m = 0.02;
};

/// What rounding in the files can explain, with room to spare; more is a fault.
inline constexpr double kExportAngle_rad = 1e-4, kExportPosition_m = 1e-5;
inline constexpr double kExportScenePosition_m = 5e-5;  ///< FBX and GLB hold float32

/// One check per file of a request that was exported, in the order of outputsOf(). OpenSim's tables are
/// compared in what does not depend on how the root was held, and tell neither height nor facing. A file that
/// cannot be read is a check with that as its fault; an Error means that the take could not be read.
Result<std::vector<ExportCheck>> checkExport(const ExportRequest& request, const JobContext& job);

/// The same of exportStacks(): one check per take, of a file that is read once.
Result<std::vector<ExportCheck>> checkStacks(const std::vector<ExportRequest>& takes, const JobContext& job);

}  // namespace noctule
