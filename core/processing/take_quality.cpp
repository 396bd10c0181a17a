// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_quality.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <unordered_map>

#include "core/inertial/frame_layout.h"

namespace noctule {
namespace {

/// An axis is first known after its first refresh: no reading is owed before each had one.
constexpr int64_t kJoiningFrames = kCounterPeriod;
/// A board whose readings begin or end within this of the take's ends was there all the time.
constexpr double kWithTheTake_s = 1;

void count(const InertialReading& reading, const BoardCalibration* known, ReportBoard& board) {
    board.frames_lost += reading.corrected_bits ? 0 : 1;
    board.corrected_bits += reading.corrected_bits.value_or(0);
    if (reading.frame < kJoiningFrames)
        return;
    for (size_t i = 0; i < reading.counts.size(); ++i)
        if (const std::optional<double>& counts = reading.counts[i]) {
            ++board.readings_present;
            const bool of_counts = !known || (i < 3 ? known->gyro : known->accel).isOfCounts();
            const bool clipped = of_counts && (*counts == kCountsMin || *counts == kCountsMax);
            (i < 3 ? board.clipped_gyro : board.clipped_accel) += clipped;
        }
}

constexpr unsigned kAllAxes = 0b111111;

/// Axes that were read, one bit each.
unsigned axesOf(const InertialReading& reading) {
    unsigned axes = 0;
    for (size_t i = 0; i < reading.counts.size(); ++i)
        axes |= reading.counts[i] ? 1U << i : 0U;
    return axes;
}

/// From when to when there were readings, in samples.
struct ReadSpan {
    double begin = std::numeric_limits<double>::infinity(), end = 0;
    void add(double sample) {
        begin = std::min(begin, sample);
        end = std::max(end, sample);
    }
};

/// The rows of one board. A frame that refreshes an axis has no room for its partner
/// (core/inertial/README.md section 4): a single axis missing between two whole frames is not owed.
struct BoardRows {
    int64_t rows = 0, first_frame = 0, last_frame = -1, not_sent = 0;
    unsigned before_last = 0, last = 0;  ///< axes of the last two frames
    ReadSpan span;
    std::vector<double> steps;  ///< samples per frame, at the beginning

    void add(const InertialReading& reading) {
        const unsigned axes = axesOf(reading);
        const bool follows = reading.frame == last_frame + 1;
        if (follows && reading.frame > kJoiningFrames && before_last == kAllAxes && axes == kAllAxes)
            not_sent += std::popcount(last) == 5 ? 1 : 0;
        if (rows == 0)
            first_frame = reading.frame;
        else if (steps.size() < kSteps && reading.frame > last_frame)
            steps.push_back((reading.sample - span.end) / static_cast<double>(reading.frame - last_frame));
        before_last = follows ? last : 0;
        last = axes;
        last_frame = reading.frame;
        span.add(reading.sample);
        ++rows;
    }

    /// Samples from one frame to the next: the usual ones, else `nominal`.
    double step(double nominal) {
        if (steps.empty())
            return nominal;
        const auto middle = steps.begin() + std::ssize(steps) / 2;
        std::ranges::nth_element(steps, middle);
        return *middle > 0 ? *middle : nominal;
    }

