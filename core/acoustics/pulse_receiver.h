// SPDX-License-Identifier: Apache-2.0
// Turns the samples and the pulse log of one suit into one detection per pulse and board. Streaming: blocks,
// pulses and gaps are pushed in any portions, and the result is the same for every split. The window of a
// pulse is [sample, sample + interval); where samples of a board are missing in it, or in the millisecond on
// either side that the zero-phase filters look at, there is no measurement for that board: the edge of a gap
// sounds like a pulse.
#pragma once

#include <cmath>
#include <deque>
#include <memory>
#include <vector>

#include "core/acoustics/noise_floor.h"
#include "core/acoustics/pulse_detector.h"
#include "core/acoustics/range.h"
#include "core/acoustics/sample_history.h"

namespace noctule {

struct PulseDetection {
    Pulse pulse;
    int board = 0;
    bool gap = false;  ///< samples are missing: nothing below has a meaning
    bool clipped = false;
    double arrival_sample = 0;  ///< includes the source's offset
    double peak_power = 0;      ///< counts^2
    double noise_power = 0;     ///< counts^2, ambient, in the detector's band; at least that of rounding
    std::optional<CarrierArrival> carrier{};

    /// Amplitude ratio.
    double snr() const { return std::sqrt(peak_power / noise_power); }
};

class PulseReceiver {
public:
    /// Fails (kUnusable) for a train that cannot be received, or no or too many boards. `shapes`: for the
    /// detector that needs them.
    static Result<PulseReceiver> create(Detector detector, const PulseTrain& train, int board_count,
                                        const PulseShapes& shapes = {});
    /// With a detector made for `train`.
    static Result<PulseReceiver> create(std::shared_ptr<PulseDetector> detector, const PulseTrain& train,
                                        int board_count);

    /// Sample-interleaved values of all boards. A hole between blocks is a gap; samples already here are
    /// ignored.
    void pushBlock(int64_t first_sample, std::span<const int16_t> interleaved);
    /// False when the pulse is refused: it comes too late (advance() passed its window) or makes no sense.
    bool pushPulse(const Pulse& pulse);
    /// Samples that are in the blocks but mean nothing; no board: of all boards.
    void markMissing(int64_t first_sample, int64_t sample_count, std::optional<int> board);

    /// Everything before `complete_until` has been pushed: appends the detections of all pulses whose windows
    /// end by then, in the order of pulses, then of boards, and forgets what no later pulse needs. Call it at
    /// least once a second: only the last two seconds of samples are kept.
    void advance(int64_t complete_until, std::vector<PulseDetection>& detections);
    /// Nothing more will come; pulses whose windows are incomplete end as gaps.
    void finish(std::vector<PulseDetection>& detections);

    /// End of the samples pushed so far.
    int64_t samplesEnd() const { return history_.end(); }

private:
    PulseReceiver(std::shared_ptr<PulseDetector> detector, const PulseTrain& train, int board_count);
    void receive(const Pulse& pulse, std::vector<PulseDetection>& detections);
    int64_t windowEnd(const Pulse& pulse) const;

    std::shared_ptr<PulseDetector> detector_;
    SampleHistory history_;
    std::vector<NoiseFloor> noise_;  // per board
    std::deque<Pulse> waiting_;      // by sample
    std::vector<PulseArrival> arrivals_;
    int64_t complete_until_ = 0;
};

}  // namespace noctule
