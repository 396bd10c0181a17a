// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/body/text.h"
#include "core/calibration/motion/motion_findings.h"
#include "core/calibration/motion/motion_fit.h"
#include "core/calibration/motion/motion_held_out.h"
#include "core/calibration/motion/motion_start.h"
#include "core/calibration/worn_part_names.h"
#include "core/job/staged_progress.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Beyond it a board was put on otherwise than the suit says, and the calibration in force knows better.
constexpr double kPutOnOtherwise_rad = radians(15);
/// Of the prior's sigma: below, the movement has shown more than the rest pose and the suit knew.
constexpr double kObservedShare = 0.25;
constexpr int kRoughIterations = 4;
constexpr double kRoughShare = 0.1, kFirstShare = 0.5;                 // of the time of a fit
constexpr double kFromRest = 0.6, kFitShare = 0.5, kCheckShare = 0.9;  // of all time
constexpr double kStraySigma = 4;   // of a mounting's prior: straps do not turn so far
constexpr double kWorse = 1.02;     // cost on seconds held out against the rest pose's
constexpr double kMostKept = 0.34;  // of all boards keep their rest pose's place
constexpr double kUnsettled_rad = radians(0.1);

ExpectedConstants expectedOf(const Observations& take) {
    ExpectedConstants expected;
    for (const Board& board : take.suit.boards) {
        BoardConstants constants;
        constants.q_segment_board = board.q_segment_board;
        constants.p_segment_board_m = board.p_segment_board_m;
        const BoardCalibration* known = take.calibration.findBoard(board.id);
        if (known && known->q_segment_board &&
            angleBetween(*known->q_segment_board, board.q_segment_board) > kPutOnOtherwise_rad)
            constants.q_segment_board = *known->q_segment_board;
        expected.boards.push_back(constants);
    }
    for (const Source& source : take.suit.sources)
        expected.sources.push_back({source.p_segment_source_m, 0});
    return expected;
}

/// Its mounting is not a movement's.
bool isOfRestPose(const BoardCalibration& known) {
    const auto rest = known.made.find("rest-pose"), motion = known.made.find("motion");
    return known.q_segment_board && rest != known.made.end() &&
           (motion == known.made.end() || motion->second.created_utc <= rest->second.created_utc);
}

bool isOnBody(const Observations& take) {
    const auto known = [&](const auto& part) { return take.actor.skeleton.find(part.segment) >= 0; };
    return std::ranges::all_of(take.suit.boards, known) && std::ranges::all_of(take.suit.sources, known);
}

/// Everything that one calibration works on.
class MovementFitter {
public:
    MovementFitter(const std::vector<Observations>& takes, const MotionSettings& settings)
        : takes_(takes),
          settings_(settings),
          body_(takes[0].actor),
          layout_(layoutOf(settings.flesh)),
          model_(body_, takes[0], layout_, settings.step_s),
          expected_(expectedOf(takes[0])) {}

    /// False when there is nothing to fit.
    bool prepare(MotionReport& report);
    Status fit(MotionReport& report, const JobContext& job);

private:
    MotionLayout layoutOf(bool flesh) const {
        return {body_.size(), static_cast<int>(takes_[0].suit.boards.size()),
                static_cast<int>(takes_[0].suit.sources.size()), static_cast<int>(body_.bones().size()),
                flesh};
    }
    bool readTake(const Observations& take, MotionReport& report);
    Result<MotionFitResult> fitWithoutFlesh(const MotionUnknowns& start, const JobContext& job) const;
    Result<MotionFitResult> fitFrom(MotionUnknowns start, MotionReport& report, const JobContext& job) const;
    Result<MotionFitResult> fitFromSeveral(MotionReport& report, const JobContext& job) const;
    MotionUnknowns startAsWorn() const;
    std::vector<int> strayBoards(const MotionFitResult& found) const;
    Result<std::vector<int>> worseBoards(const MotionFitResult& found, MotionReport& report,
                                         const JobContext& job) const;
    Result<MotionFitResult> fitWithout(const std::vector<int>& boards, const MotionFitResult& found,
                                       MotionReport& report, const JobContext& job);
    void addUnsettled(const MotionFitResult& found, MotionReport& report) const;
    void fill(const MotionFitResult& found, MotionReport& report) const;
    void fillBoard(const MotionFitResult& found, int index, BoardInMotion& board) const;
    void fillTissue(const MotionFitResult& found, int index, BoardInMotion& board) const;
    Vector3d sigma(const MotionFitResult& found, int first) const {
        return found.cov_border.diagonal().segment<3>(first).cwiseSqrt();
    }