    static constexpr size_t kSteps = 2000;
};

/// Boards begin their frames at times of their own: what is less than a frame is none.
int64_t wholeFrames(double samples, double step) {
    constexpr double kRounding = 0.01;
    return static_cast<int64_t>(samples / step + kRounding);
}

/// What a board owes beside its rows; `all` is the span of all boards.
void judgeFrames(BoardRows rows, const ReadSpan& all, double nominal_step, ReportBoard& board, int axes) {
    if (rows.rows == 0) {
        board.frames_expected = board.frames_lost =
            all.end > all.begin ? wholeFrames(all.end - all.begin, nominal_step) + 1 : 0;
        board.readings_expected = axes * std::max<int64_t>(0, board.frames_expected - kJoiningFrames);
        return;
    }
    const double step = rows.step(nominal_step);
    int64_t before = wholeFrames(rows.span.begin - all.begin, step);
    if (rows.first_frame == 0 && before == 1)
        before = 0;
    const int64_t after = wholeFrames(all.end - rows.span.end, step);
    const int64_t within = std::max(rows.last_frame - rows.first_frame + 1, rows.rows);
    const int64_t cut = after == 1 ? 0 : after;  // the end of a take cuts the last frame of some
    board.frames_expected = before + within + cut;
    board.frames_lost += board.frames_expected - rows.rows;
    const int64_t not_known =
        std::max<int64_t>(0, kJoiningFrames - std::max<int64_t>(0, rows.first_frame - before));
    board.readings_expected = axes * std::max<int64_t>(0, board.frames_expected - not_known) - rows.not_sent;
    board.frames_absent = (board.joined_s ? before : 0) + (board.left_s ? cut : 0);
}

PulseFate fateOf(RangeFate fate) {
    switch (fate) {
        case RangeFate::kUsed:
        case RangeFate::kWeighted:
            return PulseFate::kUsed;
        case RangeFate::kGated:
            return PulseFate::kRejected;
        case RangeFate::kNotTried:
        case RangeFate::kBehindSource:
        case RangeFate::kNoConfidence:
            break;
    }
    return PulseFate::kUnused;
}

/// All pulses of a take at all boards, one after the other.
class PulseGrid {
public:
    PulseGrid(std::vector<Pulse> pulses, const Suit& suit, const SuitClock& clock, double sample_rate_hz)
        : pulses_(std::move(pulses)),
          suit_(suit),
          clock_(clock),
          sample_rate_hz_(sample_rate_hz),
          at_boards_(pulses_.size() * suit.boards.size()) {
        for (size_t p = 0; p < pulses_.size(); ++p) {
            place_[pulses_[p].id] = p;
            for (size_t b = 0; b < suit.boards.size(); ++b)
                at(p, b).time_s = static_cast<float>(time_s(p));
        }
    }

    void add(const RangeMeasurement& range) {
        const auto place = place_.find(range.pulse);
        if (place == place_.end())
            return;
        PulseAtBoard& pulse = at(place->second, static_cast<size_t>(range.board));
        pulse.fate = fateOf(range.fate);
        pulse.confidence = static_cast<float>(range.confidence());
        pulse.distance_m = static_cast<float>(range.distance_m);
        if (pulse.fate == PulseFate::kUsed || pulse.fate == PulseFate::kRejected)
            pulse.residual_m = static_cast<float>(range.innovation_m);
    }

    /// What was missing and could not be heard: where the poses before and after are near enough.
    Status explain(const PoseSource& motion, LineOfSight& sight, const JobContext& job) {
        const auto time_ns = [&](size_t pulse) { return std::llround(time_s(pulse) * 1e9); };
        constexpr int64_t kNear_ns = 200'000'000;  // runs of other programs may hold ten poses a second
        TimedMotion latest{motion.skeleton, {}};   // the last two that were seen
        size_t p = 0;
        const Status walked = motion.forEach([&](TimedPose&& frame) {
            if (!frame.pose || !isUsable(*frame.pose))
                return !job.cancelled();
            latest.frames.push_back(std::move(frame));
            if (latest.frames.size() > 2)
                latest.frames.erase(latest.frames.begin());
            for (; p < pulses_.size() && time_ns(p) <= latest.frames.back().time_ns; ++p)
                if (const auto pose = poseAt(latest, time_ns(p), kNear_ns)) {
                    sight.setPose(*pose);
                    explainPulse(p, sight);
                }
            return !job.cancelled();
        });
        return job.cancelled() ? JobContext::cancelledError() : walked;
    }

    std::vector<ReportPair> pairs() {
        const size_t boards = suit_.boards.size();
        std::vector<size_t> sent(suit_.sources.size());
        for (const Pulse& pulse : pulses_)
            ++sent[static_cast<size_t>(pulse.source)];
        std::vector<ReportPair> pairs;
        for (size_t s = 0; s < suit_.sources.size(); ++s)
            for (size_t b = 0; b < boards; ++b) {
                pairs.push_back({static_cast<int>(s), static_cast<int>(b), {}});
                pairs.back().pulses.reserve(sent[s]);
            }
        for (size_t p = 0; p < pulses_.size(); ++p)
            for (size_t b = 0; b < boards; ++b)
                pairs[static_cast<size_t>(pulses_[p].source) * boards + b].pulses.push_back(at(p, b));
        return pairs;
    }

private:
    /// On the take's clock, as poses and references are.
    double time_s(size_t pulse) const {
        return clock_.takeTime_s(static_cast<double>(pulses_[pulse].sample) / sample_rate_hz_);
    }
    void explainPulse(size_t pulse, const LineOfSight& sight) {
        for (size_t b = 0; b < suit_.boards.size(); ++b)
            if (at(pulse, b).fate == PulseFate::kMissing &&
                sight.isBlocked(pulses_[pulse].source, static_cast<int>(b)))
                at(pulse, b).fate = PulseFate::kOccluded;
    }
    PulseAtBoard& at(size_t pulse, size_t board) { return at_boards_[pulse * suit_.boards.size() + board]; }

