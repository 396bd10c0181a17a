// SPDX-License-Identifier: Apache-2.0
// Every accident that the control port knows, in one recording: it goes on, what is missing is marked, time
// does not shift, and the studio comes back by itself. NOCTULE_CUT_SECONDS=30 cuts the link for that long.
#include <QCoreApplication>
#include <map>

#include "core/recording/take.h"
#include "core/suit/default_suit.h"
#include "devices/device/device.h"
#include "devices/live/record_take.h"
#include "tests/app/virtual_suit/test_studio.h"
#include "tests/support/fuzzing.h"

namespace noctule::test {
namespace {

constexpr int64_t kRate_hz = 150'000;

/// A recording under way, from the running suit into the folder.
class Recording {
public:
    Recording(const RunningSuit& suit, const Folder& folder) {
        static int argc = 1;
        static char name[] = "test", *argv[] = {name, nullptr};
        static QCoreApplication application(argc, argv);
        auto device = makeDevice("tcp://127.0.0.1:" + std::to_string(suit.tcpPort()));
        EXPECT_TRUE(device);
        StreamRequest request;
        request.process = false;
        request.take.emplace();
        request.take->folder = folder.path();
        request.take->name = "walk";
        request.take->reserve_bytes = 1'000'000;
        thread_ = std::thread([this, request, device = std::move(*device)]() mutable {
            report_ = recordTake(std::move(device), request, std::nullopt, {nullptr, &stop_});
        });
    }
    ~Recording() {
        if (thread_.joinable())
            stop();
    }
    const Result<RecordReport>& stop() {
        stop_.cancel();
        thread_.join();
        return report_;
    }

private:
    CancelFlag stop_;
    Result<RecordReport> report_ = Error{};
    std::thread thread_;
};

void wait(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// The tiny take as it is looped: two boards.
struct LoopedSound {
    std::vector<int16_t> values;
    std::vector<Pulse> pulses;

    LoopedSound() {
        const Take take = Take::open(kTinyTake).value();
        EXPECT_TRUE(take.forEachBlock(1, [&](const AdcBlock& block) {
            values.insert(values.end(), block.values.begin(), block.values.end());
            return true;
        }));
        pulses = take.pulses().value();
    }
    int64_t samples() const { return static_cast<int64_t>(values.size()) / 2; }
    int16_t at(int64_t sample, int board) const { return values[(sample % samples()) * 2 + board]; }
};

/// How a take's samples came: as they are, with the boards exchanged, with the second board unplugged, or
/// wrong.
struct Found {
    int64_t right = 0, swapped = 0, unplugged = 0, wrong = 0, end = 0;
    std::vector<std::pair<int64_t, int64_t>> holes;  ///< first sample and length
};

Found compared(const Take& take, const LoopedSound& sound) {
    Found found;
    EXPECT_TRUE(take.forEachBlock(1, [&](const AdcBlock& block) {
        if (block.first_sample > found.end)
            found.holes.emplace_back(found.end, block.first_sample - found.end);
        for (size_t i = 0; i + 1 < block.values.size(); i += 2) {
            const int64_t sample = block.first_sample + static_cast<int64_t>(i / 2);
            const int16_t a = block.values[i], b = block.values[i + 1];
            const int16_t wanted_a = sound.at(sample, 0), wanted_b = sound.at(sample, 1);
            if (a == wanted_a && b == wanted_b)
                ++found.right;
            else if (a == wanted_b && b == wanted_a)
                ++found.swapped;
            else if (a == wanted_a && std::abs(b) <= 1)
                ++found.unplugged;
            else
                ++found.wrong;
        }
        found.end = block.first_sample + static_cast<int64_t>(block.values.size()) / 2;
        return true;
    }));
    return found;
}

/// Tells everything that can happen and gives how long each lasted.
void letEverythingHappen(const RunningSuit& suit, double cut_s) {
    const auto tell = [&](const std::string& command, double then_wait_s) {
        EXPECT_EQ(suit.tell(command), "ok") << command;
        wait(then_wait_s);
    };
    tell("unplug 2", 0.6);
    tell("plug 2", 0.2);
    tell("swap 1 2", 0.6);
    tell("swap 1 2", 0.2);
    tell("temperature 31.5", 0);
    tell("battery 8", 1.2);
    tell("drop-bytes 0.0002", 0.5);
    tell("drop-bytes 0", 0.2);
    tell("flip-bits 0.00002", 0.5);
    tell("flip-bits 0", 0.2);
    tell("stall 1.6", 2.4);
    tell("cut " + std::to_string(cut_s), cut_s);
    wait(0.5 + std::min(4.0, cut_s));  // until the next attempt to connect
    tell("battery 60", 1.5);
}

TEST(FaultsInATake, RecordingGoesOnAndTimeDoesNotShift) {
    const double cut_s = static_cast<double>(countFromEnvironment("NOCTULE_CUT_SECONDS", 3));
    const Folder folder;
    RunningSuit suit({"--take", kTinyTake, "--loop"});
    Recording recording(suit, folder);
    const int64_t begun_ns = nowNs();
    wait(1);
    letEverythingHappen(suit, cut_s);
    const double lasted_s = static_cast<double>(nowNs() - begun_ns) * 1e-9;
    const auto& report = recording.stop();
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_FALSE(report->stream.trouble) << report->stream.trouble->text();
    EXPECT_FALSE(report->stream.recording->trouble);

    const auto take = Take::open(folder.file("walk_001.noctule"));
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("state"), "complete");
    const LoopedSound sound;
    const Found found = compared(*take, sound);
    EXPECT_EQ(found.wrong, 0) << "time has shifted, or damage came through";
    EXPECT_NEAR(static_cast<double>(found.unplugged) / kRate_hz, 0.6, 0.25);
    EXPECT_NEAR(static_cast<double>(found.swapped) / kRate_hz, 0.6, 0.25);
    EXPECT_NEAR(static_cast<double>(found.end) / kRate_hz, lasted_s, 1);

    std::map<std::string, int64_t> lost;
    std::vector<std::pair<int64_t, int64_t>> gaps;
    const std::vector<GapRow> gap_rows = take->gaps().value();
    for (const GapRow& gap : gap_rows) {
        EXPECT_FALSE(gap.board);
        lost[gap.reason] += gap.sample_count;
        if (!gaps.empty() && gaps.back().first + gaps.back().second == gap.first_sample)
            gaps.back().second += gap.sample_count;
        else
            gaps.emplace_back(gap.first_sample, gap.sample_count);
    }
    EXPECT_EQ(gaps, found.holes) << "every hole is marked, and nothing else";
    EXPECT_GT(lost["box"], kRate_hz / 5) << "what the stall pushed out of the box";
    EXPECT_GT(lost["link"], static_cast<int64_t>((cut_s - 1.5) * kRate_hz)) << "what the cut took";
    EXPECT_EQ(lost["studio"], 0);
    int64_t lost_in_all = 0;
    for (const auto& [reason, samples] : lost)
        lost_in_all += samples;
    EXPECT_EQ(found.right + found.swapped + found.unplugged + lost_in_all, found.end);

    int64_t before = -1;
    const std::vector<Pulse> pulses = take->pulses().value();
    for (const Pulse& pulse : pulses) {
        const int64_t lap = pulse.sample / sound.samples();
        const auto same = std::find_if(sound.pulses.begin(), sound.pulses.end(), [&](const Pulse& one) {
            return one.sample == pulse.sample - lap * sound.samples() && one.source == pulse.source;
        });
        EXPECT_NE(same, sound.pulses.end()) << pulse.sample;
        EXPECT_GT(pulse.sample, before) << "reported twice";
        before = pulse.sample;
    }
    bool was_warm = false, was_low = false, was_charged = false;
    const std::vector<StatusRow> status_rows = take->statusRows().value();
    for (const StatusRow& row : status_rows) {
        was_warm |= row.temperature_c && std::abs(*row.temperature_c - 31.5) < 1e-4;
        was_low |= row.battery_percent && *row.battery_percent < 8.5;
        was_charged |= was_low && row.battery_percent && *row.battery_percent > 55;
    }
    EXPECT_TRUE(was_warm);
    EXPECT_TRUE(was_low);
    EXPECT_TRUE(was_charged) << "STATUS comes again after the cut";
    std::printf("cut of %.0f s: %.2f s in gaps (box %.2f, link %.2f) of %.2f s, nothing wrong\n", cut_s,
                static_cast<double>(lost_in_all) / kRate_hz, static_cast<double>(lost["box"]) / kRate_hz,
                static_cast<double>(lost["link"]) / kRate_hz, static_cast<double>(found.end) / kRate_hz);
}

TEST(FaultsInATake, AnEmptyBatteryEndsTheTakeIntact) {
    const Folder folder;
    RunningSuit suit({"--take", kTinyTake, "--loop"});
    Recording recording(suit, folder);
    wait(1.5);
    EXPECT_EQ(suit.tell("battery 0"), "ok");
    wait(0.3);
    EXPECT_EQ(suit.tell("battery 90"), "ok");
    wait(4);
    const auto& report = recording.stop();
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->stream.trouble) << "the box has been started afresh";
    const auto take = Take::open(folder.file("walk_001.noctule"));
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "complete");
    const Found found = compared(*take, LoopedSound());
    EXPECT_EQ(found.wrong, 0);
    EXPECT_TRUE(found.holes.empty());
    EXPECT_NEAR(static_cast<double>(found.end) / kRate_hz, 1.5, 0.7);
}

TEST(FaultsInATake, ABoardThatSlipsInterruptsNothing) {
    const Folder folder;
    Suit suit_of_two = defaultSuit();
    suit_of_two.boards.resize(2);
    suit_of_two.sources.resize(2);
    writeBytes(folder.file("two.json"), toJson(suit_of_two).dump());
    RunningSuit suit({"--rig", "rest", "--scenario", "ideal", "--suit", folder.file("two.json")});
    Recording recording(suit, folder);
    wait(0.7);
    EXPECT_EQ(suit.tell("slip 1 30"), "ok");
    wait(0.7);
    ASSERT_TRUE(recording.stop());
    const auto take = Take::open(folder.file("walk_001.noctule"));
    ASSERT_TRUE(take);
    const auto gaps = take->gaps();
    ASSERT_TRUE(gaps);
    for (const GapRow& gap : *gaps)
        EXPECT_EQ(gap.reason, kGapOfBox) << "for want of a core";
    EXPECT_GT(*take->duration_s(), 0.6);
}

}  // namespace
}  // namespace noctule::test
