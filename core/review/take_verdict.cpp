// SPDX-License-Identifier: Apache-2.0
#include "core/review/take_verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/angle_collector.h"
#include "core/report/joint_support.h"
#include "core/report/range_statistics.h"

namespace noctule {
namespace {

/// Good up to one limit, usable up to the other; what is not a number is not usable.
TakeGrade gradeOf(double value, double good, double usable) {
    if (value <= good)
        return TakeGrade::kGood;
    return value <= usable ? TakeGrade::kUsable : TakeGrade::kNotUsable;
}

class Judge {
public:
    Judge(const ReportData& report, const TakeOverview& overview, const VerdictLimits& limits)
        : report_(report), overview_(overview), limits_(limits), run_(report.shownRun()) {
        if (run_ && run_->comparison)
            comparison_ = &*run_->comparison;
    }

    TakeVerdict judge() {
        if (!run_) {
            charge(VerdictReason::kNoPoses, TakeGrade::kNotUsable);
            return sorted();
        }
        judgeError();
        listJoints();
        judgeCalibration();
        judgeSupport();
        judgeResidual();
        judgeBoards();
        judgeHoles();
        return sorted();
    }

private:
    struct Charge {
        VerdictReason reason;
        TakeGrade grade;
    };

    void charge(VerdictReason reason, TakeGrade grade) {
        if (grade != TakeGrade::kGood)
            charges_.push_back({reason, grade});
    }

    TakeVerdict sorted() {
        std::stable_sort(charges_.begin(), charges_.end(),
                         [](const Charge& a, const Charge& b) { return a.grade > b.grade; });
        for (const Charge& charge : charges_) {
            verdict_.reasons.push_back(charge.reason);
            verdict_.grade = std::max(verdict_.grade, charge.grade);
        }
        return std::move(verdict_);
    }

    void judgeError() {
        if (!comparison_)
            return;
        verdict_.mean_error_deg = comparison_->mean_deg;
        charge(VerdictReason::kMeanError,
               gradeOf(comparison_->mean_deg, limits_.good_mean_deg, limits_.usable_mean_deg));
        const auto worst = std::max_element(comparison_->joints.begin(), comparison_->joints.end(),
                                            [](const JointComparison& a, const JointComparison& b) {
                                                return a.angle.mean_deg < b.angle.mean_deg;
                                            });
        if (worst != comparison_->joints.end() && worst->angle.mean_deg > limits_.good_joint_deg) {
            verdict_.worst_joint = worst->name;
            charge(VerdictReason::kJointError, TakeGrade::kUsable);
        }
        AngleCollector yaw;
        for (size_t i = 0; i < comparison_->time_s.size(); ++i)
            yaw.add(comparison_->time_s[i] - comparison_->time_s.front(),
                    comparison_->root.yaw_curve_deg[i] * std::numbers::pi / 180);
        if (comparison_->duration_s >= kLeastDrift_s)
            verdict_.yaw_drift_deg_per_min = yaw.statistics().drift_deg_per_min;
    }

    void listJoints() {
        for (const JointSupport& support : report_.support) {
            VerdictJoint joint{support.joint, {}, {}, support.ranges, support.inertia, TakeGrade::kGood};
            if (const auto* compared = comparison_ ? comparison_->find(support.joint) : nullptr) {
                joint.mean_deg = compared->angle.mean_deg;
                joint.worst_deg = compared->angle.max_deg;
            }
            if (joint.mean_deg)
                joint.grade =
                    *joint.mean_deg <= limits_.good_joint_deg ? TakeGrade::kGood : TakeGrade::kUsable;
            else if (joint.backed_by_ranges < limits_.backed_after)
                joint.grade = TakeGrade::kUsable;
            verdict_.joints.push_back(std::move(joint));
        }
    }

    /// With a reference the error is known, and a missing calibration only explains it.
    void judgeCalibration() {
        verdict_.lack = report_.lack;
        const Grade grade = gradeOf(report_.lack, run_->sensors);
        is_uncalibrated_ = grade == Grade::kNotUsable;
        if (grade == Grade::kGood || (comparison_ && charges_.empty()))
            return;
        charge(VerdictReason::kNotCalibrated,
               is_uncalibrated_ && !comparison_ ? TakeGrade::kNotUsable : TakeGrade::kUsable);
    }

