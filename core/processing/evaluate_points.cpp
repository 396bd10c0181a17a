// SPDX-License-Identifier: Apache-2.0
#include "core/processing/evaluate_points.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/body/text.h"
#include "core/processing/cross_clocks.h"
#include "core/report/html.h"
#include "core/report/svg_plot.h"

namespace noctule {
namespace {

constexpr double kTouching_m = 0.3;

/// A device on the reference's skeleton.
struct TrueDevice {
    std::string subject, device;
    int suit = 0, joint = -1;
    Vector3d p_joint_m = Vector3d::Zero();
    const PointTrack* track = nullptr;
};

struct TrueSubject {
    std::string name;
    int suit = 0;
    TimedMotion reference;
    double from_s = 0;  ///< after the rest pose
};

class PointsJudge {
public:
    PointsJudge(const Take& take, const PointsTable& table) : take_(take), table_(table) {}

    Status read() {
        const auto subjects = take_.subjects();
        if (!subjects)
            return subjects.error();
        has_anchors_ = std::ranges::any_of(*subjects, &TakeSubject::room);
        for (const TakeSubject& subject : *subjects) {
            const bool is_in_table = std::ranges::any_of(
                table_, [&](const auto& entry) { return entry.first.first == subject.suit(); });
            if (subject.room || !is_in_table)
                continue;
            if (Status read = readSubject(subject); !read)
                return read;
        }
        for (const auto& entry : table_)
            if (std::ranges::none_of(devices_, [&](const TrueDevice& device) {
                    return std::pair(device.suit, device.device) == entry.first;
                }))
                return Error{ErrorKind::kUnusable,
                             take_.path() + ": the table's point '" + entry.first.second + "' of suit " +
                                 std::to_string(entry.first.first) + " is no device of this take",
                             "Choose the table that was made of this take"};
        return Done{};
    }

    PointsEvaluation judge() {
        std::vector<PoseSampler> samplers;
        for (const TrueSubject& subject : subjects_)
            samplers.emplace_back(subject.reference, bridgeableGap_ns(subject.reference));
        const std::vector<double>& times = devices_.front().track->time_s;
        double from_s = 0;
        for (const TrueSubject& subject : subjects_)
            from_s = std::max(from_s, subject.from_s);
        squares_.assign(devices_.size(), 0);
        for (size_t k = 0; k < times.size(); ++k)
            if (times[k] >= from_s)
                judgeInstant(k, times[k], samplers);
        return finish();
    }

private:
    Status readSubject(const TakeSubject& subject) {
        auto reference = take_.reference(subject.suit());
        if (!reference)
            return reference.error();
        if (reference->frames.empty())
            return Error{
                ErrorKind::kUnusable,
                take_.path() + ": there is no reference of " + subject.name + ", points cannot be judged",
                "Attach one with `noctule --batch attach`"};
        const auto suit = take_.suit(subject.suit());
        if (!suit)
            return suit.error();
        auto stored = take_.calibrationInForce(subject.suit());
        const Calibration calibration = stored ? std::move(stored->value) : nominalCalibration(*suit);
        for (const Board& board : suit->boards) {
            const BoardCalibration* of = calibration.findBoard(board.id);
            const Vector3d p = of && of->p_segment_board_m ? *of->p_segment_board_m : board.p_segment_board_m;
            const Quaterniond q = of && of->q_segment_board ? *of->q_segment_board : board.q_segment_board;
            add(subject, reference->skeleton, board.id, board.segment, p + q * board.p_board_mic_m);
        }
        for (const Source& source : suit->sources)
            if (source.board.empty()) {
                const SourceCalibration* of = calibration.findSource(source.id);
                add(subject, reference->skeleton, source.id, source.segment,
                    of && of->p_segment_source_m ? *of->p_segment_source_m : source.p_segment_source_m);
            }
        TrueSubject judged{subject.name, subject.suit(), std::move(*reference), 0};
        const auto rest = take_.restInterval(subject.suit());
        if (!rest)
            return rest.error();
        if (*rest)
            judged.from_s =
                take_.suitClock(subject.suit())
                    .takeTime_s(static_cast<double>((*rest)->last) / sampleRateOf(take_, subject.suit()));
        subjects_.push_back(std::move(judged));
        return Done{};
    }

