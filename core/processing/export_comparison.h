// SPDX-License-Identifier: Apache-2.0
// The files' side of check_export.h: reads a file and fills in what it holds and how far that is from the
// motion it should hold.
#pragma once

#include "core/formats/scene_reader.h"
#include "core/mesh/retarget/moving_body.h"
#include "core/processing/check_export.h"

namespace noctule {

/// The take's own poses at the instants of the file's frames, root as captured.
struct ExpectedMotion {
    std::string name;  ///< in FBX and GLB
    Skeleton skeleton;
    RootMotion root = RootMotion::kMoving;
    double frame_time_s = 0;
    double begin_s = 0;  ///< of the first frame, on the take's clock
    std::vector<Pose> frames;
    std::vector<std::string> held;  ///< whole sentences
    FootPlants plants;              ///< of a body whose feet keep their place
    FeetAtRest feet_at_rest{};
};

/// An Error when the file cannot be read.
Status compareBvh(const std::string& path, double metres_per_unit, const ExpectedMotion& expected,
                  ExportCheck& check);
Status compareSceneFile(const SceneFile& scene, const ExpectedMotion& expected, ExportCheck& check);
/// The take's motion on the body of another program.
Status compareRiggedFile(const SceneFile& scene, const ExpectedMotion& expected, const ExportRequest& request,
                         ExportCheck& check);
/// OpenSim's .mot (angles) or .sto (orientations).
Status compareTable(const std::string& path, bool is_angles, const ExpectedMotion& expected,
                    ExportCheck& check);
/// The columns of freedoms that a CSV file of positions may have.
Status compareAngles(const std::string& path, const ExpectedMotion& expected, ExportCheck& check);
Status compareCsv(const std::string& path, bool angles, const ExpectedMotion& expected, ExportCheck& check);

}  // namespace noctule