    void judgeSupport() {
        if (verdict_.joints.empty())
            return;
        double sum = 0, most_alone = 0;
        for (const JointSupport& support : report_.support) {
            sum += support.ranges;
            most_alone = std::max(most_alone, support.alone());
        }
        verdict_.backed_share = sum / static_cast<double>(report_.support.size());
        if (comparison_ || is_uncalibrated_)
            return;
        TakeGrade grade = gradeOf(most_alone, limits_.good_alone, limits_.usable_alone);
        if (run_->sensors.find('D') == std::string::npos)
            grade =
                std::max(grade, TakeGrade::kUsable);  // nothing stops the drift; how far it goes is unknown
        else
            grade = std::max(grade,
                             gradeOf(-verdict_.backed_share, -limits_.good_backed, -limits_.usable_backed));
        if (findLessCertainJoint())
            grade = std::max(grade, TakeGrade::kUsable);
        charge(VerdictReason::kSupport, grade);
    }

    /// The joint that ranges stopped backing most clearly.
    bool findLessCertainJoint() {
        if (!overview_.actor)
            return false;
        double largest_drop = 0;
        for (const JointSupport& support : report_.support) {
            const Change change = changeOf(support.joint);
            if (change.drop <= largest_drop)
                continue;
            largest_drop = change.drop;
            verdict_.worst_joint = support.joint;
            verdict_.worst_from_s = change.from_s;
        }
        return largest_drop > 0;
    }

    struct Change {
        double drop = 0, from_s = 0;
    };

    /// The time after the rest that parts the take into a backed and an unbacked half most clearly; no drop
    /// when there is no such time.
    Change changeOf(const std::string& joint) const {
        const Skeleton& skeleton = overview_.actor->skeleton;
        const std::vector<bool> covered = rangeCoverage(skeleton, overview_.suit, report_.pairs,
                                                        skeleton.find(joint), report_.take.duration_s);
        const auto begin = static_cast<size_t>(std::max(0.0, report_.take.rest_s) / kCoverageStep_s);
        const auto least = static_cast<size_t>(kLeastHalf_s / kCoverageStep_s);
        Change change;
        if (covered.size() < begin + 2 * least)
            return change;
        const auto total =
            std::count(covered.begin() + static_cast<std::ptrdiff_t>(begin), covered.end(), true);
        int64_t before = 0;
        for (size_t i = begin; i + least <= covered.size(); before += covered[i++]) {
            if (i < begin + least)
                continue;
            const double share = static_cast<double>(before) / static_cast<double>(i - begin);
            const double rest = static_cast<double>(total - before) / static_cast<double>(covered.size() - i);
            if (share >= limits_.backed_before && rest <= limits_.backed_after && share - rest > change.drop)
                change = {share - rest, static_cast<double>(i) * kCoverageStep_s};
        }
        return change;
    }

    void judgeResidual() {
        verdict_.residual_rms_m = rangeStatistics(report_.pairs).residualRms_m();
        const std::vector<float> sizes_m = residualSizes_m(report_.pairs);
        verdict_.residual_median_m = quantileOf(sizes_m, 0.5);
        verdict_.residual_spread_m = quantileOf(sizes_m, kOneSigma);
        if (!verdict_.residual_spread_m || comparison_ || is_uncalibrated_)
            return;
        TakeGrade grade =
            gradeOf(*verdict_.residual_spread_m, limits_.good_residual_m, limits_.usable_residual_m);
        if (grade == TakeGrade::kGood) {
            findAstray();
            if (verdict_.astray)
                grade =
                    gradeOf(verdict_.astray->median_m, limits_.good_residual_m, limits_.usable_residual_m);
        }
        charge(VerdictReason::kResidual, grade);
    }

