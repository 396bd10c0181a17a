// SPDX-License-Identifier: Apache-2.0
// The tiny take in memory: what two boards sampled in two seconds, and what is known about them.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/live/live_pipeline.h"
#include "core/recording/take.h"

namespace noctule::test {

struct WornTinyTake {
    Suit suit;
    Calibration calibration;
    Actor actor;
    PulseTrain train;
    std::pair<int64_t, int64_t> rest;
    std::vector<Pulse> pulses;
    std::vector<TemperatureStatus> statuses;
    std::vector<RootMeasurement> roots;
    std::vector<int16_t> sound;  ///< sample-interleaved

    int64_t sampleCount() const { return std::ssize(sound) / std::ssize(suit.boards); }
    std::span<const int16_t> samples(int64_t first, int64_t end) const {
        const auto boards = static_cast<int64_t>(suit.boards.size());
        return std::span(sound).subspan(static_cast<size_t>(first * boards),
                                        static_cast<size_t>((end - first) * boards));
    }
};

inline WornTinyTake wornTinyTake() {
    const Take take = std::move(Take::open(NOCTULE_TEST_DATA "/takes/tiny_take.noctule").value());
    WornTinyTake worn;
    worn.suit = take.suit().value();
    worn.calibration = take.calibrationInForce().value().value;
    worn.actor = take.actorInForce().value().value;
    worn.train = {static_cast<double>(take.header().sample_rate_hz),
                  static_cast<int>(take.header().pulse_interval_samples), take.header().drive_hz,
                  static_cast<int>(take.header().pulse_cycles)};
    const SampleInterval rest = take.restInterval().value().value();
    worn.rest = {rest.first, rest.last};
    worn.pulses = take.pulses().value();
    const auto statuses = take.statusRows();
    for (const StatusRow& row : *statuses)
        worn.statuses.push_back({row.sample, row.temperature_c, row.humidity_percent});
    const auto roots = take.externalRoot();
    for (const ExternalRootRow& row : *roots)
        worn.roots.push_back({static_cast<double>(row.time_ns) * 1e-9, row.p_world_root, row.q_world_root,
                              row.sigma_p_m, row.sigma_q_rad});
    const Status read = take.forEachBlock(1, [&](const AdcBlock& block) {
        worn.sound.insert(worn.sound.end(), block.values.begin(), block.values.end());
        return true;
    });
    EXPECT_TRUE(read);
    return worn;
}

/// Cells of a comma-separated golden file, without its heading.
inline std::vector<std::vector<std::string>> goldenTable(const std::string& name) {
    std::ifstream file(NOCTULE_TEST_DATA "/takes/" + name);
    EXPECT_TRUE(file.is_open()) << name;
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        std::istringstream text(line + ",");
        for (std::string cell; std::getline(text, cell, ',');)
            cells.push_back(cell);
        rows.push_back(cells);
    }
    return rows;
}

}  // namespace noctule::test