    const std::vector<Observations>& takes_;
    const MotionSettings& settings_;
    MotionBody body_;
    MotionLayout layout_;
    MotionModel model_;
    ExpectedConstants expected_;
    std::vector<MotionEvidence> evidence_;
    MotionUnknowns start_;
    std::vector<BoardConstants> at_rest_;  ///< boards that the movement does not show well stay so
    std::vector<int> rest_of_node_;
};

bool MovementFitter::readTake(const Observations& take, MotionReport& report) {
    const StillStretch still = findStillStretch(take);
    if (!still.isUsable()) {
        report.findings.push_back({Grade::kNotUsable, "",
                                   take.take + ": there is no second of standing still to begin with",
                                   "Stand still in the rest pose for three seconds, then move"});
        return false;
    }
    evidence_.push_back(readMotion(take, still, settings_.step_s, settings_.longest_s));
    const MotionEvidence& evidence = evidence_.back();
    addEvidenceFindings(take, still, evidence, report.findings);
    report.moved_s += std::max(0, evidence.nodes - evidence.restNodes()) * evidence.step_s;
    report.rests += static_cast<int>(evidence.rests.size());
    report.distances += static_cast<int>(evidence.distances.size());
    for (size_t b = 0; b < still.boards.size(); ++b)
        if (still.boards[b].heard())
            report.boards[b].gyro_zero_counts = still.boards[b].gyro_counts;
    return evidence.nodes > 3;
}

bool MovementFitter::prepare(MotionReport& report) {
    for (const Observations& take : takes_)
        if (!readTake(take, report))
            return false;
    std::vector<Quaterniond> q_segment_board;
    for (const MotionEvidence& evidence : evidence_) {
        const int first = static_cast<int>(start_.nodes.size());
        appendFirstNodes(body_, model_, evidence, expected_, q_segment_board, start_.nodes);
        rest_of_node_.resize(start_.nodes.size(), first + evidence.rests.front().middle());
    }
    std::vector<int> board_segments;
    for (int b = 0; b < layout_.boards; ++b)
        board_segments.push_back(model_.boardSegment(b));
    addMovementFindings(settings_, body_, board_segments, start_.nodes, report.moved_s, report.findings);
    start_.boards = expected_.boards;
    for (size_t b = 0; b < start_.boards.size(); ++b)
        start_.boards[b].q_segment_board = q_segment_board[b];
    at_rest_ = start_.boards;
    for (size_t b = 0; b < at_rest_.size(); ++b)
        if (const BoardCalibration* known = takes_[0].calibration.findBoard(report.boards[b].id);
            known && isOfRestPose(*known))
            at_rest_[b].q_segment_board = *known->q_segment_board;
    start_.sources = expected_.sources;
    start_.bone_scale.assign(body_.bones().size(), 1);
    const auto is_about_movement = [](const Finding& finding) {
        return finding.grade == Grade::kNotUsable && finding.part.empty();
    };
    return std::ranges::none_of(report.findings, is_about_movement);
}

/// Whose movement it was that showed too little.
void MovementFitter::addUnsettled(const MotionFitResult& found, MotionReport& report) const {
    for (size_t b = 0; b < found.last_turn_rad.size(); ++b)
        if (found.last_turn_rad[b] > kUnsettled_rad)
            report.findings.push_back({Grade::kNotUsable, report.boards[b].id,
                                       boardName(takes_[0].suit, int(b)) +
                                           ", has not settled: the last step still turned it by " +
                                           text::number(degrees(found.last_turn_rad[b]), 1) + "°",
                                       howToMove(body_.segment(model_.boardSegment(static_cast<int>(b))))});
}

