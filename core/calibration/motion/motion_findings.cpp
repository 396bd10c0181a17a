// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_findings.h"

#include <algorithm>

#include "core/body/text.h"
#include "core/calibration/worn_part_names.h"
#include "core/math/rotation.h"
#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

constexpr double kWellHeardShare = 0.9;
constexpr double kLeastTurn_rad = radians(5);  // root mean square about a joint's own mean
constexpr double kStillJointsAllowed = 0.25;   // of all
constexpr double kMuchTurn_rad = radians(25), kMuchShift_m = 0.04;
const char* const kMoveAgain =
    "Move again: squats, arm circles, leg swings, turns of trunk and head, bends of elbows, knees and wrists";

/// By the end of the joint's name.
struct Movement {
    const char* joint;
    const char* how;
};
constexpr Movement kMovements[] = {
    {"ForeArm", "Bend that elbow all the way and turn the palm up and down"},
    {"Arm", "Circle that arm and turn it about its own length"},
    {"Hand", "Bend that wrist up and down and to both sides, and turn the palm up and down"},
    {"Shoulder", "Shrug and roll that shoulder"},
    {"UpLeg", "Swing that leg forwards and sideways and turn it about its own length"},
    {"Leg", "Bend that knee all the way, with the thigh turned in and out"},
    {"Foot", "Bend that ankle up and down and circle the foot"},
    {"Head", "Nod, tilt the head to both shoulders and look over both"},
    {"Chest", "Bend forwards and sideways and turn the trunk to both sides"},
    {"Spine", "Bend forwards and sideways and turn the trunk to both sides"},
    {"Hips", "Squat, lean to all sides and turn around"}};

/// How far the segment turns against its parent, about its mean.
double turnSpread_rad(const MotionBody& body, const std::vector<MotionNode>& nodes, int segment) {
    const auto s = static_cast<size_t>(segment), parent = static_cast<size_t>(body.segment(segment).parent);
    std::vector<Vector3d> turns;
    Vector3d mean = Vector3d::Zero();
    for (const MotionNode& node : nodes) {
        const Matrix3d R = node.R_world_segment[parent].transpose() * node.R_world_segment[s];
        turns.push_back(logQuaternion(body.segment(segment).q_parent_rest.conjugate() * Quaterniond(R)));
        mean += turns.back() / static_cast<double>(nodes.size());
    }
    double square = 0;
    for (const Vector3d& turn : turns)
        square += (turn - mean).squaredNorm();
    return std::sqrt(square / std::max(1.0, static_cast<double>(nodes.size())));
}

/// One cause is one finding: what most boards lack is no matter of their plugs.
Finding mostlyUnheard(const Observations& take, const MotionEvidence& evidence,
                      const std::vector<Finding>& boards) {
    const Grade worst = std::ranges::max_element(boards, {}, &Finding::grade)->grade;
    std::vector<double> shares = evidence.heard_share;
    std::ranges::sort(shares);
    return {
        worst, "",
        std::to_string(boards.size()) + " of " + std::to_string(shares.size()) +
            " boards are heard in only " + text::number(100 * shares[boards.size() / 2], 0) +
            " % of the movement in " + take.take + ", in the median",
        "See that the driver box reaches the computer without loss, and that the take is whole, then move "
        "again"};
}

}  // namespace

void addEvidenceFindings(const Observations& take, const StillStretch& still, const MotionEvidence& evidence,
                         std::vector<Finding>& into) {
    std::vector<Finding> boards;
    for (int b = 0; b < static_cast<int>(evidence.heard_share.size()); ++b) {
        const auto board = static_cast<size_t>(b);
        const double share = evidence.heard_share[board];
        if (share >= kWellHeardShare && still.boards[board].heard())
            continue;
        const bool lost = !evidence.isHeard(board) || !still.boards[board].heard();
        boards.push_back({lost ? Grade::kNotUsable : Grade::kUsable, take.suit.boards[board].id,
                          boardName(take.suit, b) + ", is heard in only " + text::number(100 * share, 0) +
                              " % of the movement in " + take.take,
                          "Push its plug in until it clicks and see that its readings stay within their "
                          "range, then move again"});
    }
    if (2 * boards.size() > evidence.heard_share.size() && boards.size() > 1)
        into.push_back(mostlyUnheard(take, evidence, boards));
    else
        into.insert(into.end(), boards.begin(), boards.end());
    if (evidence.distances.empty())
        into.push_back(
            {Grade::kUsable, "",
             "No distance took part in " + take.take + ", so lengths and places rest on accelerations alone",
             "Calibrate the sources first and see that they are plugged in"});
}

void addMovementFindings(const MotionSettings& settings, const MotionBody& body,
                         const std::vector<int>& board_segments, const std::vector<MotionNode>& nodes,
                         double moved_s, std::vector<Finding>& into) {
    if (moved_s < settings.shortest_s)
        into.push_back({Grade::kNotUsable, "",
                        "There are only " + text::number(moved_s, 0) + " s of movement after the rest pose",
                        "Move for 30 to 60 seconds"});
    std::vector<std::string> still;
    std::string how;
    int joints = 0;
    for (int s = 1; s < body.size(); ++s) {
        if (std::ranges::find(board_segments, s) == board_segments.end())
            continue;
        ++joints;
        if (turnSpread_rad(body, nodes, s) >= kLeastTurn_rad)
            continue;
        still.push_back(text::jointLabel(body.segment(s).name));
        const std::string movement = howToMove(body.segment(s));
        if (how.find(movement) == std::string::npos)
            how += (how.empty() ? "" : ". ") + movement;
    }
    if (still.empty())
        return;
    std::string names;
    for (const std::string& name : still)
        names += (names.empty() ? "" : ", ") + name;
    const bool too_many = static_cast<double>(still.size()) > kStillJointsAllowed * joints;
    into.push_back({too_many ? Grade::kNotUsable : Grade::kUsable, "",
                    "Too little movement to show how boards sit at: " + names, too_many ? kMoveAgain : how});
}

std::string howToMove(const BodySegment& segment) {
    for (const auto& [joint, how] : kMovements)
        if (segment.name.ends_with(joint))
            return how;
    return "Swing that limb to all sides and turn it about its own length";
}

void addResultFindings(const Observations& take, const MotionReport& report, std::vector<Finding>& into) {
    const Suit placed = placedSuit(take.suit, take.calibration);
    for (int b = 0; b < static_cast<int>(report.boards.size()); ++b) {
        const BoardInMotion& board = report.boards[static_cast<size_t>(b)];
        const Vector3d shift_m =
            board.p_segment_board_m - placed.boards[static_cast<size_t>(b)].p_segment_board_m;
        if (board.measured && (board.turned_rad > kMuchTurn_rad || shift_m.norm() > kMuchShift_m))
            into.push_back({Grade::kUsable, board.id,
                            boardName(take.suit, b) + ", is found " +
                                text::number(degrees(board.turned_rad), 0) + "° and " +
                                text::number(100 * shift_m.norm(), 0) +
                                " cm from where the calibration before has it",
                            "Put its strap right or correct the suit file, then calibrate again"});
    }
    if (!report.converged)
        into.push_back({Grade::kNotUsable, "", "The fit of the movement did not converge",
                        "Record the movement again, from a rest pose that is held still"});
}

}  // namespace noctule
