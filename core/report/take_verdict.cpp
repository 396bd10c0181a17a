// SPDX-License-Identifier: Apache-2.0
#include "core/report/take_verdict.h"

#include <algorithm>
#include <cmath>

#include "core/report/joint_support.h"
#include "core/report/range_statistics.h"

namespace noctule {
namespace {

/// Good up to one limit, usable up to the other; what is not a number is not usable.
Grade gradeOf(double value, double good, double usable) {
    if (value <= good)
        return Grade::kGood;
    return value <= usable ? Grade::kUsable : Grade::kNotUsable;
}

/// Boards whose lost shares differ by less lost the same moments; plugs do not fail all alike.
constexpr double kLostTogether = 0.02;

class Judge {
public:
    Judge(const ReportData& report, const VerdictLimits& limits)
        : report_(report), limits_(limits), run_(report.shownRun()) {
        if (run_ && run_->comparison)
            comparison_ = &*run_->comparison;
    }

    TakeVerdict judge() {
        if (!run_) {
            charge(VerdictReason::kNoPoses, Grade::kNotUsable);
            return sorted();
        }
        if (report_.take.ends_in_rest) {
            charge(VerdictReason::kEndsInRest, Grade::kNotUsable);
            return sorted();
        }
        judgeError();
        listJoints();
        judgeCalibration();
        judgeSensors();
        judgeSupport();
        judgeResidual();
        judgeDistances();
        judgeBoards();
        judgeHoles();
        charge(VerdictReason::kPeopleApart, report_.people_apart ? Grade::kUsable : Grade::kGood);
        return sorted();
    }

private:
    struct Charge {
        VerdictReason reason;
        Grade grade;
    };

    void charge(VerdictReason reason, Grade grade) {
        if (grade != Grade::kGood)
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
        if (const double moves_s = report_.take.afterRest_s(); moves_s > 0)
            verdict_.compared_share = std::min(1.0, comparison_->duration_s / moves_s);
        charge(VerdictReason::kMeanError,
               gradeOf(comparison_->mean_deg, limits_.good_mean_deg, limits_.usable_mean_deg));
        const auto worst = std::max_element(comparison_->joints.begin(), comparison_->joints.end(),
                                            [](const JointComparison& a, const JointComparison& b) {
                                                return a.angle.mean_deg < b.angle.mean_deg;
                                            });
        if (worst != comparison_->joints.end() && worst->angle.mean_deg > limits_.good_joint_deg) {
            verdict_.worst_joint = worst->name;
            charge(VerdictReason::kJointError, Grade::kUsable);
        }
        if (comparison_->duration_s >= kLeastDrift_s)
            verdict_.yaw_drift_deg_per_min = comparison_->root.yaw_drift_deg_per_min;
    }

    void listJoints() {
        for (const JointSupport& support : report_.support) {
            VerdictJoint joint{support.joint, {}, {}, support.ranges, support.inertia, Grade::kGood};
            if (const auto* compared = comparison_ ? comparison_->find(support.joint) : nullptr) {
                joint.mean_deg = compared->angle.mean_deg;
                joint.worst_deg = compared->angle.max_deg;
            }
            if (joint.mean_deg)
                joint.grade = *joint.mean_deg <= limits_.good_joint_deg ? Grade::kGood : Grade::kUsable;
            else if (joint.backed_by_ranges < kBackedAfter)
                joint.grade = Grade::kUsable;
            verdict_.joints.push_back(std::move(joint));
        }
    }

    /// Nothing else tells fast turns: distances alone are off by 100 degrees where few are heard.
    void judgeSensors() {
        verdict_.sensors = run_->sensors;
        has_gyroscopes_ = run_->sensors.find('G') != std::string::npos;
        if (!has_gyroscopes_)
            charge(VerdictReason::kNoGyroscopes, comparison_ ? Grade::kUsable : Grade::kNotUsable);
    }

    /// With a reference the error is known, and a missing calibration only explains it.
    void judgeCalibration() {
        verdict_.lack = report_.lack;
        const Grade grade = gradeOf(report_.lack, run_->sensors);
        is_uncalibrated_ = grade == Grade::kNotUsable;
        if (grade == Grade::kGood || (comparison_ && charges_.empty()))
            return;
        charge(VerdictReason::kNotCalibrated,
               is_uncalibrated_ && !comparison_ ? Grade::kNotUsable : Grade::kUsable);
    }

    void judgeSupport() {
        if (verdict_.joints.empty())
            return;
        double sum = 0;
        for (const JointSupport& support : report_.support)
            sum += support.ranges;
        const JointSupport& alone = *std::ranges::max_element(report_.support, {}, &JointSupport::alone);
        verdict_.backed_share = sum / static_cast<double>(report_.support.size());
        if (comparison_ || isExplained())
            return;
        const bool alone_by_design = alone.alone() >= kNeverTold;
        const Grade of_alone = alone_by_design
                                   ? Grade::kUsable
                                   : gradeOf(alone.alone(), limits_.good_alone, limits_.usable_alone);
        Grade grade = of_alone;
        if (run_->sensors.find('D') == std::string::npos)
            grade = std::max(grade, Grade::kUsable);  // nothing stops the drift; how far it goes is unknown
        else
            grade = std::max(grade,
                             gradeOf(-verdict_.backed_share, -limits_.good_backed, -limits_.usable_backed));
        if (findLessCertainJoint())
            grade = std::max(grade, Grade::kUsable);
        if (of_alone != Grade::kGood && of_alone == grade) {
            verdict_.alone_joint = alone.joint;
            verdict_.alone_share = alone.alone();
            verdict_.alone_by_design = alone_by_design;
        }
        charge(VerdictReason::kSupport, grade);
    }

