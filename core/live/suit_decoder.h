// SPDX-License-Identifier: Apache-2.0
// The sound of one suit -> inertial readings and ranges. Push, streaming, no threads: blocks of any size give
// the same result. A thin joint of the receivers of inertial/ and acoustics/.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/acoustics/pulse_receiver.h"
#include "core/acoustics/range_finder.h"
#include "core/inertial/stream_receiver.h"

namespace noctule {

struct DecoderSettings {
    PulseTrain train;
    Detector detector = Detector::kInflection;
};

class SuitDecoder {
public:
    /// Fails (kUnusable) for a sample rate or pulse train that cannot be received.
    static Result<std::unique_ptr<SuitDecoder>> create(const Suit& suit, const Calibration& calibration,
                                                       const DecoderSettings& settings);

    void pushPulse(const Pulse& pulse);
    void pushStatus(const TemperatureStatus& status);
    /// Samples that mean nothing although blocks hold them; before the block that holds them.
    void markMissing(int64_t first_sample, int64_t count, std::optional<int> board);
    void pushBlock(int64_t first_sample, std::span<const int16_t> interleaved);
    void finish();

    /// What became known since the last call.
    std::vector<InertialReading> takeReadings();
    std::vector<RangeMeasurement> takeRanges() { return std::exchange(ranges_, {}); }

    /// Everything with an instant before this sample is out (readings of a board that has just been locked
    /// excepted: up to four frames come late).
    int64_t watermark() const;

    std::vector<StreamReport> streamReports() const;
    const std::vector<SourceProblem>& sourceProblems() const { return finder_.problems(); }
    bool temperatureAssumed() { return finder_.soundSpeed().temperatureAssumed(); }
    /// Windows of a pulse without a measurement because samples are missing, and pulses refused as too late.
    int64_t gapWindows() const { return gap_windows_; }
    int64_t refusedPulses() const { return refused_pulses_; }

private:
    SuitDecoder(const Suit& suit, const DecoderSettings& settings, PulseReceiver receiver,
                RangeFinder finder);
    void collect(const std::vector<PulseDetection>& detections);

    DecoderSettings settings_;
    PulseReceiver pulses_;
    RangeFinder finder_;
    std::vector<std::unique_ptr<StreamReceiver>> boards_;
    std::vector<RangeMeasurement> ranges_;
    int64_t samples_end_ = 0;
    int64_t gap_windows_ = 0, refused_pulses_ = 0;
};

}  // namespace noctule
