// SPDX-License-Identifier: Apache-2.0
#include "core/review/take_review.h"

#include "core/review/plot_series.h"
#include "tests/core/processing/made_take.h"

namespace noctule {
namespace {

using test::kFrames, test::kInterval, test::kPulses, test::kRate_hz;

constexpr double kInterval_s = static_cast<double>(kInterval) / kRate_hz;

class TakeReview : public test::MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addRuns("AGD");
        addReference(0.1);
    }
    int64_t rangeRun() { return *overview().runs[0].settings.range_run; }
    TakeOverview overview() {
        const auto overview = overviewTake(path(), {});
        return overview ? *overview : TakeOverview{};
    }
};

TEST_F(TakeReview, OverviewTellsWhatTheTakeHolds) {
    const auto overview = overviewTake(path(), {});
    ASSERT_TRUE(overview) << overview.error().text();
    EXPECT_EQ(overview->header.name, "made_001");
    EXPECT_EQ(overview->state, "complete");
    EXPECT_EQ(overview->level, TakeLevel::kReadings);
    EXPECT_DOUBLE_EQ(overview->duration_s, 2);
    EXPECT_GT(overview->bytes, 10'000);
    EXPECT_EQ(overview->suit.boards.size(), 2u);
    EXPECT_TRUE(overview->actor);
    ASSERT_EQ(overview->runs.size(), 1u);
    EXPECT_EQ(overview->runs[0].run.name, "AGD");
    EXPECT_EQ(overview->runs[0].settings.inertial_run, kPrimaryRun);
    EXPECT_TRUE(overview->has_reference);
    EXPECT_EQ(overview->reference_kind, "simulated");
    EXPECT_FALSE(overview->has_external_root);
    EXPECT_TRUE(overview->markers.empty());
    EXPECT_EQ(overview->rest_s, std::optional(std::pair(0.0, 0.5)));
    EXPECT_TRUE(overview->problems.empty()) << overview->problems[0];
}

TEST_F(TakeReview, OverviewOfDamageSpeaksInSentences) {
    {
        const auto database = Database::open(path(), Access::kReadWrite);
        ASSERT_TRUE(database);
        ASSERT_TRUE(database->execute("UPDATE actor SET json='{'"));
        ASSERT_TRUE(database->execute("DROP TABLE calibration"));
        ASSERT_TRUE(database->execute("INSERT INTO marker(sample,kind,label) VALUES(-5,'user','x')"));
        ASSERT_TRUE(database->execute("INSERT INTO marker(sample,kind,label) VALUES(150000,'user','here')"));
        ASSERT_TRUE(
            database->execute("INSERT INTO gap(first_sample,sample_count,reason) VALUES(1500,3000,'link')"));
        ASSERT_TRUE(database->execute("UPDATE meta SET value='recording' WHERE key='state'"));
    }
    const auto overview = overviewTake(path(), {});
    ASSERT_TRUE(overview) << overview.error().text();
    EXPECT_FALSE(overview->actor);
    EXPECT_EQ(overview->calibration.boards.size(), 2u);  // nominal
    ASSERT_EQ(overview->markers.size(), 1u);
    EXPECT_DOUBLE_EQ(overview->markers[0].t_s, 1);
    ASSERT_EQ(overview->gaps_s.size(), 1u);
    EXPECT_DOUBLE_EQ(overview->gaps_s[0].second, 0.03);
    EXPECT_GE(overview->problems.size(), 4u);
    for (const std::string& problem : overview->problems)
        EXPECT_TRUE(problem.ends_with('.')) << problem;
}

TEST_F(TakeReview, NoTakeIsAnError) {
    EXPECT_FALSE(overviewTake(file("none.noctule"), {}));
    EXPECT_FALSE(loadPoses(file("none.noctule"), 1, {}));
    EXPECT_FALSE(loadPoses(path(), 77, {}));
}

TEST_F(TakeReview, PosesAndReferenceAreThoseWritten) {
    const auto motion = loadPoses(path(), overview().runs[0].run.run, {});
    ASSERT_TRUE(motion) << motion.error().text();
    ASSERT_EQ(motion->frames.size(), static_cast<size_t>(kFrames));
    EXPECT_LT((motion->frames[140].pose->p_world_root - poseAt(1).p_world_root).norm(), 1e-12);
    const auto reference = loadPoses(path(), std::nullopt, {});
    ASSERT_TRUE(reference) << reference.error().text();
    EXPECT_EQ(reference->frames.size(), static_cast<size_t>(kFrames));
}

TEST_F(TakeReview, RangesKeepTheirFates) {
    const auto table = loadRanges(path(), rangeRun(), {});
    ASSERT_TRUE(table) << table.error().text();
    EXPECT_EQ(table->source_count, 1);
    EXPECT_EQ(table->board_count, 2);
    ASSERT_EQ(table->pulse_t_s.size(), 1u);
    EXPECT_EQ(table->pulse_t_s[0].size(), static_cast<size_t>(kPulses));
    const PairTrack& track = table->pair(0, 0);
    ASSERT_EQ(track.t_s.size(), static_cast<size_t>(kPulses * 4 / 5));
    EXPECT_DOUBLE_EQ(track.t_s[4], 5 * kInterval_s);  // the fifth pulse was not heard
    EXPECT_EQ(track.fate[1], RangeFate::kWeighted);
    EXPECT_EQ(track.fate[2], RangeFate::kGated);
    EXPECT_FLOAT_EQ(track.confidence[0], 0.25F);
    EXPECT_FLOAT_EQ(track.innovation_m[0], 0.002F);
    EXPECT_TRUE(std::isnan(track.innovation_m[3]));  // unsure: not tried
    EXPECT_TRUE(table->pair(0, 1).t_s.empty());
}

TEST_F(TakeReview, RangesOfPulsesOutOfOrderAreSorted) {
    const int64_t run = rangeRun();
    {
        const auto database = Database::open(path(), Access::kReadWrite);
        ASSERT_TRUE(database);
        ASSERT_TRUE(database->execute("UPDATE pulse SET sample=(240-id)*1200"));
    }
    const auto table = loadRanges(path(), run, {});
    ASSERT_TRUE(table);
    const PairTrack& track = table->pair(0, 0);
    EXPECT_EQ(track.t_s.size(), static_cast<size_t>(kPulses * 4 / 5));
    EXPECT_TRUE(std::is_sorted(track.t_s.begin(), track.t_s.end()));
    EXPECT_EQ(track.fate.back(), RangeFate::kUsed);  // that of the first pulse by number
}

TEST_F(TakeReview, RangesOfTwoStretchesAreThoseOfTheWhole) {
    const auto whole = loadRanges(path(), rangeRun(), {});
    auto first = loadRanges(path(), rangeRun(), {}, {0, 2}),
         second = loadRanges(path(), rangeRun(), {}, {1, 2});
    ASSERT_TRUE(whole && first && second);
    EXPECT_NEAR(static_cast<double>(first->pair(0, 0).t_s.size()),
                static_cast<double>(second->pair(0, 0).t_s.size()), 1);
    const RangeTable joined = joinRanges({*second, *first});
    ASSERT_EQ(joined.pairs.size(), whole->pairs.size());
    EXPECT_EQ(joined.pulse_t_s, whole->pulse_t_s);
    for (size_t i = 0; i < whole->pairs.size(); ++i) {
        const PairTrack &one = joined.pairs[i], &other = whole->pairs[i];
        EXPECT_EQ(one.t_s, other.t_s);
        EXPECT_EQ(one.confidence, other.confidence);
        EXPECT_EQ(one.sigma_m, other.sigma_m);
        EXPECT_EQ(one.distance_m, other.distance_m);
        EXPECT_EQ(one.fate, other.fate);
        ASSERT_EQ(one.innovation_m.size(), other.innovation_m.size());
        for (size_t k = 0; k < one.innovation_m.size(); ++k)  // not tried: NaN, which equals nothing
            EXPECT_TRUE(one.innovation_m[k] == other.innovation_m[k] || std::isnan(one.innovation_m[k]));
    }
}

TEST_F(TakeReview, ReadingsAreCalibratedLostAndClipped) {
    const auto table = loadReadings(path(), kPrimaryRun, {});
    ASSERT_TRUE(table) << table.error().text();
    ASSERT_EQ(table->boards.size(), 2u);
    const BoardTrack& board = table->boards[0];
    ASSERT_EQ(board.t_s.size(), static_cast<size_t>(kFrames));
    EXPECT_FLOAT_EQ(board.value[0][10], 0);
    EXPECT_TRUE(std::isnan(board.value[0][200]));
    EXPECT_FALSE(std::isnan(board.value[1][200]));
    ASSERT_EQ(board.clipped_s.size(), 1u);
    EXPECT_NEAR(board.clipped_s[0], 200 / 140.0, 1e-9);
    EXPECT_TRUE(board.lost_s.empty());
    EXPECT_EQ(table->boards[1].lost_s.size(), 60u);
    EXPECT_TRUE(std::isnan(table->boards[1].value[3][3]));
}

TEST_F(TakeReview, ReadingsFollowTheCalibration) {
    {
        auto take = Take::open(path(), Access::kReadWrite);
        ASSERT_TRUE(take);
        Calibration calibration = nominalCalibration(*take->suit());
        calibration.boards[0].gyro.zero_counts = {2000, 2048, 2048};
        calibration.boards[0].gyro.matrix = Matrix3d::Identity() * 0.01;
        calibration.boards[0].gyro.matrix(1, 0) = 0.001;  // x turns into y a little
        auto edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit);
        ASSERT_TRUE(edit->addCalibration(calibration));
        ASSERT_TRUE(edit->commit());
    }
    const auto table = loadReadings(path(), kPrimaryRun, {});
    ASSERT_TRUE(table);
    EXPECT_FLOAT_EQ(table->boards[0].value[0][10], 0.48F);
    EXPECT_FLOAT_EQ(table->boards[0].value[1][10], 0.048F);
}

