// SPDX-License-Identifier: Apache-2.0
#include "core/live/readiness.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/job/contract.h"

namespace noctule {
namespace {

constexpr int64_t kNever = -1;

void addProblem(Readiness& readiness, ProblemKind kind, bool hinders, double value = 0, int board = -1,
                int source = -1) {
    readiness.problems.push_back({kind, hinders, board, source, value, false});
}

constexpr int kFewAlike = 3;

/// Board problems and source problems of one kind that befall more than half become one: their common cause
/// is the link, the computer or the box, not each plug.
void joinAlike(Readiness& readiness, int ReadinessProblem::*part, int parts) {
    std::map<ProblemKind, std::vector<int>> alike;
    for (const ReadinessProblem& problem : readiness.problems)
        if (problem.*part >= 0)
            alike[problem.kind].push_back(problem.*part);
    for (auto& [kind, sufferers] : alike) {
        const auto count = static_cast<int>(sufferers.size());
        if (count < kFewAlike || 2 * count <= parts)
            continue;
        ReadinessProblem joined;
        joined.kind = kind;
        for (const ReadinessProblem& problem : readiness.problems)
            if (problem.kind == kind) {
                joined.hinders = problem.hinders;
                joined.value += problem.value / count;
            }
        joined.alike = std::move(sufferers);
        std::erase_if(readiness.problems,
                      [kind = kind](const ReadinessProblem& problem) { return problem.kind == kind; });
        readiness.problems.push_back(std::move(joined));
    }
}

/// What most boards do not deliver cannot tell what they hear: silent sources then follow from it, and
/// without any source it hinders. That no board hears a source follows from silent sources.
void forgetConsequences(Readiness& readiness, int source_count) {
    const bool no_source = source_count > 0 && readiness.sources_heard == 0;
    bool stream_is_poor = false;
    for (ReadinessProblem& problem : readiness.problems) {
        const bool of_stream = !problem.alike.empty() && (problem.kind == ProblemKind::kBoardSilent ||
                                                          problem.kind == ProblemKind::kBoardUnreadable ||
                                                          problem.kind == ProblemKind::kBoardLosesFrames);
        stream_is_poor = stream_is_poor || of_stream;
        problem.hinders = problem.hinders || (of_stream && no_source);
    }
    if (stream_is_poor)
        std::erase_if(readiness.problems, [](const ReadinessProblem& problem) {
            return problem.kind == ProblemKind::kSourceSilent || problem.kind == ProblemKind::kSourceFaint ||
                   problem.kind == ProblemKind::kBoardDeaf;
        });
    if (no_source)
        std::erase_if(readiness.problems, [](const ReadinessProblem& problem) {
            return problem.kind == ProblemKind::kBoardDeaf;
        });
}

/// All of a joined problem must be accepted.
bool isAccepted(const ReadinessProblem& problem, const ReadinessFacts& facts) {
    const auto& without =
        problem.kind == ProblemKind::kSourceSilent || problem.kind == ProblemKind::kSourceFaint
            ? facts.without_sources
            : facts.without_boards;
    if (!problem.alike.empty())
        return std::ranges::all_of(problem.alike, [&](int part) { return without.contains(part); });
    return facts.without_boards.contains(problem.board) || facts.without_sources.contains(problem.source);
}

}  // namespace

ReadinessJudge::ReadinessJudge(int board_count, int source_count, int sample_rate_hz,
                               const ReadinessLimits& limits)
    : board_count_(board_count),
      source_count_(source_count),
      sample_rate_hz_(sample_rate_hz),
      limits_(limits) {
    remember({});
}

/// A new stream counts from 0 again.
void ReadinessJudge::remember(const HealthReport& health) {
    if (health.sample < now_ || pair_good_at_.empty()) {
        pair_good_at_.assign(static_cast<size_t>(board_count_) * static_cast<size_t>(source_count_), kNever);
        board_heard_at_.assign(static_cast<size_t>(board_count_), 0);
        board_whole_at_ = board_heard_at_;
        source_heard_at_.assign(static_cast<size_t>(source_count_), 0);
        source_clear_at_ = source_heard_at_;
    }
    now_ = health.sample;
    for (size_t board = 0; board < health.boards.size(); ++board)
        if (health.boards[board].frames_per_s >= limits_.least_frames_per_s)
            board_whole_at_[board] = now_;
    if (health.pairs.empty())
        return;
    for (int source = 0; source < source_count_; ++source)
        for (int board = 0; board < board_count_; ++board) {
            const PairHealth& pair = health.pair(source, board);
            if (!pair.age_s)
                continue;
            const int64_t at = now_ - static_cast<int64_t>(*pair.age_s * sample_rate_hz_);
            const auto raise = [at](int64_t& last) { last = std::max(last, at); };
            if (pair.confidence >= limits_.good_confidence)
                raise(pair_good_at_[static_cast<size_t>(source * board_count_ + board)]);
            // A pose that is wrong refuses ranges; the sources sound all the same.
            if (pair.heard >= limits_.faint_confidence)
                raise(source_clear_at_[static_cast<size_t>(source)]);
            if (pair.heard >= limits_.heard_confidence) {
                raise(source_heard_at_[static_cast<size_t>(source)]);
                raise(board_heard_at_[static_cast<size_t>(board)]);
            }
        }
}

/// Nothing came while the link was broken, which is no fault of boards and sources: they get their time anew.
void ReadinessJudge::forgive() {
    for (auto* times : {&board_heard_at_, &board_whole_at_, &source_heard_at_, &source_clear_at_})
        for (int64_t& at : *times)
            at = std::max(at, now_);
}

void ReadinessJudge::judgeFit(const ReadinessFacts& facts, Readiness& readiness) const {
    readiness.lack = facts.lack;
    readiness.is_room = facts.is_room;
    if (!facts.lack.isNone())
        addProblem(readiness, ProblemKind::kNotCalibrated, false);
    judgeSteps(facts, readiness);
    if (facts.lack.isNone() && !facts.is_room)
        judgeWearing(facts, readiness);
}

void ReadinessJudge::judgeSteps(const ReadinessFacts& facts, Readiness& readiness) const {
    for (const CalibrationStepState& state : facts.steps) {
        const bool is_old = state.isOld() && !isOfWearing(state.step);
        if (!state.isNotUsable() && !is_old)
            continue;
        const bool is_unusable = state.isNotUsable();
        addProblem(readiness, is_unusable ? ProblemKind::kStepNotUsable : ProblemKind::kStepOld, false,
                   is_unusable ? 0 : state.age_h);
        readiness.problems.back().step = state.step;
    }
}

/// A rest pose that is not usable tells nothing of where boards sit: its own card is enough.
void ReadinessJudge::judgeWearing(const ReadinessFacts& facts, Readiness& readiness) const {
    const auto rest_pose =
        std::ranges::find(facts.steps, CalibrationStep::kRestPose, &CalibrationStepState::step);
    const bool is_stated = rest_pose != facts.steps.end();
    if (facts.fit == SuitFit::kChecked || (is_stated && rest_pose->isNotUsable()))
        return;
    if (facts.fit == SuitFit::kMoved)
        return addProblem(readiness, ProblemKind::kMoved, false);
    if (!is_stated || !rest_pose->isOld())
        return addProblem(readiness, ProblemKind::kNotChecked, false);
    addProblem(readiness, ProblemKind::kRestPoseOld, false, rest_pose->age_h);
    readiness.problems.back().step = CalibrationStep::kRestPose;
}

double ReadinessJudge::secondsSince(int64_t sample) const {
    return static_cast<double>(now_ - sample) / sample_rate_hz_;
}

void ReadinessJudge::judgePairs(const HealthReport& health, Readiness& readiness) const {
    readiness.pair_is_good.assign(pair_good_at_.size(), false);
    for (size_t pair = 0; pair < pair_good_at_.size(); ++pair) {
        const bool good =
            pair_good_at_[pair] != kNever && secondsSince(pair_good_at_[pair]) <= limits_.pair_holds_s;
        const size_t board = pair % static_cast<size_t>(board_count_);
        if (!good || health.boards[board].silent)
            continue;
        readiness.pair_is_good[pair] = true;
        ++readiness.good_pairs;
        ++readiness.boards[board].good_pairs;
        ++readiness.source_good_pairs[pair / static_cast<size_t>(board_count_)];
    }
}

void ReadinessJudge::judgeBoard(const ReadinessFacts& facts, int board, Readiness& readiness) const {
    const auto index = static_cast<size_t>(board);
    const BoardHealth& health = facts.health->boards[index];
    BoardReadiness& state = readiness.boards[index];
    const bool unplugged = index < facts.board_is_plugged.size() && !facts.board_is_plugged[index];
    if (unplugged || health.silent) {
        state = {BoardReadiness::State::kSilent, 0};
        return addProblem(readiness, ProblemKind::kBoardSilent, true, 0, board);
    }
    ++readiness.boards_there;
    state.state = BoardReadiness::State::kPoor;
    const bool poor = secondsSince(board_whole_at_[index]) > limits_.frames_poor_s;
    if (poor && health.frames_per_s < limits_.readable_frames_per_s)
        return addProblem(readiness, ProblemKind::kBoardUnreadable, true, health.frames_per_s, board);
    if (poor)
        return addProblem(readiness, ProblemKind::kBoardLosesFrames, false, health.frames_per_s, board);
    const int64_t clipped = std::max(health.clipped_samples, health.clipped_readings);
    if (clipped > limits_.clipped_per_s)
        return addProblem(readiness, ProblemKind::kBoardClips, false, static_cast<double>(clipped), board);
    if (!facts.is_room && secondsSince(board_heard_at_[index]) > limits_.board_unheard_s)
        return addProblem(readiness, ProblemKind::kBoardDeaf, false, 0, board);
    state.state = BoardReadiness::State::kFine;
}

void ReadinessJudge::judgeSources(const HealthReport& health, Readiness& readiness) const {
    if (std::ranges::all_of(health.boards, &BoardHealth::silent))
        return;
    const auto is_clear = [this](int source) {
        return secondsSince(source_clear_at_[static_cast<size_t>(source)]) <= limits_.source_unheard_s;
    };
    const auto is_heard = [this](int source) {
        return secondsSince(source_heard_at_[static_cast<size_t>(source)]) <= limits_.source_unheard_s;
    };
    int clear = 0;
    for (int source = 0; source < source_count_; ++source) {
        clear += is_clear(source);
        readiness.sources_heard += is_heard(source);
    }
    const bool none = readiness.sources_heard == 0;  // then nothing is known of distances
    for (int source = 0; source < source_count_; ++source) {
        const auto index = static_cast<size_t>(source);
        if (!is_heard(source))
            addProblem(readiness, ProblemKind::kSourceSilent, none, 0, -1, source);
        else if (!is_clear(source) && 2 * clear >= source_count_)
            addProblem(readiness, ProblemKind::kSourceFaint, false, readiness.source_good_pairs[index], -1,
                       source);
    }
}

void ReadinessJudge::judgeSupplies(const ReadinessFacts& facts, Readiness& readiness) const {
    const auto& percent = facts.health->suit.battery_percent;
    if (percent && *percent <= limits_.battery_empty_percent)
        addProblem(readiness, ProblemKind::kBatteryEmpty, true, *percent);
    else if (percent && *percent <= limits_.battery_low_percent)
        addProblem(readiness, ProblemKind::kBatteryLow, false, *percent);
    const auto& storage_s = facts.storage_left_s;
    if (storage_s && *storage_s < limits_.storage_short_s)
        addProblem(readiness, ProblemKind::kStorageShort, *storage_s < limits_.storage_empty_s, *storage_s);
}

bool Readiness::isFit() const {
    return std::ranges::none_of(problems, [](const ReadinessProblem& problem) {
        return problem.kind == ProblemKind::kNotCalibrated || problem.kind == ProblemKind::kStepNotUsable ||
               problem.kind == ProblemKind::kMoved || problem.kind == ProblemKind::kRestPoseOld ||
               problem.kind == ProblemKind::kNotChecked;
    });
}

Readiness ReadinessJudge::judge(const ReadinessFacts& facts) {
    Readiness readiness;
    readiness.boards.resize(static_cast<size_t>(board_count_));
    readiness.source_good_pairs.resize(static_cast<size_t>(source_count_));
    readiness.pair_is_good.resize(pair_good_at_.size());
    if (facts.link_is_lost || facts.sound_stalls) {
        addProblem(readiness, facts.link_is_lost ? ProblemKind::kLinkLost : ProblemKind::kNoSound, true);
        readiness.verdict = Readiness::Verdict::kNotReady;
        was_broken_ = true;
        return readiness;
    }
    if (!facts.health)
        return readiness;
    require(facts.health->boards.size() == static_cast<size_t>(board_count_), "the health of another suit");
    remember(*facts.health);
    if (std::exchange(was_broken_, false))
        forgive();
    if (secondsSince(0) < limits_.settles_s)
        return readiness;
    judgePairs(*facts.health, readiness);
    for (int board = 0; board < board_count_; ++board)
        judgeBoard(facts, board, readiness);
    judgeSources(*facts.health, readiness);
    if (facts.is_room)
        std::erase_if(readiness.problems,
                      [](const ReadinessProblem& problem) { return problem.source >= 0; });
    judgeSupplies(facts, readiness);
    joinAlike(readiness, &ReadinessProblem::board, board_count_);
    joinAlike(readiness, &ReadinessProblem::source, source_count_);
    forgetConsequences(readiness, source_count_);
    judgeFit(facts, readiness);
    if (!facts.is_assigned && !facts.is_room)
        addProblem(readiness, ProblemKind::kNotAssigned, false);
    bool hindered = false;
    for (ReadinessProblem& problem : readiness.problems) {
        problem.accepted = isAccepted(problem, facts);
        hindered = hindered || (problem.hinders && !problem.accepted);
    }
    std::ranges::stable_sort(readiness.problems, {}, [](const ReadinessProblem& problem) {
        return std::tuple(problem.accepted, !problem.hinders, problem.kind);
    });
    readiness.verdict = hindered ? Readiness::Verdict::kNotReady : Readiness::Verdict::kReady;
    return readiness;
}

}  // namespace noctule
