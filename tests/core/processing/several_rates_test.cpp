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

using posing::test::kWhole;
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
    /// Three suits; errors of each segment's attitude against that of the hips.
    void expectTheWalk(const RateOf& rate_hz, const std::string& what) const {
        std::map<std::string, double> error_deg;
        double mean_deg = 0;
        for (unsigned seed = 1; seed <= kSuits; ++seed) {
            const TimedMotion motion = posed(recordingOf(actor_, rate_hz, seed));
            ASSERT_GT(motion.frames.size(), 25u * (size_t(posing::test::kDuration_s) - 1));
            EXPECT_NEAR(double(motion.frames.back().time_ns) * 1e-9, posing::test::kDuration_s, 0.1);
            for (const auto& [segment, error] : errorsOf(motion)) {
                error_deg[segment] += error / kSuits;
                mean_deg += error / (kSuits * double(kWhole.size()));
            }
        }
        // Usual: 0.5 to 0.8 in the mean, 1.8 of an upper arm.
        EXPECT_LT(mean_deg, 1) << what;
        for (const auto& [segment, error] : error_deg)
            EXPECT_LT(error, 2.5) << segment << ", " << what;
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

    std::map<std::string, double> errorsOf(const TimedMotion& motion) const {
        std::map<std::string, double> errors;
        for (const TimedPose& timed : motion.frames) {
            const GlobalPose is = globalPose(actor_.skeleton, timed.pose.value());
            const GlobalPose should =
                globalPose(actor_.skeleton, posing::test::walkAt(actor_, double(timed.time_ns) * 1e-9));
            for (const std::string& segment : kWhole) {
                const auto j = size_t(actor_.skeleton.find(segment));
                errors[segment] +=
                    degrees(angleBetween(is.q_world_joint[0].conjugate() * is.q_world_joint[j],
                                         should.q_world_joint[0].conjugate() * should.q_world_joint[j])) /
                    double(motion.frames.size());
            }
        }
        return errors;
    }

    test::Folder folder_;
    Actor actor_ = defaultActor();
};

TEST_F(SeveralRates, EachFindsTheWalk) {
    for (const double rate_hz : {40.0, 59.9, 100.0, 285.7})
        expectTheWalk(all(rate_hz), std::to_string(rate_hz) + " Hz");
}

TEST_F(SeveralRates, TogetherInOneSuitTheyFindTheWalk) {
    expectTheWalk(
        [](const std::string& segment) {
            return segment.ends_with("Arm") || segment.ends_with("Hand") ? 100.0
                   : segment.starts_with("Left")                         ? 200.0
                   : segment.starts_with("Right")                        ? 50.0
                                                                         : 60.0;
        },
        "50 to 200 Hz");
}

}  // namespace
}  // namespace noctule