TEST_F(TakeReview, CancelledLoadingSaysSo) {
    CancelFlag cancel;
    cancel.cancel();
    const JobContext job{nullptr, &cancel};
    EXPECT_EQ(overviewTake(path(), job).error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(loadPoses(path(), std::nullopt, job).error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(loadRanges(path(), rangeRun(), job).error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(loadReadings(path(), kPrimaryRun, job).error().kind, ErrorKind::kCancelled);
}

TEST_F(TakeReview, ATakeOfReadingsHasNoSound) {
    EXPECT_EQ(loadSound(path(), 0, 0, 1, std::nullopt, {}).error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(loadSoundEnvelope(path(), 0, 100, {}).error().kind, ErrorKind::kUnusable);
}

TEST_F(TakeReview, SummariesAreThoseOfTheWindow) {
    const auto table = loadRanges(path(), rangeRun(), {});
    ASSERT_TRUE(table);
    const PairSummaries summaries(*table);
    // Pulses 10..19: two rounds of used, weighted, gated, unsure, silent.
    const PairWindow window = summaries.window(0, 0, 9.5 * kInterval_s, 19.5 * kInterval_s);
    EXPECT_EQ(window.pulses, 10);
    EXPECT_EQ(window.heard, 8);
    EXPECT_EQ(window.used, 4);
    EXPECT_EQ(window.gated, 2);
    EXPECT_NEAR(window.mean_confidence, 8 * 0.25 / 10, 1e-9);
    ASSERT_TRUE(window.residual_rms_m);
    EXPECT_NEAR(*window.residual_rms_m, 0.002, 1e-6);
    EXPECT_EQ(summaries.window(0, 1, 0, 2).heard, 0);
    EXPECT_EQ(summaries.window(0, 1, 0, 2).pulses, kPulses);
    EXPECT_EQ(summaries.window(0, 0, 1, 1).pulses, 0);
    EXPECT_FALSE(summaries.window(0, 1, 0, 2).residual_rms_m);
}

TEST_F(TakeReview, CurvesOfAPairCountWhatWasNotHeard) {
    const auto table = loadRanges(path(), rangeRun(), {});
    ASSERT_TRUE(table);
    const Series confidence = rangeSeries(*table, 0, 0, RangeQuantity::kConfidence);
    ASSERT_EQ(confidence.t_s.size(), static_cast<size_t>(kPulses));
    EXPECT_FLOAT_EQ(confidence.value[3], 0.25F);
    EXPECT_EQ(confidence.value[4], 0);
    const Series distance = rangeSeries(*table, 0, 0, RangeQuantity::kDistance_m);
    EXPECT_FLOAT_EQ(distance.value[3], 0.5F);
    EXPECT_TRUE(std::isnan(distance.value[4]));
    EXPECT_TRUE(std::isnan(rangeSeries(*table, 0, 0, RangeQuantity::kResidual_m).value[3]));
    EXPECT_EQ(rangeSeries(*table, 0, 1, RangeQuantity::kConfidence).value[0], 0);
}

TEST_F(TakeReview, APairNowIsWhatItsCurveShowsThere) {
    const auto table = loadRanges(path(), rangeRun(), {});
    ASSERT_TRUE(table);
    const Series curve = rangeSeries(*table, 0, 0, RangeQuantity::kConfidence);
    for (size_t i = 0; i < curve.t_s.size(); ++i)
        for (const double later_s : {0.0, 0.4 * kInterval_s}) {
            const PairNow now = pairAt(*table, 0, 0, curve.t_s[i] + later_s);
            ASSERT_TRUE(now.has_pulse);
            EXPECT_EQ(now.confidence.value_or(0), curve.value[i]) << "pulse " << i;
            EXPECT_EQ(now.confidence.has_value(), i % 5 != 4);
        }
    EXPECT_FALSE(pairAt(*table, 0, 0, curve.t_s.front() - 1e-6).has_pulse);
    EXPECT_TRUE(pairAt(*table, 0, 0, curve.t_s.back() + 0.9 * kPairHold_s).has_pulse);
    EXPECT_FALSE(pairAt(*table, 0, 0, curve.t_s.back() + 1.1 * kPairHold_s).has_pulse);
}

/// 1 s of made sound at 15 kHz in blocks of 1000 samples: value = sample on board 0, minus that on board 1.
class SoundReview : public test::MadeTake {
protected:
    static constexpr int kSoundRate_hz = 15000, kBlock = 1000;
    void SetUp() override {
        MadeTake::SetUp();
        TakeHeader header;
        header.name = "sound_001";
        header.sample_rate_hz = kSoundRate_hz;
        header.board_count = 2, header.source_count = 1;
        header.pulse_interval_samples = 150;
        auto take = TakeWriter::create(soundPath(), header);
        ASSERT_TRUE(take) << take.error().text();
        const auto made = Take::open(path());
        ASSERT_TRUE(take->addSuit(*made->suit()));
        for (int64_t first = 0; first < kSoundRate_hz; first += kBlock) {
            std::vector<int16_t> values;
            for (int64_t i = first; i < first + kBlock; ++i)
                values.push_back(static_cast<int16_t>(i)), values.push_back(static_cast<int16_t>(-i));
            if (first == 7000)
                continue;  // a hole
            ASSERT_TRUE(take->addBlock({first, values}, 2, 1, first % 2000 == 0));
        }
        for (int64_t sample = 0; sample < kSoundRate_hz; sample += 150) {
            const auto pulse = take->addPulse(sample, 0);
            ASSERT_TRUE(pulse);
            RangeMeasurement range;
            range.pulse = *pulse, range.board = 1;
            range.arrival_sample = static_cast<double>(sample) + 45.5;
            range.distance_m = 1, range.w_s = range.w_t = 1;
            if (sample % 300 == 0) {
                ASSERT_TRUE(take->addRange(kPrimaryRun, range, "inflection"));
            }
        }
        ASSERT_TRUE(take->addGap({2000, 100, 1, "board"}));
        ASSERT_TRUE(take->finish());
    }
    std::string soundPath() const { return file("sound_001.noctule"); }
};

TEST_F(SoundReview, AWindowHoldsItsSamplesHolesAndPulses) {
    const auto sound = loadSound(soundPath(), 1, 0.13, 0.54, kPrimaryRun, {});
    ASSERT_TRUE(sound) << sound.error().text();
    EXPECT_DOUBLE_EQ(sound->from_s, 0.13);
    ASSERT_EQ(sound->value.size(), 6150u);
    const auto at = [&](int64_t sample) { return sound->value[static_cast<size_t>(sample - 1950)]; };
    EXPECT_FLOAT_EQ(at(1950), -1950 / 32767.0F);
    EXPECT_TRUE(std::isnan(at(2000)));
    EXPECT_TRUE(std::isnan(at(2099)));
    EXPECT_FLOAT_EQ(at(2100), -2100 / 32767.0F);
    EXPECT_FLOAT_EQ(at(6999), -6999 / 32767.0F);
    EXPECT_TRUE(std::isnan(at(7000)));
    EXPECT_TRUE(std::isnan(at(7999)));
    EXPECT_FLOAT_EQ(at(8099), -8099 / 32767.0F);
    ASSERT_FALSE(sound->pulses.empty());
    EXPECT_NEAR(sound->pulses.front().sent_s, 0.13, 1e-9);
    EXPECT_NEAR(sound->pulses.back().sent_s, 0.53, 1e-9);
    EXPECT_FALSE(sound->pulses[0].arrival_s);  // sample 1950 is no multiple of 300
    ASSERT_TRUE(sound->pulses[1].arrival_s);
    EXPECT_NEAR(*sound->pulses[1].arrival_s, (2100 + 45.5) / kSoundRate_hz, 1e-9);
}

TEST_F(SoundReview, TheOtherBoardHasNoGapOfItsOwn) {
    const auto sound = loadSound(soundPath(), 0, 0.13, 0.15, std::nullopt, {});
    ASSERT_TRUE(sound);
    EXPECT_FLOAT_EQ(sound->value[60], 2010 / 32767.0F);
    EXPECT_FALSE(sound->pulses[1].arrival_s);
}

TEST_F(SoundReview, ImpossibleWindowsAreRefused) {
    EXPECT_EQ(loadSound(soundPath(), 0, 0, 10.1, {}, {}).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(loadSound(soundPath(), 0, 1, 1, {}, {}).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(loadSound(soundPath(), 2, 0, 1, {}, {}).error().kind, ErrorKind::kUsage);
    const auto beyond = loadSound(soundPath(), 0, 5, 5.1, {}, {});
    ASSERT_TRUE(beyond);
    EXPECT_TRUE(
        std::all_of(beyond->value.begin(), beyond->value.end(), [](float v) { return std::isnan(v); }));
}

TEST_F(SoundReview, TheEnvelopeIsLowestAndHighest) {
    const auto envelope = loadSoundEnvelope(soundPath(), 1, 15, {});
    ASSERT_TRUE(envelope) << envelope.error().text();
    ASSERT_EQ(envelope->min.size(), 15u);
    EXPECT_FLOAT_EQ(envelope->max[3], -3000 / 32767.0F);
    EXPECT_FLOAT_EQ(envelope->min[3], -3999 / 32767.0F);
    EXPECT_FLOAT_EQ(envelope->max[2], -2100 / 32767.0F);  // the gap is no silence
    EXPECT_TRUE(std::isnan(envelope->min[7]));
    EXPECT_FALSE(loadSoundEnvelope(soundPath(), 1, 0, {}));
}

/// Also one that has the last number, whose number nobody gets again.
TEST_F(TakeReview, AResultKeepsItsNumberWhenAnotherIsDeleted) {
    for (const char* run : {"first", "second", "third"})
        addRuns(run);
    const auto drop = [&](const std::string& name) {
        auto take = Take::open(path(), Access::kReadWrite);
        const auto runs = take->derivedRuns();
        auto edit = TakeEdit::begin(*take);
        for (const DerivedRun& run : *runs)
            if (run.name == name) {
                ASSERT_TRUE(edit->dropRun(run.run));
            }
        ASSERT_TRUE(edit->commit());
    };
    const auto numbers = [&] {
        std::vector<std::pair<std::string, int>> found;
        for (const ReviewRun& run : overviewTake(path(), {})->runs)
            found.emplace_back(run.run.name, run.number);
        return found;
    };
    using Numbers = std::vector<std::pair<std::string, int>>;
    EXPECT_EQ(numbers(), (Numbers{{"AGD", 1}, {"first", 2}, {"second", 3}, {"third", 4}}));
    drop("first");
    EXPECT_EQ(numbers(), (Numbers{{"AGD", 1}, {"second", 3}, {"third", 4}}));
    drop("third");
    addRuns("fourth");
    EXPECT_EQ(numbers(), (Numbers{{"AGD", 1}, {"second", 3}, {"fourth", 5}}));
}

}  // namespace
}  // namespace noctule
