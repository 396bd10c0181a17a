// SPDX-License-Identifier: Apache-2.0
// Sensors of other makers at other rates, also several within one suit: imported, posed, and held against the
// walk that they were made of.
#include "core/import/import_take.h"
#include "core/processing/process_take.h"
#include "core/recording/take_edit.h"
#include "tests/core/posing/made_walk.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

const std::vector<std::string> kWhole = {
    "Hips",         "Spine",     "Chest",     "Head",    "LeftArm",  "LeftForeArm", "LeftHand", "RightArm",
    "RightForeArm", "RightHand", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg",  "RightLeg", "RightFoot"};

using RateOf = std::function<double(const std::string& segment)>;

RateOf all(double rate_hz) {
    return [rate_hz](const std::string&) { return rate_hz; };
}

/// A walk that one sensor of each segment reads at a rate of its own.
ImportedRecording recordingOf(const Actor& actor, const RateOf& rate_hz, unsigned seed) {
    ImportedRecording recording;
    recording.name = "walk";
    std::map<double, posing::test::MadeSuit> suits;
    for (size_t s = 0; s < kWhole.size(); ++s) {
        const double rate = rate_hz(kWhole[s]);
        if (!suits.contains(rate))
            suits.emplace(rate, posing::test::madeSuit(actor, kWhole, seed, rate));
        const posing::SensorTrack& track = suits.at(rate).tracks.sensors[s];
        ImportedSensor sensor;
        sensor.id = track.id;
        sensor.segment = track.segment;
        sensor.samples.rate_hz = rate;
        sensor.samples.gyro_rad_per_s = track.rate_rad_per_s;
        sensor.samples.accel_m_per_s2 = track.accel_m_per_s2;
        recording.sensors.push_back(std::move(sensor));
    }
    return recording;
}

class SeveralRates : public testing::Test {
protected:
    /// Mean error of the segments' attitudes against that of the hips, over three suits, degrees.
    double error_deg(const RateOf& rate_hz) const {
        double sum = 0;
        for (unsigned seed = 1; seed <= kSuits; ++seed)
            sum += error_deg(posed(recordingOf(actor_, rate_hz, seed)));
        return sum / kSuits;
    }

private:
    static constexpr unsigned kSuits = 3;

    TimedMotion posed(const ImportedRecording& recording) const {
        const std::string path = folder_.file("walk.noctule");
        const auto written =
            writeImportedTake(recording, {path, "walk", "2026-01-01T00:00:00Z", "test", "u", true}, {});
        EXPECT_TRUE(written) << written.error().text();
        ProcessRequest request;
        request.take_path = path;
        request.actor = actor_;
        request.tracker.estimator = kOrientationEstimator;
        request.software = "test";
        request.created_utc = "2026-01-01T00:00:00Z";
        const auto processed = processTake(request, {});
        EXPECT_TRUE(processed) << processed.error().text();
        return Take::open(path).value().poses(processed->pose_run).value();
    }

    double error_deg(const TimedMotion& motion) const {
        double sum = 0;
        for (const TimedPose& timed : motion.frames) {
            const GlobalPose is = globalPose(actor_.skeleton, timed.pose.value());
            const GlobalPose should =
                globalPose(actor_.skeleton, posing::test::walkAt(actor_, double(timed.time_ns) * 1e-9));
            for (const std::string& segment : kWhole) {
                const auto j = size_t(actor_.skeleton.find(segment));
                sum += angleBetween(is.q_world_joint[0].conjugate() * is.q_world_joint[j],
                                    should.q_world_joint[0].conjugate() * should.q_world_joint[j]);
            }
        }
        return degrees(sum / double(motion.frames.size() * kWhole.size()));
    }

    test::Folder folder_;
    Actor actor_ = defaultActor();
};

// 0.5 to 0.8 degrees are usual; posed from attitudes without an error it is about 1, for headings then drift.
TEST_F(SeveralRates, EachFindsTheWalk) {
    for (const double rate_hz : {40.0, 59.9, 100.0, 285.7})
        EXPECT_LT(error_deg(all(rate_hz)), 1) << rate_hz << " Hz";
}

TEST_F(SeveralRates, TogetherInOneSuitTheyFindTheWalk) {
    EXPECT_LT(error_deg([](const std::string& segment) {
                  return segment.ends_with("Arm") || segment.ends_with("Hand") ? 100.0
                         : segment.starts_with("Left")                         ? 200.0
                         : segment.starts_with("Right")                        ? 50.0
                                                                               : 60.0;
              }),
              1);
}

}  // namespace
}  // namespace noctule