void MovementFitter::fillTissue(const MotionFitResult& found, int index, BoardInMotion& board) const {
    const auto b = static_cast<size_t>(index);
    const int segment = model_.boardSegment(index);
    const BodySegment& at = body_.segment(segment);
    board.flesh = BoardFlesh{
        {at.parent < 0 ? "" : at.name, at.first_child < 0 ? "" : body_.segment(at.first_child).name},
        found.unknowns.boards[b].tilt_rad,
        found.unknowns.boards[b].shift_m};
    std::vector<Vector3d> tilts;
    Vector3d mean = Vector3d::Zero();
    for (size_t k = 0; k < found.unknowns.nodes.size(); ++k) {
        const auto rest = static_cast<size_t>(rest_of_node_[k]);
        tilts.push_back(found.unknowns.boards[b].tilt_rad *
                        (jointFeatures(body_, found.unknowns.nodes[k], segment) -
                         jointFeatures(body_, found.unknowns.nodes[rest], segment)));
        mean += tilts.back() / static_cast<double>(found.unknowns.nodes.size());
    }
    double square = 0;
    for (const Vector3d& tilt : tilts)
        square += (tilt - mean).squaredNorm() / static_cast<double>(tilts.size());
    board.tissue_mean_rad = mean.norm();
    board.tissue_spread_rad = std::sqrt(square);
}

void MovementFitter::fillBoard(const MotionFitResult& found, int index, BoardInMotion& board) const {
    const auto b = static_cast<size_t>(index);
    const BoardConstants& constants = found.unknowns.boards[b];
    board.measured =
        std::ranges::all_of(evidence_, [b](const MotionEvidence& evidence) { return evidence.isHeard(b); });
    if (!board.measured)
        return;
    board.q_segment_board = constants.q_segment_board;
    const double prior_share = expected_.shareOfSigma(b);  // held fast: no surer than the rest pose
    board.sigma_turn_rad = sigma(found, layout_.mounting(index)) / prior_share;
    for (int axis = 0; axis < 3; ++axis)
        board.observed[axis] = board.sigma_turn_rad[axis] < kObservedShare * settings_.sigma_mounting_rad;
    const BoardCalibration* known = takes_[0].calibration.findBoard(board.id);
    board.turned_rad = angleBetween(
        constants.q_segment_board,
        known && known->q_segment_board ? *known->q_segment_board : takes_[0].suit.boards[b].q_segment_board);
    board.p_segment_board_m = constants.p_segment_board_m;
    board.sigma_place_m = sigma(found, layout_.place(index)) / prior_share;
    board.gyro_zero_rad_per_s = constants.gyro_zero_rad_per_s;
    board.accel_zero_m_per_s2 = constants.accel_zero_m_per_s2;
    if (settings_.flesh)
        fillTissue(found, index, board);
    const auto leftOver = [&](const MotionResidualSizes& sizes) {
        return LeftOver{sizes.gyro_rad[b], sizes.accel_m_per_s2[b], sizes.distance_m[b]};
    };
    board.before = leftOver(found.before);
    board.after = leftOver(found.after);
}

/// How boards move on their flesh is two thirds of all constants, so nine tenths of the time: what does not
/// depend on it is found before.
Result<MotionFitResult> MovementFitter::fitWithoutFlesh(const MotionUnknowns& start,
                                                        const JobContext& job) const {
    MotionSettings rough = settings_;
    rough.flesh = false;
    rough.most_iterations = kRoughIterations;
    const MotionLayout layout = layoutOf(false);
    const MotionModel model(body_, takes_[0], layout, settings_.step_s);
    return MotionFit(body_, model, layout, rough, evidence_, expected_).run(start, job);
}

Result<MotionFitResult> MovementFitter::fitFrom(MotionUnknowns start, MotionReport& report,
                                                const JobContext& job) const {
    std::optional<MotionResidualSizes> before;
    const double rough_share = settings_.flesh ? kRoughShare : 0;
    if (settings_.flesh) {
        auto rough = fitWithoutFlesh(start, StagedProgress(job, 0, rough_share).job());
        if (!rough)
            return rough.error();
        start = std::move(rough->unknowns);
        before = rough->before;
    }
    MotionFit fit(body_, model_, layout_, settings_, evidence_, expected_);
    auto found = fit.run(std::move(start), StagedProgress(job, rough_share, kFirstShare).job());
    if (!found)
        return found.error();
    found->before = before.value_or(found->before);
    report.iterations += found->iterations;
    if (found->converged)
        return found;
    // Turns that the movement shows weakly settle last, by a third in each step: they get as many again.
    auto more = fit.run(std::move(found->unknowns), StagedProgress(job, kFirstShare, 1).job());
    if (!more)
        return more.error();
    report.iterations += more->iterations;
    more->before = found->before;
    return more;
}

