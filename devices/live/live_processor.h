// SPDX-License-Identifier: Apache-2.0
// Runs the pipeline on what comes from the suit, on a thread of its own, and publishes what is known now.
// When it cannot keep up for two seconds it skips the oldest sound; the recording does not.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "core/live/health.h"
#include "core/live/latency.h"
#include "core/live/live_pipeline.h"
#include "core/processing/result_spool.h"
#include "devices/live/live_queue.h"
#include "devices/live/published.h"

namespace noctule {

class PosePredictor;

/// The newest of everything, as of `sample`; about 60 a second.
struct LiveFrame {
    int64_t sample = 0;
    std::optional<TimedPose> pose;
    std::vector<std::optional<RangeMeasurement>> ranges;   ///< source * boards + board
    std::vector<std::optional<InertialReading>> readings;  ///< per board
    HealthReport health;
    double latency_median_s = 0, latency_p999_s = 0, latency_worst_s = 0;
    int64_t poses = 0;
    LiveQueue::Depth queue;
    std::optional<Error> trouble;  ///< nothing moves any more, and why
};

/// Called on the processor's thread whenever readings have come, with the newest pose of the filter carried
/// to their instant (PosePredictor), and when the newest of them came (std::chrono::steady_clock); returns at
/// once.
using PoseListener = std::function<void(const TimedPose&, int64_t arrived_ns)>;

struct LivePlan {
    Suit suit;
    Calibration calibration;
    Actor actor;
    PipelineSettings pipeline;
    double queue_s = 2;  ///< of sound that may wait
    PoseListener pose_listener = {};
};

class LiveProcessor {
public:
    /// Fails when the suit, its calibration and the actor do not fit. `spool`: keeps all results for the
    /// take.
    static Result<std::unique_ptr<LiveProcessor>> start(const LivePlan& plan,
                                                        std::optional<ResultSpool> spool);
    /// finish()
    ~LiveProcessor();

    /// From one thread at a time; never waits for the pipeline.
    void push(LiveItem item) { queue_.push(std::move(item)); }
    /// From any thread; never waits for the pipeline.
    std::shared_ptr<const LiveFrame> latest() const { return published_.get(); }
    /// Processes what still waits; waits for that. With `patience_s`: for so long, then the rest counts as
    /// dropped.
    void finish(std::optional<double> patience_s = {});
    /// After finish(): all results, if they were kept.
    std::optional<ResultSpool>& spool() { return spool_; }
    /// After finish(): when each foot stood.
    std::vector<FootContacts> contacts() const { return pipeline_->tracker().contacts(); }
    /// Why nothing can follow these poses: the last of them is none.
    static std::optional<Error> lossIn(const std::vector<TimedPose>& poses);

private:
    LiveProcessor(const LivePlan& plan, std::unique_ptr<LivePipeline> pipeline,
                  std::unique_ptr<PosePredictor> predictor, std::optional<ResultSpool> spool);
    void work();
    int64_t time_ns(int64_t sample) const;
    void handle(const ArrivedBlock& block);
    void handle(const std::vector<Pulse>& pulses);
    void handle(const GapRow& gap);
    void handle(const StatusRow& status);
    template <class Other>
    void handle(const Other&) {}
    void collect();
    void predict(const std::vector<InertialReading>& readings, const std::vector<TimedPose>& poses);
    /// The last sample of a frame with this instant.
    int64_t lastBit(int64_t time_ns) const;
    void measureLatency(const std::vector<TimedPose>& poses);
    void publish();
    void endWith(const Error& why);

    const int sample_rate_hz_;
    const size_t board_count_;
    std::unique_ptr<LivePipeline> pipeline_;
    std::optional<ResultSpool> spool_;
    const PoseListener pose_listener_;
    const std::unique_ptr<PosePredictor> predictor_;
    LiveQueue queue_;
    std::atomic<int64_t> give_up_at_ns_ = std::numeric_limits<int64_t>::max();
    Published<LiveFrame> published_;
    // Of the thread:
    HealthMonitor health_;
    LatencyHistogram latency_;
    LiveFrame frame_;
    int64_t publish_at_ = 0;
    struct Arrival {
        int64_t end_sample, arrived_ns;
    };
    std::deque<Arrival> arrivals_;
    int64_t predicted_ns_ = -1;  ///< instant of the pose that the listener got last
    int64_t latency_from_ns_;    ///< the poses of the rest come all at once when it is over
    bool caught_up_ = false;     ///< with a pre-roll, which keeps what follows waiting: that is no latency
    std::thread thread_;
};

}  // namespace noctule
