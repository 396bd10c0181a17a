// SPDX-License-Identifier: Apache-2.0
#include "ui/models/suit_check.h"

namespace noctule::ui {
namespace {

constexpr int kJudgeEvery_ms = 200;

}  // namespace

SuitCheck::SuitCheck(LiveSuit& suit, std::function<std::optional<double>()> storage_left_s, QObject* parent)
    : QObject(parent), suit_(suit), storage_left_s_(std::move(storage_left_s)) {
    clock_.start();
    timer_.setInterval(kJudgeEvery_ms);
    connect(&timer_, &QTimer::timeout, this, &SuitCheck::judge);
    connect(&suit_, &LiveSuit::phaseChanged, this, &SuitCheck::follow);
    connect(&suit_, &LiveSuit::wearingChanged, this, &SuitCheck::judge);
}

void SuitCheck::follow() {
    const auto hello = suit_.status()->hello;
    const bool connected = suit_.phase() != LiveSuit::Phase::kNone && hello;
    if (!connected) {
        timer_.stop();
        judge_.reset();
        readiness_ = {};
        serial_.clear();
        emit changed();
    } else if (!judge_ || serial_ != hello->serial) {
        serial_ = hello->serial;
        judge_ = std::make_unique<ReadinessJudge>(
            hello->boardCount(), static_cast<int>(hello->suit.sources.size()), hello->sample_rate_hz);
        without_boards_.clear();
        without_sources_.clear();
        silent_since_.assign(hello->suit.boards.size(), {});
        was_heard_.assign(hello->suit.boards.size(), false);
        battery_ = {};
        nothing_since_ = {};
        is_lost_ = false;
        rate_from_sample_ = -1;
        bytes_per_s_.reset();
        timer_.start();
        judge();
    }
}

void SuitCheck::judge() {
    if (!judge_)
        return;
    measureRate();
    const auto status = suit_.status();
    const auto frame = suit_.frame();
    ReadinessFacts facts;
    facts.link_is_lost = status->link == LinkState::kLost;
    facts.sound_stalls = status->link == LinkState::kStalled;
    facts.is_assigned = suit_.wearing().is_assigned;
    facts.is_room = suit_.suit().isFixed();
    for (const uint16_t flags : status->board_flags)
        facts.board_is_plugged.push_back(flags & link::kBoardConnected);
    facts.storage_left_s = storage_left_s_();
    addFit(facts);
    facts.without_boards = without_boards_;
    facts.without_sources = without_sources_;
    if (frame && frame->health.boards.size() == silent_since_.size())
        facts.health = &frame->health;
    if (frame && frame->health.suit.battery_percent)
        battery_.add(static_cast<double>(clock_.elapsed()) * 1e-3, *frame->health.suit.battery_percent);
    Readiness now = judge_->judge(facts);
    // Between two streams nothing is known for a moment; what was known still holds.
    if (now.verdict == Readiness::Verdict::kWaiting && !readiness_.boards.empty() &&
        readiness_.verdict != Readiness::Verdict::kWaiting && !nothing_since_.isValid())
        return emit changed();
    readiness_ = std::move(now);
    noteTimes();
    forgetAccepted();
    emit changed();
}

void SuitCheck::addFit(ReadinessFacts& facts) const {
    const auto& calibration = suit_.calibration();
    facts.lack = lackOf(suit_.suit(), calibration.value_or(Calibration{}));
    // Its places and values are those of the simulation: no check could find anything.
    if (suit_.isKnownExactly())
        return;
    facts.fit = !checked_ ? SuitFit::kUnchecked : *checked_ ? SuitFit::kChecked : SuitFit::kMoved;
    for (const CalibrationStep step : kCalibrationSteps)
        if (calibration && (!facts.is_room || step == CalibrationStep::kSources))
            facts.steps.push_back(agedStep(step, suit_.suit(), *calibration, QDateTime::currentDateTime()));
}

QDateTime madeAt(const CalibrationStepState& state) {
    return QDateTime::fromString(QString::fromStdString(state.oldest_utc), Qt::ISODate);
}

CalibrationStepState agedStep(CalibrationStep step, const Suit& suit, const Calibration& calibration,
                              const QDateTime& now) {
    CalibrationStepState state = stateOfStep(step, suit, calibration);
    if (const QDateTime made = madeAt(state); made.isValid())
        state.age_h = static_cast<double>(made.secsTo(now)) / 3600;
    return state;
}

QDateTime SuitCheck::restPoseMade() const {
    return madeAt(
        stateOfStep(CalibrationStep::kRestPose, suit_.suit(), suit_.calibration().value_or(Calibration{})));
}

void SuitCheck::setChecked(std::optional<bool> is_good) {
    checked_ = is_good;
    judge();
}

/// Each stream and each take counts its samples anew: from one to the other they jump, back or ahead.
void SuitCheck::measureRate() {
    constexpr qint64 kOver_ms = 900;
    const auto hello = suit_.status()->hello;
    const int64_t sample = suit_.reachedSample();
    if (!hello || sample <= 0 || suit_.isSilent() || sample < rate_from_sample_) {
        rate_from_sample_ = -1;
        bytes_per_s_.reset();
    } else if (rate_from_sample_ < 0) {
        rate_from_sample_ = sample;
        rate_clock_.start();
    } else if (rate_clock_.elapsed() > kOver_ms) {
        const double seconds = static_cast<double>(rate_clock_.restart()) * 1e-3;
        const auto samples = static_cast<double>(sample - rate_from_sample_);
        bytes_per_s_.reset();
        if (samples > 0 && samples < 2.0 * hello->sample_rate_hz * seconds)
            bytes_per_s_ = 2.0 * hello->boardCount() * samples / seconds;
        rate_from_sample_ = sample;
    }
}

void SuitCheck::noteTimes() {
    is_lost_ = suit_.isLost();
    const bool nothing = suit_.isSilent();
    if (nothing != nothing_since_.isValid())
        nothing_since_ = nothing ? QTime::currentTime() : QTime();
    for (size_t board = 0; board < readiness_.boards.size() && !nothing; ++board) {
        const auto state = readiness_.boards[board].state;
        const bool silent = state == BoardReadiness::State::kSilent;
        if (!silent)
            silent_since_[board] = {};
        else if (was_heard_[board])
            silent_since_[board] = QTime::currentTime();
        was_heard_[board] = state == BoardReadiness::State::kFine || state == BoardReadiness::State::kPoor;
    }
}

void SuitCheck::forgetAccepted() {
    if (readiness_.verdict == Readiness::Verdict::kWaiting || nothing_since_.isValid())
        return;
    std::set<int> boards, sources;
    for (const ReadinessProblem& problem : readiness_.problems) {
        const bool of_sources =
            problem.kind == ProblemKind::kSourceSilent || problem.kind == ProblemKind::kSourceFaint;
        (of_sources ? sources : boards).insert(problem.alike.begin(), problem.alike.end());
        boards.insert(problem.board);
        sources.insert(problem.source);
    }
    std::erase_if(without_boards_, [&](int board) { return !boards.contains(board); });
    std::erase_if(without_sources_, [&](int source) { return !sources.contains(source); });
}

QTime SuitCheck::silentSince(int board) const {
    return board >= 0 && static_cast<size_t>(board) < silent_since_.size()
               ? silent_since_[static_cast<size_t>(board)]
               : QTime();
}

void SuitCheck::goOnWithout(const ReadinessProblem& problem) {
    const bool of_sources =
        problem.kind == ProblemKind::kSourceSilent || problem.kind == ProblemKind::kSourceFaint;
    (of_sources ? without_sources_ : without_boards_).insert(problem.alike.begin(), problem.alike.end());
    if (problem.board >= 0)
        without_boards_.insert(problem.board);
    if (problem.source >= 0)
        without_sources_.insert(problem.source);
    judge();
}

}  // namespace noctule::ui