/// Boards as the suit has them, not as they hung in the rest pose; segments lie as these say.
MotionUnknowns MovementFitter::startAsWorn() const {
    MotionUnknowns start = start_;
    std::vector<bool> turned(static_cast<size_t>(body_.size()), false);
    for (size_t b = 0; b < start.boards.size(); ++b) {
        const Quaterniond before = start.boards[b].q_segment_board;
        start.boards[b] = expected_.boards[b];
        const auto s = static_cast<size_t>(model_.boardSegment(static_cast<int>(b)));
        if (turned[s])
            continue;
        turned[s] = true;
        const Matrix3d turn = (before * start.boards[b].q_segment_board.conjugate()).toRotationMatrix();
        for (MotionNode& node : start.nodes)
            node.R_world_segment[s] = node.R_world_segment[s] * turn;
    }
    return start;
}

/// Boards that a fit has turned farther than straps turn them, from where the suit has them and from where
/// they hung in the rest pose. The latter alone is no measure: there a board takes the blame for every joint
/// of its limb.
std::vector<int> MovementFitter::strayBoards(const MotionFitResult& found) const {
    std::vector<int> stray;
    for (int b = 0; b < layout_.boards; ++b) {
        const auto board = static_cast<size_t>(b);
        const Quaterniond& q = found.unknowns.boards[board].q_segment_board;
        if (std::min(angleBetween(q, expected_.boards[board].q_segment_board),
                     angleBetween(q, at_rest_[board].q_segment_board)) >
            kStraySigma * settings_.sigma_mounting_rad)
            stray.push_back(b);
    }
    return stray;
}

/// From the rest pose, and where that does not end well from the suit's mountings as well: the better end.
Result<MotionFitResult> MovementFitter::fitFromSeveral(MotionReport& report, const JobContext& job) const {
    auto found = fitFrom(start_, report, StagedProgress(job, 0, kFromRest).job());
    if (!found || (found->converged && strayBoards(*found).empty()))
        return found;
    auto other = fitFrom(startAsWorn(), report, StagedProgress(job, kFromRest, 1).job());
    if (!other)
        return other.error();
    const bool better = other->converged != found->converged ? other->converged : other->cost < found->cost;
    return better ? std::move(other) : std::move(found);
}

/// Boards that are better as they hung in the rest pose, on seconds that were held out.
Result<std::vector<int>> MovementFitter::worseBoards(const MotionFitResult& found, MotionReport& report,
                                                     const JobContext& job) const {
    MotionUnknowns rest = start_;
    rest.boards = at_rest_;
    const auto check =
        checkOnHeldOut({body_, model_, layout_, settings_, evidence_, expected_, rest, found.unknowns}, job);
    if (!check)
        return check.error();
    std::vector<int> worse;
    for (int b = 0; b < layout_.boards; ++b) {
        const double ratio = check->cost_ratio[static_cast<size_t>(b)];
        if (ratio <= kWorse)
            continue;
        worse.push_back(b);
        report.findings.push_back({Grade::kUsable, report.boards[static_cast<size_t>(b)].id,
                                   boardName(takes_[0].suit, b) +
                                       ", keeps its place of the rest pose: with the one that the movement "
                                       "gave it, seconds that were held out fit worse by " +
                                       text::number(100 * (ratio - 1), 0) + " %",
                                   howToMove(body_.segment(model_.boardSegment(b)))});
    }
    return worse;
}

/// These boards stay as they hung in the rest pose, and the others are fitted anew.
Result<MotionFitResult> MovementFitter::fitWithout(const std::vector<int>& boards,
                                                   const MotionFitResult& found, MotionReport& report,
                                                   const JobContext& job) {
    expected_.held_fast.resize(static_cast<size_t>(layout_.boards), false);
    MotionUnknowns start = found.unknowns;
    for (const int board : boards) {
        const auto b = static_cast<size_t>(board);
        expected_.held_fast[b] = true;
        expected_.boards[b] = start.boards[b] = at_rest_[b];
    }
    MotionFit fit(body_, model_, layout_, settings_, evidence_, expected_);
    auto again = fit.run(std::move(start), job);
    if (!again)
        return again.error();
    report.iterations += again->iterations;
    again->before = found.before;
    return again;
}

