// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_pose_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/body/text.h"
#include "core/calibration/worn_part_names.h"
#include "core/suit/calibration_lack.h"

namespace noctule {
namespace {

constexpr double kMuchSway_rad = radians(2);
constexpr double kFarFromG_m_per_s2 = 0.5;  // ten times what a calibrated accelerometer drifts
constexpr size_t kPairsNamed = 3;           // of more that nothing tells apart one stands for all
const char* const kHoldAgain = "Hold the rest pose again";

std::string clockText(double time_s) {
    const double tenths = std::round(std::max(0.0, time_s) * 10);
    const int minutes = static_cast<int>(tenths / 600);
    char text[32];
    std::snprintf(text, sizeof text, "%d:%04.1f", minutes, (tenths - 600.0 * minutes) / 10);
    return text;
}

const std::string& idOf(const Observations& take, int board) {
    return take.suit.boards[static_cast<size_t>(board)].id;
}

std::string pairText(const Suit& suit, const SwappedBoards& pair) {
    return boardInList(suit, pair.first) + " and " + boardInList(suit, pair.second);
}

std::string movedText(const Observations& take, const BoardMovement& moved) {
    return boardName(take.suit, moved.board) + ", moved at " + clockText(moved.begin_s);
}

void addSwap(const Observations& take, const RestPoseReport& report, std::vector<Finding>& into) {
    for (const SwappedBoards& pair : report.swapped) {
        std::string what = "Boards " + pairText(take.suit, pair);
        if (&pair == &report.swapped.front())
            for (const SwappedBoards& rival : report.rivals)
                what += ", or " + pairText(take.suit, rival) + ",";
        into.push_back({Grade::kNotUsable, idOf(take, pair.first), what + " seem to be swapped",
                        pair.plugs ? "Exchange their two plugs at the box, then hold the rest pose again"
                                   : "Exchange the two boards, then hold the rest pose again"});
    }
    const bool many = report.untold.size() > kPairsNamed;
    for (const SwappedBoards& pair : report.untold) {
        into.push_back(
            {Grade::kUsable, many ? "" : idOf(take, pair.first),
             "Nothing in this take tells boards " + pairText(take.suit, pair) + " apart" +
                 (many ? ", nor " + std::to_string(report.untold.size() - 1) + " other pairs" : "") +
                 ": gravity is alike on both and no sound decides",
             "Check whether each sits where it belongs"});
        if (many)
            break;
    }
}

void addAskew(const Observations& take, const RestPoseSettings& settings, const BoardAtRest& board, int index,
              std::vector<Finding>& into) {
    if (board.measured && board.tilt_from_suit_rad > settings.askew_rad)
        into.push_back({Grade::kUsable, board.id,
                        boardName(take.suit, index) + ", sits " +
                            text::number(degrees(board.tilt_from_suit_rad), 0) +
                            "° askew from where the suit file says",
                        "Put its strap right or correct the suit file, then hold the rest pose again"});
}

/// Gravity alone says nothing of headings and places, nor which of two boards hangs left.
void addUnmeasured(const Observations& take, const RestPoseSettings& settings, RestPoseReport& report) {
    const std::string unknown = "headings (sigma " + text::number(degrees(settings.sigma_board_turn_rad), 0) +
                                "°) and places are those of the suit's file, and boards swapped left and "
                                "right pass unseen";
    if (take.suit.sources.empty())
        report.findings.push_back({Grade::kUsable, "", "The suit has no sources: " + unknown,
                                   "See that each board sits where it belongs, and calibrate the movement, "
                                   "which shows headings"});
    else
        report.findings.push_back(
            {Grade::kUsable, "",
             "No distance was measured, so this serves tilts and turns, not distances: " + unknown,
             "Calibrate the sources and plug them in, then hold the rest pose again"});
}

}  // namespace

void addWhyNotStill(const Observations& take, const StillStretch& still, std::vector<Finding>& into) {
    const bool any = std::ranges::any_of(take.boards, [](const auto& readings) { return !readings.empty(); });
    if (!any || take.actor.skeleton.size() == 0) {
        into.push_back({Grade::kNotUsable, "", "No board of the suit is heard in the rest pose",
                        "See that the box is connected and the boards are plugged in, then record again"});
        return;
    }
    const std::string where = still.marked ? "the marked rest pose" : "the take, which marks no rest pose";
    if (still.movements.empty()) {
        into.push_back(
            {Grade::kNotUsable, "", "There is no second of standing still in " + where, kHoldAgain});
        return;
    }
    into.push_back(
        {Grade::kNotUsable, idOf(take, still.movements.front().board),
         movedText(take, still.movements.front()) + "; there is no second of standing still in " + where,
         "Stand still in the rest pose for three seconds"});
}

void addStandingFindings(const Observations& take, const StillStretch& still, std::vector<Finding>& into) {
    if (!still.marked)
        into.push_back({Grade::kUsable, "",
                        "The take marks no rest pose; the longest stillness was taken for it, from " +
                            clockText(still.stretch.begin_s) + " to " + clockText(still.stretch.end_s),
                        "See that the performer stands in the rest pose there, or record one"});
    if (still.marked && !still.movements.empty())
        into.push_back({Grade::kUsable, idOf(take, still.movements.front().board),
                        movedText(take, still.movements.front()) + "; only the stillness from " +
                            clockText(still.stretch.begin_s) + " to " + clockText(still.stretch.end_s) +
                            " was used",
                        "Hold the rest pose again if the other results are poor"});
    for (int b = 0; b < static_cast<int>(still.boards.size()); ++b) {
        const StillBoard& board = still.boards[static_cast<size_t>(b)];
        if (!board.heard())
            into.push_back({Grade::kNotUsable, idOf(take, b),
                            boardName(take.suit, b) + ", is silent in the rest pose and keeps its old values",
                            "Push its plug in until it clicks, then hold the rest pose again"});
        if (board.clipped)
            into.push_back({Grade::kUsable, idOf(take, b),
                            boardName(take.suit, b) + ", reads the end of its range while it is still",
                            "Change the board"});
        if (board.sway_rad > kMuchSway_rad)
            into.push_back({Grade::kUsable, idOf(take, b),
                            boardName(take.suit, b) + ", leans " + text::number(degrees(board.sway_rad), 1) +
                                "° otherwise at the end of the rest pose than at its beginning",
                            kHoldAgain});
    }
}

void addPlaceFindings(const Observations& take, const RestPoseSettings& settings,
                      const RestExplanation& explained, RestPoseReport& report) {
    addSwap(take, report, report.findings);
    for (int b = 0; b < static_cast<int>(report.boards.size()); ++b)
        addAskew(take, settings, report.boards[static_cast<size_t>(b)], b, report.findings);
    const auto addShifted = [&](const std::string& id, const std::string& name, const Vector3d& shift_m) {
        if (shift_m.norm() > settings.shifted_m)
            report.findings.push_back(
                {Grade::kUsable, id,
                 name + ", sits about " + text::number(100 * shift_m.norm(), 0) +
                     " cm from where the suit file says",
                 "Put it right or correct the suit file, then hold the rest pose again"});
    };
    for (const int b : explained.shifted_boards)
        addShifted(idOf(take, b), boardName(take.suit, b),
                   explained.fit.board_shift_m[static_cast<size_t>(b)]);
    for (const int s : explained.shifted_sources)
        addShifted(take.suit.sources[static_cast<size_t>(s)].id, sourceName(take.suit, s),
                   explained.fit.source_shift_m[static_cast<size_t>(s)]);
    if (report.distances == 0)
        addUnmeasured(take, settings, report);
    if (!report.converged)
        report.findings.push_back(
            {Grade::kUsable, "", "The fit of the rest pose did not converge", kHoldAgain});
}

void addSensorFindings(const Observations& take, const RestPoseSettings& settings,
                       const RestEvidenceMaker& maker, RestPoseReport& report) {
    double sigma_rad = 0;
    for (int b = 0; b < static_cast<int>(report.boards.size()); ++b) {
        const BoardAtRest& board = report.boards[static_cast<size_t>(b)];
        if (!board.measured)
            continue;
        if (!maker.accelIsCalibrated(b))
            sigma_rad = std::max(sigma_rad, board.sigma_tilt_rad);
        else if (std::abs(board.accel_above_g_m_per_s2) > kFarFromG_m_per_s2)
            report.findings.push_back({Grade::kUsable, board.id,
                                       boardName(take.suit, b) + ", feels " +
                                           text::number(take.g_m_per_s2 + board.accel_above_g_m_per_s2, 2) +
                                           " m/s² while it is still instead of " +
                                           text::number(take.g_m_per_s2, 2),
                                       "Calibrate its accelerometer"});
    }
    if (sigma_rad > 0)
        report.findings.push_back({sigma_rad > settings.unknown_rad ? Grade::kNotUsable : Grade::kUsable, "",
                                   "Accelerometers are not calibrated: every tilt found here is uncertain by "
                                   "about " +
                                       text::number(degrees(sigma_rad), 0) + "°",
                                   "Calibrate the accelerometers first"});
    // How boards sit does not depend on it: zeros are found here, slopes are not used.
    if (lackOf(take.suit, take.calibration).ofMostGyroscopes())
        report.findings.push_back({Grade::kGood, "",
                                   "Made before the gyroscopes were calibrated: boards with exchanged plugs "
                                   "are noticed less surely, and the zeros found here are replaced when the "
                                   "gyroscopes are calibrated",
                                   "Hold the rest pose again after the gyroscopes"});
}

}  // namespace noctule