    std::vector<Pulse> pulses_;
    const Suit& suit_;
    SuitClock clock_;
    double sample_rate_hz_;
    std::vector<PulseAtBoard> at_boards_;
    std::unordered_map<int64_t, size_t> place_;
};

/// A pulse whose interval the recording does not hold to its end cannot be heard.
Result<std::vector<Pulse>> wholePulses(const Take& take) {
    auto pulses = take.pulses();
    if (!pulses)
        return pulses.error();
    const auto end = take.sampleCount();
    if (!end)
        return end.error();
    if (*end > 0)
        std::erase_if(*pulses, [&](const Pulse& pulse) {
            return pulse.sample + take.header().pulse_interval_samples > *end;
        });
    return pulses;
}

}  // namespace

Result<std::vector<ReportBoard>> boardQuality(const Take& take, const Suit& suit,
                                              const Calibration& calibration, int64_t inertial_run) {
    std::vector<ReportBoard> boards;
    std::vector<const BoardCalibration*> known;
    for (const Board& board : suit.boards) {
        boards.push_back({board.id, board.segment});
        known.push_back(calibration.findBoard(board.id));
    }
    auto readings = take.readings(inertial_run);
    if (!readings)
        return readings.error();
    ReadSpan all;
    std::vector<BoardRows> rows(boards.size());
    bool has_gyroscopes = false, has_accelerometers = false;  // of other makers' sensors one may lack
    while (true) {
        const auto reading = readings->next();
        if (!reading)
            return reading.error();
        if (!*reading)
            break;
        const auto board = static_cast<size_t>((*reading)->board);
        rows[board].add(**reading);
        all.add((*reading)->sample);
        count(**reading, known[board], boards[board]);
        has_gyroscopes = has_gyroscopes || (*reading)->counts[0];
        has_accelerometers = has_accelerometers || (*reading)->counts[3];
    }
    const bool lacks_one = take.level() == TakeLevel::kReadings && has_gyroscopes != has_accelerometers;
    const int axes = lacks_one ? 3 : 6;
    const double rate_hz = static_cast<double>(take.header().sample_rate_hz);
    const auto samples = take.sampleCount();
    const double end = std::max(all.end, samples ? static_cast<double>(*samples) : 0);
    for (size_t b = 0; b < boards.size(); ++b) {
        const auto takeTime_s = [&](double sample) { return take.suitClock().takeTime_s(sample / rate_hz); };
        if (rows[b].rows > 0 && rows[b].span.begin > kWithTheTake_s * rate_hz)
            boards[b].joined_s = takeTime_s(rows[b].span.begin);
        if (rows[b].rows > 0 && end - rows[b].span.end > kWithTheTake_s * rate_hz)
            boards[b].left_s = takeTime_s(rows[b].span.end);
        judgeFrames(std::move(rows[b]), all, rate_hz / suit.boards[b].rate_hz, boards[b], axes);
    }
    return boards;
}

Result<std::vector<ReportPair>> pairQuality(const Take& take, const Suit& suit,
                                            std::optional<int64_t> range_run, const PoseSource* motion,
                                            LineOfSight* sight, const JobContext& job) {
    auto pulses = wholePulses(take);
    if (!pulses)
        return pulses.error();
    const auto rate = take.sampleRate_hz();
    if (!rate)
        return rate.error();
    PulseGrid grid(std::move(*pulses), suit, take.suitClock(), static_cast<double>(*rate));
    if (range_run) {
        auto ranges = take.ranges(*range_run);
        if (!ranges)
            return ranges.error();
        while (true) {
            const auto range = ranges->next();
            if (!range)
                return range.error();
            if (!*range)
                break;
            grid.add(**range);
        }
    }
    if (motion && sight)
        if (Status done = grid.explain(*motion, *sight, job); !done)
            return done.error();
    return grid.pairs();
}

}  // namespace noctule