    void add(const TakeSubject& subject, const Skeleton& skeleton, const std::string& device,
             const std::string& segment, const Vector3d& p) {
        const auto track = table_.find({subject.suit(), device});
        const int joint = skeleton.find(segment);
        if (track != table_.end() && joint >= 0)
            devices_.push_back({subject.name, device, subject.suit(), joint, p, &track->second});
    }

    void judgeInstant(size_t k, double time_s, std::vector<PoseSampler>& samplers) {
        std::vector<std::optional<GlobalPose>> poses;
        for (size_t s = 0; s < subjects_.size(); ++s) {
            const auto pose = samplers[s].at(std::llround(time_s * 1e9));
            if (!pose)
                return;
            poses.push_back(globalPose(subjects_[s].reference.skeleton, *pose));
        }
        std::vector<Vector3d> truth_m, found_m;
        double error2 = 0, sigma2 = 0;
        for (const TrueDevice& device : devices_) {
            if (k >= device.track->time_s.size() || std::abs(device.track->time_s[k] - time_s) > 1e-6)
                return;
            const auto of = std::ranges::find(subjects_, device.suit, &TrueSubject::suit);
            const GlobalPose& pose = *poses[static_cast<size_t>(of - subjects_.begin())];
            const auto joint = static_cast<size_t>(device.joint);
            truth_m.push_back(pose.p_world_joint[joint] + pose.q_world_joint[joint] * device.p_joint_m);
            found_m.push_back(device.track->p_m[k]);
        }
        for (size_t d = 0; d < devices_.size(); ++d) {
            const double square = (found_m[d] - truth_m[d]).squaredNorm();
            const double sigma = std::max(devices_[d].track->sigma_m[k], 1e-6);
            squares_[d] += square;
            error2 += square;
            sigma2 += 3 * sigma * sigma;
            nees_ += square / (3 * sigma * sigma);
        }
        judgePairs(truth_m, found_m);
        const auto count = static_cast<double>(devices_.size());
        found_.time_s.push_back(time_s);
        found_.error_m.push_back(std::sqrt(error2 / count));
        found_.sigma_m.push_back(std::sqrt(sigma2 / count));
        found_.instants += 1;
    }

    void judgePairs(const std::vector<Vector3d>& truth_m, const std::vector<Vector3d>& found_m) {
        double nearest_m = NAN, nearest_error_m = NAN;
        for (size_t a = 0; a < devices_.size(); ++a)
            for (size_t b = a + 1; b < devices_.size(); ++b) {
                if (devices_[a].suit == devices_[b].suit)
                    continue;
                const Vector3d truth = truth_m[b] - truth_m[a];
                const double square = (found_m[b] - found_m[a] - truth).squaredNorm();
                pair_squares_ += square, ++pairs_;
                if (truth.norm() < kTouching_m)
                    near_squares_ += square, ++near_;
                if (!(truth.norm() >= nearest_m))
                    nearest_m = truth.norm(), nearest_error_m = std::sqrt(square);
            }
        found_.nearest_m.push_back(nearest_m);
        found_.nearest_error_m.push_back(nearest_error_m);
    }

    PointsEvaluation finish() {
        const auto rms_mm = [](double squares, int64_t count) {
            return 1000 * std::sqrt(squares / static_cast<double>(std::max<int64_t>(1, count)));
        };
        double all = 0;
        for (size_t d = 0; d < devices_.size(); ++d) {
            found_.points.push_back(
                {devices_[d].subject, devices_[d].device, rms_mm(squares_[d], found_.instants)});
            all += squares_[d];
        }
        const int64_t count = found_.instants * std::ssize(devices_);
        found_.rms_mm = rms_mm(all, count);
        if (has_anchors_)
            found_.nees = nees_ / static_cast<double>(std::max<int64_t>(1, count));
        if (pairs_ > 0)
            found_.between_rms_mm = rms_mm(pair_squares_, pairs_);
        if (near_ > 0)
            found_.between_near_rms_mm = rms_mm(near_squares_, near_);
        return std::move(found_);
    }