    /// The source or board whose ranges miss the pose most, if they do. One source that points elsewhere is
    /// an eighth of all ranges, which the spread of all does not show.
    void findAstray() {
        std::vector<std::vector<float>> of_source(report_.sources.size()), of_board(report_.boards.size());
        const auto gather = [](std::vector<std::vector<float>>& parts, int index,
                               const std::vector<float>& sizes_m) {
            if (static_cast<size_t>(index) >= parts.size())
                parts.resize(static_cast<size_t>(index) + 1);
            std::ranges::copy(sizes_m, std::back_inserter(parts[static_cast<size_t>(index)]));
        };
        for (const ReportPair& pair : report_.pairs) {
            const std::vector<float> sizes_m = residualSizes_m(pair);
            gather(of_source, pair.source, sizes_m);
            gather(of_board, pair.board, sizes_m);
        }
        double worst_m = limits_.good_residual_m;
        const auto look = [&](const std::vector<std::vector<float>>& parts, bool is_source) {
            for (size_t i = 0; i < parts.size(); ++i)
                if (const auto median_m = quantileOf(parts[i], 0.5);
                    parts[i].size() >= kLeastOfPart && *median_m > worst_m) {
                    worst_m = *median_m;
                    verdict_.astray = {is_source, static_cast<int>(i), worst_m};
                }
        };
        look(of_source, true);
        look(of_board, false);
    }

    void judgeBoards() {
        TakeGrade worst = TakeGrade::kGood;
        for (size_t b = 0; b < report_.boards.size(); ++b) {
            const ReportBoard& board = report_.boards[b];
            if (board.frames_expected <= 0)
                continue;
            const double lost =
                static_cast<double>(board.frames_lost) / static_cast<double>(board.frames_expected);
            if (lost > limits_.good_lost)
                verdict_.lossy_boards.push_back({static_cast<int>(b), lost});
            worst = std::max(worst, lost > limits_.good_lost ? TakeGrade::kUsable : TakeGrade::kGood);
        }
        std::stable_sort(
            verdict_.lossy_boards.begin(), verdict_.lossy_boards.end(),
            [](const VerdictBoard& a, const VerdictBoard& b) { return a.lost_share > b.lost_share; });
        // One dead board costs one segment; when most boards lose much, it is the link.
        const auto many = static_cast<size_t>(
            std::count_if(verdict_.lossy_boards.begin(), verdict_.lossy_boards.end(),
                          [&](const VerdictBoard& board) { return board.lost_share > limits_.usable_lost; }));
        charge(VerdictReason::kBoardLost, 2 * many > report_.boards.size() ? TakeGrade::kNotUsable : worst);
    }

    void judgeHoles() {
        std::vector<std::pair<double, double>> gaps = overview_.gaps_s;
        std::sort(gaps.begin(), gaps.end());
        std::pair<double, double> hole{0, 0};
        for (const auto& [from_s, to_s] : gaps) {
            if (from_s > hole.second) {
                addHole(hole);
                hole.first = from_s;
            }
            hole.second = std::max(hole.second, std::min(to_s, overview_.duration_s));
        }
        addHole(hole);
        charge(VerdictReason::kHole,
               gradeOf(verdict_.longest_hole_s, limits_.good_hole_s, limits_.usable_hole_s));
    }

    void addHole(const std::pair<double, double>& hole) {
        const double length_s = std::max(0.0, hole.second - hole.first);
        verdict_.hole_s += length_s;
        verdict_.longest_hole_s = std::max(verdict_.longest_hole_s, length_s);
    }

    static constexpr double kLeastHalf_s = 3;    ///< of the take, to either side of a change
    static constexpr double kOneSigma = 0.683;   ///< of normal errors' sizes stay within it
    static constexpr size_t kLeastOfPart = 50;   ///< ranges; fewer say little of a source or a board
    static constexpr double kLeastDrift_s = 20;  ///< a slope over less says little

    const ReportData& report_;
    const TakeOverview& overview_;
    const VerdictLimits& limits_;
    const ReportRun* run_;
    const Comparison* comparison_ = nullptr;
    bool is_uncalibrated_ = false;  ///< so that low support and large residuals follow from it
    TakeVerdict verdict_;
    std::vector<Charge> charges_;
};

}  // namespace

TakeVerdict judgeTake(const ReportData& report, const TakeOverview& overview, const VerdictLimits& limits) {
    return Judge(report, overview, limits).judge();
}

}  // namespace noctule
