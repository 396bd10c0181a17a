// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_processor.h"

#include <algorithm>
#include <cmath>

#include "core/live/pose_predictor.h"
#include "core/motion/timed_poses.h"
#include "devices/machine/clock.h"

namespace noctule {
namespace {

constexpr auto kIdle = std::chrono::milliseconds(200);
constexpr int kFramesPublishedPerSecond = 60;
constexpr int64_t kAfterRest_ns = 500'000'000;
constexpr int kArrivalsKept_s = 2;

int64_t latencyFrom_ns(const LivePlan& plan) {
    const double rest_end_s = plan.pipeline.rest ? static_cast<double>(plan.pipeline.rest->second) /
                                                       plan.pipeline.decoder.train.sample_rate_hz
                                                 : 0;
    return std::llround(rest_end_s * 1e9) + kAfterRest_ns;
}

}  // namespace

Result<std::unique_ptr<LiveProcessor>> LiveProcessor::start(const LivePlan& plan,
                                                            std::optional<ResultSpool> spool) {
    auto pipeline = LivePipeline::create(plan.suit, plan.calibration, plan.actor, plan.pipeline);
    if (!pipeline)
        return pipeline.error();
    auto predictor = PosePredictor::create(plan.suit, plan.calibration, plan.actor,
                                           plan.pipeline.decoder.train.sample_rate_hz);
    if (!predictor)
        return predictor.error();
    return std::unique_ptr<LiveProcessor>(
        new LiveProcessor(plan, std::move(*pipeline), std::move(*predictor), std::move(spool)));
}

LiveProcessor::LiveProcessor(const LivePlan& plan, std::unique_ptr<LivePipeline> pipeline,
                             std::unique_ptr<PosePredictor> predictor, std::optional<ResultSpool> spool)
    : sample_rate_hz_(static_cast<int>(plan.pipeline.decoder.train.sample_rate_hz)),
      board_count_(plan.suit.boards.size()),
      pipeline_(std::move(pipeline)),
      spool_(std::move(spool)),
      pose_listener_(plan.pose_listener),
      predictor_(std::move(predictor)),
      queue_(static_cast<int64_t>(plan.queue_s * sample_rate_hz_), LiveQueue::WhenFull::kNewestStays),
      health_(plan.suit, sample_rate_hz_),
      latency_from_ns_(latencyFrom_ns(plan)) {
    frame_.ranges.resize(board_count_ * plan.suit.sources.size());
    frame_.readings.resize(board_count_);
    thread_ = std::thread([this] { work(); });
}

LiveProcessor::~LiveProcessor() {
    finish();
}

void LiveProcessor::finish(std::optional<double> patience_s) {
    if (patience_s)
        give_up_at_ns_ = steadyNow_ns() + std::llround(*patience_s * 1e9);
    queue_.close();
    if (thread_.joinable())
        thread_.join();
}

void LiveProcessor::work() {
    try {
        while (!queue_.drained()) {
            if (steadyNow_ns() > give_up_at_ns_)
                queue_.abandon();
            if (const auto item = queue_.pop(std::chrono::steady_clock::now() + kIdle))
                std::visit([this](const auto& one) { handle(one); }, *item);
        }
        pipeline_->finish();
        collect();
        publish();
    } catch (const std::exception& mistake) {
        endWith({ErrorKind::kInternal,
                 "processing has ended by a mistake of this program (" + std::string(mistake.what()) + ")",
                 "What is recorded is complete; process the take, and report the mistake"});
    }
}

/// The recording goes on.
void LiveProcessor::endWith(const Error& why) {
    queue_.abandon();
    spool_.reset();
    frame_.trouble = why;
    published_.set(frame_);
}

int64_t LiveProcessor::time_ns(int64_t sample) const {
    return std::llround(static_cast<double>(sample) * 1e9 / sample_rate_hz_);
}

void LiveProcessor::handle(const ArrivedBlock& block) {
    if (!caught_up_ && queue_.depth().samples == 0) {
        caught_up_ = true;
        latency_from_ns_ = std::max(latency_from_ns_, time_ns(block.endSample()));
    }
    arrivals_.push_back({block.endSample(), block.arrived_ns});
    health_.addBlock(block.firstSample(), block.sound->values);
    pipeline_->pushBlock(block.firstSample(), block.sound->values);
    frame_.sample = block.endSample();
    collect();
    if (frame_.sample >= publish_at_) {
        publish();
        publish_at_ = frame_.sample + sample_rate_hz_ / kFramesPublishedPerSecond;
    }
}

void LiveProcessor::handle(const std::vector<Pulse>& pulses) {
    for (const Pulse& pulse : pulses)
        pipeline_->pushPulse(pulse);
}

void LiveProcessor::handle(const GapRow& gap) {
    pipeline_->pushGap(gap.first_sample, gap.sample_count, gap.board);
}

void LiveProcessor::handle(const StatusRow& status) {
    pipeline_->pushStatus({status.sample, status.temperature_c, status.humidity_percent});
    health_.add(SuitStatus{status.sample, status.temperature_c, status.humidity_percent, status.battery_v,
                           status.battery_percent});
}

std::optional<Error> LiveProcessor::lossIn(const std::vector<TimedPose>& poses) {
    if (poses.empty() || (poses.back().pose && isUsable(*poses.back().pose)))
        return {};
    return Error{ErrorKind::kUnusable, "the live estimate was lost: the data contradict each other",
                 "Disconnect the suit and connect it again; check its calibration. What is recorded is "
                 "complete"};
}

void LiveProcessor::collect() {
    const std::vector<InertialReading> readings = pipeline_->takeReadings();
    const std::vector<RangeMeasurement> ranges = pipeline_->takeRanges();
    const std::vector<TimedPose> poses = pipeline_->takePoses();
    if (const auto loss = lossIn(poses))
        return endWith(*loss);
    measureLatency(poses);
    if (pose_listener_)
        predict(readings, poses);
    for (const InertialReading& reading : readings) {
        health_.add(reading);
        frame_.readings[static_cast<size_t>(reading.board)] = reading;
    }
    for (const RangeMeasurement& range : ranges) {
        health_.add(range);
        frame_.ranges[static_cast<size_t>(range.source) * board_count_ + static_cast<size_t>(range.board)] =
            range;
    }
    if (!poses.empty())
        frame_.pose = poses.back();
    frame_.poses += std::ssize(poses);
    if (spool_) {
        spool_->add(readings);
        spool_->add(ranges);
        spool_->add(poses);
    }
}

void LiveProcessor::predict(const std::vector<InertialReading>& readings,
                            const std::vector<TimedPose>& poses) {
    for (const InertialReading& reading : readings)
        predictor_->add(reading);
    for (const TimedPose& pose : poses)
        predictor_->add(pose);
    const auto predicted = predictor_->predict();
    if (!predicted || predicted->time_ns <= predicted_ns_)
        return;
    predicted_ns_ = predicted->time_ns;
    const int64_t last_bit = lastBit(predicted_ns_);
    const auto arrival =
        std::ranges::find_if(arrivals_, [&](const Arrival& one) { return one.end_sample > last_bit; });
    pose_listener_(*predicted, arrival != arrivals_.end() ? arrival->arrived_ns : steadyNow_ns());
}

int64_t LiveProcessor::lastBit(int64_t time_ns) const {
    const double instant = static_cast<double>(time_ns) * 1e-9 * sample_rate_hz_;
    return std::llround(instant + static_cast<double>(sample_rate_hz_) / kInertialFramesPerSecond);
}

void LiveProcessor::measureLatency(const std::vector<TimedPose>& poses) {
    const int64_t now_ns = steadyNow_ns();
    for (const TimedPose& timed : poses) {
        if (!caught_up_ || timed.time_ns < latency_from_ns_)
            continue;
        const int64_t last_bit = lastBit(timed.time_ns);
        while (arrivals_.size() > 1 && arrivals_.front().end_sample <= last_bit)
            arrivals_.pop_front();
        if (!arrivals_.empty() && arrivals_.front().end_sample > last_bit)
            latency_.add(now_ns - arrivals_.front().arrived_ns);
    }
    while (!arrivals_.empty() &&
           arrivals_.front().end_sample < frame_.sample - int64_t{kArrivalsKept_s} * sample_rate_hz_)
        arrivals_.pop_front();
}

void LiveProcessor::publish() {
    frame_.health = health_.report();
    frame_.latency_median_s = latency_.quantile_s(0.5);
    frame_.latency_p999_s = latency_.quantile_s(0.999);
    frame_.latency_worst_s = static_cast<double>(latency_.worst_ns()) * 1e-9;
    frame_.queue = queue_.depth();
    published_.set(frame_);
}

}  // namespace noctule
