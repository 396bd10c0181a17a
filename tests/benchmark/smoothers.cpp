// SPDX-License-Identifier: Apache-2.0
// What each smoother gains over the filter: mean error over all joints in degrees, root given, readings
// level, on the scenario nominal and on a person whose boards sit where the calibration says (realistic but
// for mountings), with seconds of the processor for each second of the take.
//
//   measure_smoothers [MOTION.bvh [SECONDS [SENSORS [nominal|person]]]]
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/benchmark/judged_take.h"
#include "tests/benchmark/nominal_stage.h"

namespace noctule {
namespace {

double usedSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string simulated(const std::string& motion, double seconds, bool person) {
    simulation::StageRequest request = nominalStage(motion, seconds);
    if (person) {
        request.scenario = simulation::Scenario::realistic();
        request.scenario.mounting_rad = request.scenario.mounting_m = request.scenario.source_position_m = 0;
    }
    const std::string path = (std::filesystem::temp_directory_path() /
                              ("smoothers_" + std::string(person ? "person_" : "nominal_") +
                               std::filesystem::path(motion).stem().string() + ".noctule"))
                                 .string();
    writeReadings(simulation::prepareStage(request).value(), path);
    return path;
}

void measure(const std::string& motion, double seconds, const std::string& only_sensors,
             const std::string& only_scenario) {
    std::printf("%s, %.0f s\n\n| scenario | sensors |", motion.c_str(), seconds);
    constexpr Smoother kAll[] = {Smoother::kNone, Smoother::kLag, Smoother::kFull, Smoother::kBatch};
    for (const Smoother smoother : kAll)
        std::printf(" %s, deg | s/s |", smootherName(smoother));
    std::printf("\n|-|-|-|-|-|-|-|-|-|-|\n");
    for (const bool person : {false, true}) {
        if (!only_scenario.empty() && person != (only_scenario == "person"))
            continue;
        const std::string path = simulated(motion, seconds, person);
        for (const std::string sensors : {"AGD", "AG", "GD"}) {
            if (!only_sensors.empty() && sensors != only_sensors)
                continue;
            std::printf("| %s | %s |", person ? "person" : "nominal", sensors.c_str());
            for (const Smoother smoother : kAll) {
                TrackerSettings tracker;
                tracker.sensors = {sensors.find('A') != std::string::npos, true,
                                   sensors.find('D') != std::string::npos};
                tracker.root_given = true;
                tracker.smoother = smoother;
                tracker.spool_folder = std::filesystem::temp_directory_path().string();
                const double begin = usedSeconds();
                const Comparison judged = processedAndCompared(path, tracker);
                std::printf(" %.3f | %.2f |", judged.mean_deg, (usedSeconds() - begin) / seconds);
                std::fflush(stdout);
            }
            std::printf("\n");
        }
        std::filesystem::remove(path);
    }
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    const auto argument = [&](int i, const char* otherwise) {
        return std::string(argc > i ? argv[i] : otherwise);
    };
    noctule::measure(argument(1, "/usr/share/assimp/models/BVH/01_01.bvh"),
                     std::atof(argument(2, "15").c_str()), argument(3, ""), argument(4, ""));
    return 0;
}
