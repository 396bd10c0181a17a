// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/speed_of_sound.h"

#include <gtest/gtest.h>

#include <limits>

namespace noctule {
namespace {

TEST(SpeedOfSound, CramerGivesTheGoldenValue) {
    // vectors/tiny_take.json of the specification
    EXPECT_NEAR(speedOfSoundCramer(22.5, 44.65286127147711), 345.4736287118597, 1e-9);
}

TEST(SpeedOfSound, LinearIsWithinAQuarterOfAPercentOfCramer) {
    for (double t = 0; t <= 30; t += 5)
        for (double humidity = 0; humidity <= 100; humidity += 25)
            EXPECT_NEAR(speedOfSoundLinear(t, humidity) / speedOfSoundCramer(t, humidity), 1, 0.0024)
                << t << " C, " << humidity << " %";
}

TEST(SpeedOfSound, InterpolatesBetweenRowsAndHoldsTheEnds) {
    const std::vector<TemperatureStatus> rows{
        {300000, 24.0, {}}, {0, 20.0, 40.0}, {150000, {}, 60.0}};  // in no order, with holes
    const SpeedOfSound speed(SoundModel{}, rows);
    EXPECT_EQ(speed.at(-5), speedOfSoundCramer(20, 40));
    EXPECT_NEAR(speed.at(75000), speedOfSoundCramer(21, 50), 1e-9);
    EXPECT_NEAR(speed.at(225000), speedOfSoundCramer(23, 60), 1e-9);
    EXPECT_EQ(speed.at(900000), speedOfSoundCramer(24, 60));
    EXPECT_FALSE(speed.temperatureAssumed());
}

TEST(SpeedOfSound, SaysWhenItAssumesTheTemperature) {
    SpeedOfSound speed{SoundModel{}};
    EXPECT_TRUE(speed.temperatureAssumed());
    EXPECT_EQ(speed.at(0), speedOfSoundCramer(20, 50));
    speed.add({0, std::numeric_limits<double>::quiet_NaN(), 500.0});  // no air has these
    EXPECT_TRUE(speed.temperatureAssumed());
    EXPECT_EQ(speed.at(0), speedOfSoundCramer(20, 50));
    speed.add({0, 25.0, {}});
    EXPECT_FALSE(speed.temperatureAssumed());
    EXPECT_EQ(speed.at(0), speedOfSoundCramer(25, 50));
}

TEST(SpeedOfSound, ModelsAndScale) {
    const std::vector<TemperatureStatus> rows{{0, 21.0, 35.0}};
    EXPECT_DOUBLE_EQ(SpeedOfSound({SoundModel::Kind::kLinear, 0, 1.001}, rows).at(7),
                     1.001 * speedOfSoundLinear(21, 35));
    const SpeedOfSound fixed({SoundModel::Kind::kFixed, 340, 0.5});
    EXPECT_DOUBLE_EQ(fixed.at(7), 170);
    EXPECT_FALSE(fixed.temperatureAssumed());
}

}  // namespace
}  // namespace noctule