    const Take& take_;
    const PointsTable& table_;
    bool has_anchors_ = false;
    std::vector<TrueSubject> subjects_;
    std::vector<TrueDevice> devices_;
    PointsEvaluation found_;
    std::vector<double> squares_;
    double nees_ = 0, pair_squares_ = 0, near_squares_ = 0;
    int64_t pairs_ = 0, near_ = 0;
};

std::string plotOf(const std::string& title, const std::string& description,
                   const std::vector<std::string>& names, const std::vector<PointsEvaluation>& evaluations,
                   const std::vector<std::vector<double>>& values_mm) {
    LinePlot plot;
    plot.title = title;
    plot.description = description;
    plot.time_s = {evaluations.front().time_s.front(), evaluations.front().time_s.back()};
    plot.unit = " mm";
    plot.height_px = 220;
    std::vector<std::span<const double>> all;
    for (size_t i = 0; i < evaluations.size(); ++i) {
        all.emplace_back(values_mm[i]);
        plot.curves.push_back({evaluations[i].time_s, values_mm[i], "run" + std::to_string(i % 6), names[i]});
    }
    plot.values = niceInterval(all, 1);
    plot.values.min = 0;
    return svg(plot);
}

}  // namespace

Result<PointsEvaluation> evaluatePoints(const std::string& take_path, const PointsTable& table,
                                        const JobContext& job) {
    const auto take = Take::open(take_path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    PointsJudge judge(*take, table);
    if (Status read = judge.read(); !read)
        return read.error();
    PointsEvaluation found = judge.judge();
    if (found.instants == 0)
        return Error{ErrorKind::kUnusable,
                     take_path + ": no instant of the table has a reference after the rest pose",
                     "Choose the table that was made of this take"};
    return found;
}

std::string pointsReport(const std::string& take_name, const std::vector<std::string>& names,
                         const std::vector<PointsEvaluation>& evaluations) {
    const auto inMillimetres = [](std::vector<double> values) {
        for (double& value : values)
            value *= 1000;
        return values;
    };
    html::Table table{
        "Points", {{"table", false}, {"all points, mm"}, {"between, mm"}, {"near, mm"}, {"NEES"}}, {}};
    std::vector<std::vector<double>> errors, sigmas, nearest, nearest_errors;
    const auto cell = [](std::optional<double> value) {
        char text[32] = "unknown";
        if (value)
            std::snprintf(text, sizeof text, "%.2f", *value);
        return std::string(text);
    };
    for (size_t i = 0; i < evaluations.size(); ++i) {
        const PointsEvaluation& one = evaluations[i];
        table.rows.push_back(
            {{text::escaped(names[i]), cell(one.rms_mm), cell(one.between_rms_mm),
              cell(one.between_near_rms_mm), one.nees ? cell(one.nees) : std::string("not observed")},
             ""});
        errors.push_back(inMillimetres(one.error_m));
        sigmas.push_back(inMillimetres(one.sigma_m));
        nearest.push_back(inMillimetres(one.nearest_m));
        nearest_errors.push_back(inMillimetres(one.nearest_error_m));
    }
    std::string body = html::section("points", "Points", "Error after the rest poses, root mean square.",
                                     html::table(table));
    const bool is_observed =
        std::ranges::all_of(evaluations, [](const PointsEvaluation& one) { return one.nees.has_value(); });
    if (!is_observed)
        body += html::note(
            "Without anchors nothing measures the common place and turn of all points: they are those of the "
            "start, drift, and count in the error of all points. How sure the filter is of them means "
            "nothing.");
    body += html::section(
        "error", "Error over time", "Root mean square over all points, as figure 3 of Welch 2018.",
        "<div class=\"scroll\">" +
            plotOf("Error of all points", "rms error of all points over time", names, evaluations, errors) +
            (is_observed
                 ? plotOf("Stated uncertainty of all points",
                          "square root of the mean trace of the covariances", names, evaluations, sigmas)
                 : "") +
            "</div>");
    body += html::section(
        "nearest", "Two people near each other",
        "The nearest two points of different people: distance, and error of the vector between them, as "
        "figure 4 of Welch 2018.",
        "<div class=\"scroll\">" +
            plotOf("Distance of the nearest two points", "true distance of the nearest two points",
                   {names[0]}, {evaluations[0]}, {nearest[0]}) +
            plotOf("Error of the vector between them", "length of the vector's error", names, evaluations,
                   nearest_errors) +
            "</div>");
    return html::page(take_name, "Points report", "", body, "");
}

}  // namespace noctule