Status MovementFitter::fit(MotionReport& report, const JobContext& job) {
    auto found = fitFromSeveral(report, StagedProgress(job, 0, kFitShare).job());
    if (!found)
        return found.error();
    std::vector<int> kept;
    if (found->converged) {
        auto worse = worseBoards(*found, report, StagedProgress(job, kFitShare, kCheckShare).job());
        if (!worse)
            return worse.error();
        kept = std::move(*worse);
    }
    for (int b = 0; b < layout_.boards; ++b) {
        const bool unsettled =
            !found->converged && found->last_turn_rad[static_cast<size_t>(b)] > kUnsettled_rad;
        const bool stray = std::ranges::count(strayBoards(*found), b) > 0;
        if ((!unsettled && !stray) || std::ranges::count(kept, b) > 0)
            continue;
        kept.push_back(b);
        report.findings.push_back(
            {Grade::kUsable, report.boards[static_cast<size_t>(b)].id,
             boardName(takes_[0].suit, b) +
                 (stray ? ", keeps its place of the rest pose: the movement would turn it farther than a "
                          "strap can"
                        : ", keeps its place of the rest pose: the movement does not settle it"),
             howToMove(body_.segment(model_.boardSegment(b)))});
    }
    const bool too_many = static_cast<double>(kept.size()) > kMostKept * layout_.boards;
    if (!kept.empty() && !too_many) {
        found = fitWithout(kept, *found, report, StagedProgress(job, kCheckShare, 1).job());
        if (!found)
            return found.error();
    }
    report.converged = found->converged && !too_many;
    if (report.converged)
        fill(*found, report);
    else
        addUnsettled(*found, report);
    return Done{};
}

void MovementFitter::fill(const MotionFitResult& found, MotionReport& report) const {
    for (int b = 0; b < layout_.boards; ++b)
        fillBoard(found, b, report.boards[static_cast<size_t>(b)]);
    const auto sigmaOf = [&](int column) { return std::sqrt(found.cov_border(column, column)); };
    for (int s = 0; s < layout_.sources && report.distances > 0; ++s) {
        const SourceConstants& source = found.unknowns.sources[static_cast<size_t>(s)];
        report.sources.push_back({takes_[0].suit.sources[static_cast<size_t>(s)].id,
                                  source.p_segment_source_m, sigma(found, layout_.source(s)), source.offset_m,
                                  sigmaOf(layout_.offset(s))});
    }
    for (int bone = 0; bone < layout_.bones; ++bone)
        report.bones.push_back({takes_[0].actor.skeleton.joint(body_.bones()[static_cast<size_t>(bone)]).name,
                                found.unknowns.bone_scale[static_cast<size_t>(bone)],
                                sigmaOf(layout_.bone(bone))});
    report.sound_scale = 1 / found.unknowns.sound_scale;
    report.sigma_sound_scale = sigmaOf(layout_.soundScale());
}

}  // namespace

Result<MotionReport> calibrateMotion(const std::vector<Observations>& takes, const MotionSettings& settings,
                                     const JobContext& job) {
    require(!takes.empty(), "a calibration from motion without takes");
    MotionReport report;
    report.detector = takes[0].detector;
    for (const Board& board : takes[0].suit.boards) {
        report.boards.emplace_back();
        report.boards.back().id = board.id;
    }
    if (!takes[0].flights.empty())
        report.c_m_per_s = takes[0].flights.front().c_m_per_s;
    if (takes[0].actor.skeleton.size() == 0 || !isOnBody(takes[0])) {
        report.findings.push_back({Grade::kNotUsable, "",
                                   takes[0].take + ": a board or source is not on the performer's body",
                                   "Record with the suit worn, and with an actor that has its segments"});
        return report;
    }
    MovementFitter fitter(takes, settings);
    if (!fitter.prepare(report))
        return report;
    if (const Status fitted = fitter.fit(report, job); !fitted)
        return fitted.error();
    addResultFindings(takes[0], report, report.findings);
    job.progress(1, "Movement");
    return report;
}

}  // namespace noctule
