// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/accelerometer/accelerometer_calibration.h"

#include <algorithm>

#include "core/body/text.h"
#include "core/calibration/accelerometer/accelerometer_fit.h"
#include "core/calibration/accelerometer/accelerometer_positions.h"
#include "core/calibration/worn_part_names.h"
#include "core/suit/calibration_entries.h"
#include "core/suit/calibration_lack.h"

namespace noctule {
namespace {

using AccelLimits = AccelerometerLimits;

constexpr double kSigmaPlate_rad = radians(0.05);
constexpr double kSideReach_rad = radians(10.0);  ///< farther off a position is tilted, not a side
constexpr size_t kFewestPositions = 3;            ///< to tell sides at all
constexpr size_t kSpreadPositions = 9;            ///< the twelve values may do without a side from here on
constexpr int kMostAskew = 12;                    ///< a plate on which more lies askew is none
const char* const kMoveRemedy = "Lay it down again and leave it alone for four seconds";

std::optional<BoardSide> sideOf(const AccelerometerFit& fit, const StillPosition& position) {
    const BoardSide side = BoardSide::nearest(fit.value(position));
    return fit.angle_rad(position, side) < kSideReach_rad ? std::optional(side) : std::nullopt;
}

/// Whether the others tell where a level position should be: one more on its axis, or many all around.
bool seenByOthers(const std::vector<StillPosition>& positions, size_t k) {
    const auto on_axis = [&](const StillPosition& other) {
        return other.level && other.level->axis == positions[k].level->axis;
    };
    return positions.size() > kSpreadPositions || std::ranges::count_if(positions, on_axis) > 1;
}

/// Where the others see a level position.
double angleFromOthers(std::vector<StillPosition> positions, size_t k, const AxisCalibration& start) {
    const BoardSide side = *positions[k].level;
    positions[k].level.reset();
    return fitAccelerometer(positions, start).angle_rad(positions[k], side);
}

/// A side that the others see askew counts only as far as it is level; the worst first, as it spoils the
/// others' sight of the rest.
std::vector<double> weighLevels(std::vector<StillPosition>& positions, const AxisCalibration& start) {
    std::vector<double> angles(positions.size());
    for (int round = 0; round < kMostAskew; ++round) {
        size_t worst = positions.size();
        for (size_t k = 0; k < positions.size(); ++k) {
            if (!positions[k].level || positions[k].sigma_level_rad > kSigmaPlate_rad ||
                !seenByOthers(positions, k))
                continue;
            angles[k] = angleFromOthers(positions, k, start);
            if (angles[k] > AccelLimits::kLevel_rad &&
                (worst == positions.size() || angles[k] > angles[worst]))
                worst = k;
        }
        if (worst == positions.size())
            break;
        positions[worst].sigma_level_rad = angles[worst];
    }
    return angles;
}

std::string listed(const std::vector<BoardSide>& sides) {
    std::string text;
    for (size_t i = 0; i < sides.size(); ++i)
        text += (i == 0 ? "" : i + 1 == sides.size() ? " and " : ", ") + sides[i].name();
    return text;
}

/// One board from its readings to its values and what is to be said of them.
class AccelerometerSolver {
public:
    AccelerometerSolver(const BoardRecord& record, const std::vector<Observations>& takes,
                        std::vector<Finding>& findings)
        : record_(record),
          findings_(findings),
          nominal_(AxisCalibration::nominal(record.board.accel_full_scale_m_per_s2)),
          still_(stillBoard(record, takes)) {
        result_.board = record.board;
    }

    AccelerometerBoard solve() {
        if (still_.clipped)
            say(Grade::kUsable, "its accelerometer reached the end of its range while it lay still",
                "Check the board's range in the suit description; if that is right, change the board");
        if (record_.readingCount() == 0)
            say(Grade::kNotUsable, "sent no readings",
                "Push its plug in until it clicks, then repeat its six sides");
        else if (still_.positions.size() < kFewestPositions)
            say(Grade::kNotUsable,
                "six sides are needed, but it lay still " + std::to_string(still_.positions.size()) +
                    (still_.positions.size() == 1 ? " time" : " times"),
                kMoveRemedy);
        else
            solveStill();
        return result_;
    }

private:
    void say(Grade grade, const std::string& what, const std::string& remedy) {
        result_.grade = std::max(result_.grade, grade);
        findings_.push_back({grade, record_.id, record_.words + ": " + what, remedy});
    }

    void solveStill() {
        std::vector<StillPosition>& positions = still_.positions;
        const AxisCalibration start = guessZero(positions, nominal_);
        const AccelerometerFit rough = fitAccelerometer(positions, start);
        for (StillPosition& position : positions) {
            position.level = sideOf(rough, position);
            position.sigma_level_rad = kSigmaPlate_rad;
        }
        const std::vector<double> angles = weighLevels(positions, start);
        const AccelerometerFit fit = fitAccelerometer(positions, start);
        const BoardCalibration* in_force = record_.in_force->findBoard(record_.id);
        const bool is_known = knowsAccelerometer(result_.board, in_force);
        for (size_t k = 0; k < positions.size(); ++k) {
            result_.positions.push_back({still_.stretches[k].take,
                                         still_.stretches[k].begin_s,
                                         still_.stretches[k].end_s,
                                         positions[k].level,
                                         fit.residual_m_per_s2(positions[k]),
                                         angles[k],
                                         {}});
            if (is_known)
                result_.positions.back().residual_before_m_per_s2 =
                    AccelerometerFit{.axes = in_force->accel}.residual_m_per_s2(positions[k]);
        }
        result_.axes = fit.axes;
        result_.sigma_matrix = fit.sigma_matrix;
        reportMissing(fit);
        reportAskew();
        reportResiduals();
        judge(fit);
        if (result_.grade == Grade::kNotUsable)
            result_.axes.reset();
    }

