// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/count_mean.h"

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace noctule {
namespace {

std::vector<CountReading> roundedReadings(const Vector3d& mean, double noise, int count, uint64_t seed) {
    simulation::Random random(seed, "rounded");
    std::vector<CountReading> readings(static_cast<size_t>(count));
    for (CountReading& reading : readings)
        reading.gyro_counts = (mean + random.gaussianVector(noise)).array().round();
    return readings;
}

TEST(CountMean, UndoesTheRounding) {
    double squares = 0, worst_plain = 0;
    int count = 0;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        std::vector<std::vector<CountReading>> stretches;
        std::vector<std::span<const CountReading>> spans;
        std::vector<Vector3d> truths;
        simulation::Random random(seed, "means");
        for (uint64_t k = 0; k < 6; ++k) {
            truths.push_back(Vector3d::Constant(2048) + random.gaussianVector(40));
            stretches.push_back(roundedReadings(truths.back(), 0.234, 1100, 100 * seed + k));
        }
        spans.assign(stretches.begin(), stretches.end());
        const std::vector<CountMean> means = countMeans(spans, &CountReading::gyro_counts);
        for (size_t k = 0; k < means.size(); ++k) {
            const Vector3d off = means[k].counts - truths[k];
            EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.08);
            squares += off.cwiseQuotient(means[k].sigma).squaredNorm();
            count += 3;
            Vector3d plain = Vector3d::Zero();
            for (const CountReading& reading : stretches[k])
                plain += reading.gyro_counts / 1100;
            worst_plain = std::max(worst_plain, (plain - truths[k]).cwiseAbs().maxCoeff());
        }
    }
    EXPECT_GT(worst_plain, 0.1) << "or there is nothing to undo";
    EXPECT_GT(squares / count, 0.75);
    EXPECT_LT(squares / count, 1.35);
}

TEST(CountMean, OneCountAloneIsKnownToItsWidth) {
    const std::vector<CountReading> still = roundedReadings({2000, 2001, 2002}, 0, 500, 1);
    const CountMean mean = countMeans({still}, &CountReading::gyro_counts).front();
    EXPECT_LT((mean.counts - Vector3d(2000, 2001, 2002)).cwiseAbs().maxCoeff(), 0.01);
    EXPECT_GT(mean.sigma.minCoeff(), 0.1);
    EXPECT_LT(mean.sigma.maxCoeff(), 0.3);
}

TEST(CountMean, UnroundedAndNoisyReadingsHaveTheirPlainMean) {
    std::vector<CountReading> fine = roundedReadings({2000, 2001, 2002}, 3, 900, 2);
    Vector3d plain = Vector3d::Zero();
    for (CountReading& reading : fine) {
        reading.gyro_counts.y() += 0.25;
        plain += reading.gyro_counts / 900;
    }
    const CountMean mean = countMeans({fine}, &CountReading::gyro_counts).front();
    EXPECT_LT((mean.counts - plain).norm(), 1e-9);
    EXPECT_NEAR(mean.sigma.x(), 0.1, 0.01);
}

}  // namespace
}  // namespace noctule
