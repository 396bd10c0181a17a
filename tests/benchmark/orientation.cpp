// SPDX-License-Identifier: Apache-2.0
// How long each estimator of orientation takes for a reading, on one thread:
//
//     measure_orientation RECORDING.mat...
//
// One line an estimator and file: name, file, readings, nanoseconds of processor time a reading (the best of
// five runs).
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/import/import_format.h"
#include "core/orientation/orientation_estimators.h"

namespace noctule {
namespace {

constexpr int kRuns = 5;

double nsPerReading(const OrientationEstimator& estimator, const ImuSamples& samples, bool smooth) {
    double best = std::numeric_limits<double>::infinity();
    OrientationChoice choice;
    choice.smooth = smooth;
    for (int run = 0; run < kRuns; ++run) {
        const std::clock_t begin = std::clock();
        const auto result = estimator.run(samples, choice, {});
        const double taken_ns = 1e9 * double(std::clock() - begin) / CLOCKS_PER_SEC;
        if (result && result->q_world_sensor.size() == samples.size())
            best = std::min(best, taken_ns / double(samples.size()));
    }
    return best;
}

int measure(const std::string& path) {
    const auto files = readImportFiles({path}, nullptr);
    const ImportFormat* format = files ? importFormatOf(*files) : nullptr;
    if (!format) {
        std::fprintf(stderr, "%s: is no recording of sensors\n", path.c_str());
        return 1;
    }
    const auto recording = readImport(*format, *files, {}, {});
    if (!recording) {
        std::fprintf(stderr, "%s\n", recording.error().text().c_str());
        return 1;
    }
    const ImuSamples& samples = recording->sensors.front().samples;
    for (const OrientationEstimator& estimator : orientationEstimators())
        for (const bool smooth : {false, true})
            if (!smooth || estimator.can_smooth)
                std::printf("%s%s %s %zu %.0f\n", estimator.name, smooth ? "-smoothed" : "",
                            files->front().stem().c_str(), samples.size(),
                            nsPerReading(estimator, samples, smooth));
    return 0;
}

}  // namespace
}  // namespace noctule

int main(int count, char** arguments) {
    if (count < 2) {
        std::fprintf(stderr, "usage: measure_orientation RECORDING.mat...\n");
        return 2;
    }
    int failed = 0;
    for (int i = 1; i < count; ++i)
        failed |= noctule::measure(arguments[i]);
    return failed;
}