    bool has(BoardSide side) const {
        return std::ranges::any_of(result_.positions,
                                   [&](const auto& position) { return position.side == side; });
    }
    /// The longest that the board lay on a side that it was then moved on.
    std::optional<double> disturbed_s(const AccelerometerFit& fit, BoardSide side) const {
        std::optional<double> longest_s;
        for (const SteadyStretch& stretch : still_.disturbed)
            if (sideOf(fit, {{plainMean(stretch.readings), {}}, 0, std::nullopt, 0}) == side)
                longest_s = std::max(longest_s.value_or(0), stretch.length_s());
        return longest_s;
    }

    void reportMissing(const AccelerometerFit& fit) {
        const Grade grade = result_.positions.size() >= kSpreadPositions ? Grade::kUsable : Grade::kNotUsable;
        std::vector<BoardSide> missing;
        for (const BoardSide side : kBoardSides) {
            if (has(side))
                continue;
            if (const auto still_s = disturbed_s(fit, side))
                say(grade,
                    "was moved while its " + side.name() + " side was up, it lay still for " +
                        text::number(*still_s, 1) + " s",
                    kMoveRemedy);
            else
                missing.push_back(side);
        }
        if (!missing.empty())
            say(grade,
                "never lay still with its " + listed(missing) +
                    (missing.size() > 1 ? " sides up" : " side up"),
                "Lay it with " + listed(missing) + " up and leave it alone for four seconds");
    }

    void reportAskew() {
        for (const AccelerometerPosition& position : result_.positions) {
            if (!position.side || position.off_level_rad <= AccelLimits::kLevel_rad)
                continue;
            const std::string angle = text::number(degrees(position.off_level_rad), 1) + "°";
            if (!isAskew(position.side->opposite()))
                say(Grade::kUsable, "lay " + angle + " askew with its " + position.side->name() + " side up",
                    "Press it into its seat, check that the plate is level, and repeat this side");
            else if (position.side->sign > 0)
                say(Grade::kUsable,
                    "its " + position.side->name() + " and " + position.side->opposite().name() +
                        " sides are " + angle + " from opposite; one of the two did not lie level",
                    "Press it into its seat, check that the plate is level, and repeat both sides");
        }
    }
    bool isAskew(BoardSide side) const {
        return std::ranges::any_of(result_.positions, [&](const auto& position) {
            return position.side == side && position.off_level_rad > AccelLimits::kLevel_rad;
        });
    }

    void reportResiduals() {
        for (const AccelerometerPosition& position : result_.positions)
            if (std::abs(position.residual_m_per_s2) > AccelLimits::kResidual_m_per_s2)
                say(Grade::kUsable,
                    "read gravity " + text::number(position.residual_m_per_s2, 2) + " m/s² off " +
                        (position.side ? "with its " + position.side->name() + " side up"
                                       : "in a tilted position"),
                    "Check that nothing shakes or pushes the board, and repeat this position");
    }

    void judge(const AccelerometerFit& fit) {
        const double worst = std::max(result_.sigmaZero_m_per_s2() / AccelLimits::kZero_m_per_s2,
                                      result_.sigmaSlope() / AccelLimits::kSlope);
        if (result_.grade == Grade::kNotUsable)
            return;
        if (!fit.converged || !(worst <= 1))
            say(Grade::kNotUsable, "its readings do not settle zero and slope", "Repeat its six sides");
        else if (worst > AccelLimits::kGood && result_.grade == Grade::kGood)
            say(Grade::kUsable,
                "its zero is known to " +
                    text::number(1000 * result_.sigmaZero_m_per_s2() / kStandardGravity_m_per_s2, 1) +
                    " mg and its slope to " + text::number(100 * result_.sigmaSlope(), 3) + " %",
                "For a better result leave each side still for longer");
    }

    const BoardRecord& record_;
    std::vector<Finding>& findings_;
    AxisCalibration nominal_;
    BoardStillness still_;
    AccelerometerBoard result_;
};

}  // namespace

double AccelerometerBoard::sigmaZero_m_per_s2() const {
    return axes->matrix.diagonal().cwiseProduct(*axes->sigma_zero_counts).cwiseAbs().maxCoeff();
}

double AccelerometerBoard::sigmaSlope() const {
    return sigma_matrix.diagonal().cwiseQuotient(axes->matrix.diagonal()).cwiseAbs().maxCoeff();
}

Calibration AccelerometerReport::applied(const Calibration& base) const {
    Calibration calibration = base;
    for (const AccelerometerBoard& board : boards)
        if (board.axes)
            entryOf(calibration, board.board).accel = *board.axes;
    return calibration;
}

AccelerometerReport calibrateAccelerometers(const std::vector<Observations>& takes) {
    AccelerometerReport report;
    for (const BoardRecord& record : boardRecords(takes))
        report.boards.push_back(AccelerometerSolver(record, takes, report.findings).solve());
    return report;
}

}  // namespace noctule
