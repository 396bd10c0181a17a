// SPDX-License-Identifier: Apache-2.0
// How sure of itself a free root is that feet on a level floor hold, against the truth of simulated takes at
// readings level: measure_root [--ground G] [--calibration C.json --actor A.json] TAKE...
#include "tests/support/root_consistency.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/math/conventions.h"
#include "core/processing/outside_files.h"

int main(int argc, char** argv) {
    using namespace noctule;
    std::optional<Calibration> calibration;
    std::optional<Actor> actor;
    TrackerSettings settings;
    std::printf("%-24s %8s %8s %8s %8s %8s %8s %8s %9s %9s %9s %9s\n", "NEES", "floor", "height", "velocity",
                "yaw", "path, m", "end, %", "rms, %", "height, m", "yaw, deg", "sigma", "tilt, deg");
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--calibration") == 0 && i + 1 < argc) {
            calibration = readCalibrationFile(argv[++i]).value();
        } else if (std::strcmp(argv[i], "--actor") == 0 && i + 1 < argc) {
            const std::string path = argv[++i];
            actor = actorFromJson(nlohmann::json::parse(std::ifstream(path)), path).value();
        } else if (std::strcmp(argv[i], "--ground") == 0 && i + 1 < argc) {
            settings.ground = groundFromName(argv[++i]).value();
        } else {
            const Take take = Take::open(argv[i]).value();
            const auto root = test::judgeRoot(take, settings, calibration, actor);
            std::printf("%-24.24s %8.2f %8.2f %8.2f %8.2f %8.1f %8.2f %8.2f %9.3f %9.2f %9.2f %9.2f\n",
                        take.header().name.c_str(), root.nees_horizontal, root.nees_vertical,
                        root.nees_velocity, root.nees_yaw, root.path_m, 100 * root.end_m / root.path_m,
                        100 * root.rms_m / root.path_m, root.height_rms_m, degrees(root.yaw_at_most_rad),
                        degrees(root.yaw_sigma_rad), degrees(root.tilt_rad));
        }
    }
}