    /// Low support and large residuals follow from it.
    bool isExplained() const { return is_uncalibrated_ || !has_gyroscopes_; }

    /// The joint that ranges stopped backing most clearly.
    bool findLessCertainJoint() {
        const auto less = std::ranges::max_element(report_.support, {}, &JointSupport::lost_share);
        if (less == report_.support.end() || !less->lost_from_s)
            return false;
        verdict_.worst_joint = less->joint;
        verdict_.worst_from_s = less->lost_from_s;
        return true;
    }

    void judgeResidual() {
        verdict_.residual_rms_m = rangeStatistics(report_.pairs).residualRms_m();
        const std::vector<float> sizes_m = residualSizes_m(report_.pairs);
        verdict_.residual_median_m = quantileOf(sizes_m, 0.5);
        verdict_.residual_spread_m = quantileOf(sizes_m, kOneSigma);
        if (!verdict_.residual_spread_m || comparison_ || isExplained())
            return;
        Grade grade =
            gradeOf(*verdict_.residual_spread_m, limits_.good_residual_m, limits_.usable_residual_m);
        if (grade == Grade::kGood) {
            findAstray();
            if (verdict_.astray)
                grade =
                    gradeOf(verdict_.astray->median_m, limits_.good_residual_m, limits_.usable_residual_m);
        }
        charge(VerdictReason::kResidual, grade);
    }

    /// Against a reference too: poses that fit without distances say nothing of those.
    void judgeDistances() {
        if (run_->sensors.find('D') == std::string::npos)
            return;
        if (report_.distances_given > 0)
            verdict_.refused_share =
                static_cast<double>(report_.distances_refused) / static_cast<double>(report_.distances_given);
        const RangeStatistics ranges = rangeStatistics(report_.pairs);
        const auto rejected = static_cast<double>(ranges.of(PulseFate::kRejected));
        const double tried = static_cast<double>(ranges.of(PulseFate::kUsed)) + rejected;
        const bool thrown_out = !isExplained() && rejected > limits_.good_refused * tried;
        if (thrown_out || verdict_.refused_share > limits_.good_refused)
            charge(VerdictReason::kDistances, Grade::kUsable);
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
        Grade worst = Grade::kGood;
        for (size_t b = 0; b < report_.boards.size(); ++b) {
            const ReportBoard& board = report_.boards[b];
            const double lost = board.lostShare();
            const bool came_or_went = board.lostMostlyByAbsence();
            if (lost > limits_.good_lost)
                verdict_.lossy_boards.push_back({static_cast<int>(b), lost,
                                                 came_or_went ? board.joined_s : std::nullopt,
                                                 came_or_went ? board.left_s : std::nullopt});
            worst = std::max(worst, lost > limits_.good_lost ? Grade::kUsable : Grade::kGood);
        }
        std::stable_sort(
            verdict_.lossy_boards.begin(), verdict_.lossy_boards.end(),
            [](const VerdictBoard& a, const VerdictBoard& b) { return a.lost_share > b.lost_share; });
        const auto& lossy = verdict_.lossy_boards;
        verdict_.lost_together = lossy.size() > 2 && lossy.size() == report_.boards.size() &&
                                 lossy.front().lost_share - lossy.back().lost_share < kLostTogether &&
                                 std::ranges::none_of(report_.boards, &ReportBoard::lostMostlyByAbsence);
        // One dead board costs one segment; when most boards lose much, it is the link.
        const auto many = static_cast<size_t>(
            std::count_if(verdict_.lossy_boards.begin(), verdict_.lossy_boards.end(),
                          [&](const VerdictBoard& board) { return board.lost_share > limits_.usable_lost; }));
        charge(VerdictReason::kBoardLost, 2 * many > report_.boards.size() ? Grade::kNotUsable : worst);
    }

    void judgeHoles() {
        std::vector<std::pair<double, double>> gaps = report_.gaps_s;
        std::sort(gaps.begin(), gaps.end());
        std::pair<double, double> hole{report_.take.begin_s, report_.take.begin_s};
        for (const auto& [from_s, to_s] : gaps) {
            if (from_s > hole.second) {
                addHole(hole);
                hole.first = from_s;
            }
            hole.second = std::max(hole.second, std::min(to_s, report_.take.end_s()));
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

    static constexpr double kNeverTold = 0.999;  ///< share of a joint's time
    static constexpr double kOneSigma = 0.683;   ///< of normal errors' sizes stay within it
    static constexpr size_t kLeastOfPart = 50;   ///< ranges; fewer say little of a source or a board
    static constexpr double kLeastDrift_s = 20;  ///< a slope over less says little

    const ReportData& report_;
    const VerdictLimits& limits_;
    const ReportRun* run_;
    const Comparison* comparison_ = nullptr;
    bool is_uncalibrated_ = false;
    bool has_gyroscopes_ = true;
    TakeVerdict verdict_;
    std::vector<Charge> charges_;
};

}  // namespace

TakeVerdict judgeTake(const ReportData& report, const VerdictLimits& limits) {
    return Judge(report, limits).judge();
}

}  // namespace noctule
