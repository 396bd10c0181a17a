// SPDX-License-Identifier: Apache-2.0
#include "core/guide/field_guide.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kLeastSpot_s = 3;
/// Turned further, the sensors' own iron, of some 10 uT before they are calibrated, looks like a bent field.
constexpr double kMostTurned_deg = 15;
/// Of a second's specific force: above the first while it is carried about, above the second while it is
/// lowered by an arm's length, and below that in a calm hand.
constexpr double kCarried_m_per_s2 = 0.2, kLowered_m_per_s2 = 0.35, kCalm_s = 1.2;
/// Of what the spot is judged by. A suit that lies still sees one place only, and says nothing of the spot.
constexpr double kLeastMoving = 0.2;
constexpr double kStale_s = 1;    ///< without a reading, of seven a second
constexpr int kJudgedAtOnce = 1;  ///< of the boards, ten times a second: a fit takes a millisecond

/// Of the board that was tilted most, as accelerometers feel it; they need no calibration for that.
double tiltBetween_deg(const SpotMoment& before, const SpotMoment& now) {
    double most_rad = 0;
    for (size_t board = 0; board < std::min(before.up.size(), now.up.size()); ++board)
        if (before.up[board] && now.up[board] && before.up[board]->norm() > 1 && now.up[board]->norm() > 1)
            most_rad = std::max(most_rad, angleBetween(Quaterniond::Identity(),
                                                       smallestRotation(*before.up[board], *now.up[board])));
    return degrees(most_rad);
}

}  // namespace

FieldGuide::FieldGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz)
    : Guide(suit, calibration, sample_rate_hz, kSteps),
      rate_hz_(sample_rate_hz),
      turns_(suit.boards.size()),
      heard_(suit.boards.size()),
      iron_(suit.boards.size()) {
    for (int board = 0; board < boardCount(); ++board)
        if (!suit.boards[index(board)].has_magnetometer)
            skip(board, true);
}

FieldSphere FieldGuide::sphere() const {
    FieldSphere least;
    bool is_first = true;
    for (int board = 0; board < boardCount(); ++board) {
        if (!asks(board))
            continue;
        if (std::exchange(is_first, false))
            least = turnOf(board).sphere();
        else
            least.keepLesser(turnOf(board).sphere());
    }
    return least;
}

int FieldGuide::leastBoard() const {
    int least = -1;
    for (int board = 0; board < boardCount(); ++board)
        if (asks(board) && (least < 0 || turnOf(board).sphere().seen() < turnOf(least).sphere().seen()))
            least = board;
    return least;
}

double FieldGuide::leastShare() const {
    const int least = leastBoard();
    return least < 0 ? 0 : turnOf(least).sphere().share();
}

int FieldGuide::enoughBoards() const {
    int enough = 0;
    for (int board = 0; board < boardCount(); ++board)
        enough += asks(board) && turnOf(board).state() == FieldTurnState::kDone;
    return enough;
}

void FieldGuide::startAnew(int board) {
    turns_[index(board)].clear();
    heard_[index(board)].clear();
    iron_[index(board)] = false;
    setDone(kTurn, board, false);
}

void FieldGuide::leaveOutFloor() {
    for (int board = 0; board < boardCount(); ++board)
        setDone(kFloor, board);
}

void FieldGuide::give(int board, const std::vector<FieldReading>& readings) {
    turns_[index(board)].clear();
    heard_[index(board)] = readings;
    for (const FieldReading& reading : readings)
        turns_[index(board)].add(reading.field_ut());
    turns_[index(board)].judge();
    findIron();
}

void FieldGuide::learn(int step, const HealthReport&) {
    if (step == kSpot)
        at_spot_ = momentsSince(0);
    moments_.clear();
    was_lowered_ = false;
    calm_since_ = -1;
}

void FieldGuide::unlearn(int step) {
    moments_.clear();
    was_lowered_ = false;
    if (step == kFloor)
        spot_.floor_percent.reset();
    for (int board = 0; step == kTurn && board < boardCount(); ++board)
        startAnew(board);
}

/// A magnetometer that has fallen silent leaves its last reading behind.
bool FieldGuide::isHeardNow(const HealthReport& health, int board) const {
    const BoardHealth& now = health.boards[index(board)];
    return asks(board) && !now.silent && now.field &&
           now.field->sample > static_cast<double>(health.sample) - kStale_s * rate_hz_;
}

bool FieldGuide::moves(const HealthReport& health, double limit_m_per_s2) const {
    double most_m_per_s2 = 0;
    for (int board = 0; board < boardCount(); ++board)
        if (const auto& means = health.boards[index(board)].means; asks(board) && means)
            most_m_per_s2 = std::max(most_m_per_s2, means->accel_deviation_m_per_s2);
    return most_m_per_s2 > limit_m_per_s2;
}

bool FieldGuide::collect(const HealthReport& health, int step) {
    SpotMoment moment{std::vector<std::optional<Vector3d>>(turns_.size()),
                      std::vector<std::optional<Vector3d>>(turns_.size())};
    bool any = false;
    turning_deg_per_s_ = 0;
    for (int board = 0; board < boardCount(); ++board) {
        if (!isHeardNow(health, board))
            continue;
        const BoardHealth& now = health.boards[index(board)];
        any = true;
        if (now.means) {
            const Vector3d rate = calibrationOf(board).gyro.apply(now.means->gyro_counts);
            turning_deg_per_s_ = std::max(turning_deg_per_s_, degrees(rate.norm()));
            moment.up[index(board)] = calibrationOf(board).accel.apply(now.means->accel_counts);
        }
        const FieldReading reading{now.field->sample, now.field->counts};
        moment.field_ut[index(board)] =
            calibrationOf(board).mag ? calibrationOf(board).mag->apply(reading.counts) : reading.field_ut();
        std::vector<FieldReading>& heard = heard_[index(board)];
        if (step == kTurn && (heard.empty() || heard.back().sample != reading.sample)) {
            heard.push_back(reading);
            turns_[index(board)].add(reading.field_ut());
        }
    }
    if (any && step != kTurn)
        moments_.push_back({health.sample, moves(health, kCarried_m_per_s2), std::move(moment)});
    const auto window = static_cast<int64_t>(kSpotWindow_s * rate_hz_);
    while (!moments_.empty() &&
           (moments_.front().sample < health.sample - window || moments_.front().sample > health.sample))
        moments_.pop_front();
    return any;
}

/// In turn, so that fits of many boards do not hold up the screen.
void FieldGuide::judgeSome() {
    for (int n = 0; n < std::min(kJudgedAtOnce, boardCount()); ++n) {
        judged_ = (judged_ + 1) % boardCount();
        if (asks(judged_))
            turns_[index(judged_)].judge();
    }
    findIron();
}

void FieldGuide::findIron() {
    std::vector<std::optional<double>> uneven(turns_.size());
    for (int board = 0; board < boardCount(); ++board)
        if (asks(board))
            uneven[index(board)] = turnOf(board).uneven_percent();
    iron_ = carriesIron(uneven);
}

std::vector<SpotMoment> FieldGuide::momentsSince(int64_t sample) {
    std::vector<SpotMoment> moments;
    for (const Moment& moment : moments_)
        if (moment.sample >= sample)
            moments.push_back(moment.moment);
    return moments;
}

std::optional<double> FieldGuide::strongerNow_percent() const {
    if (moments_.empty())
        return std::nullopt;
    const std::vector<SpotMoment> now{moments_.back().moment};
    if (!at_spot_.empty())
        return strongerBy_percent(at_spot_, now);
    std::vector<SpotMoment> all;
    for (const Moment& moment : moments_)
        all.push_back(moment.moment);
    return strongerBy_percent(all, now);
}

Hindrance FieldGuide::seeSpot(const HealthReport& health, Guidance& guidance) {
    const std::vector<SpotMoment> moments = momentsSince(0);
    spot_ = spotField(moments);
    guidance.value = spot_.uneven_percent;
    const bool long_enough =
        !moments_.empty() &&
        static_cast<double>(health.sample - moments_.front().sample) >= kLeastSpot_s * rate_hz_;
    const auto moving = std::ranges::count_if(moments_, &Moment::moves);
    if (!long_enough || static_cast<double>(moving) < kLeastMoving * static_cast<double>(moments_.size()))
        return Hindrance::kCarry;
    if (const double tilt_deg = tiltBetween_deg(moments.front(), moments.back());
        tilt_deg > kMostTurned_deg) {
        guidance.value = radians(tilt_deg);
        return Hindrance::kTilted;
    }
    return spot_.isEven() ? Hindrance::kNone : Hindrance::kBentField;
}

/// Lowered, then calm for a moment: what is read then is the floor's field.
Hindrance FieldGuide::seeFloor(const HealthReport& health, Guidance& guidance) {
    const bool is_moved = moves(health, kLowered_m_per_s2);
    was_lowered_ |= is_moved;
    if (is_moved || !was_lowered_)
        calm_since_ = health.sample;
    spot_.floor_percent =
        was_lowered_ ? strongerBy_percent(at_spot_, momentsSince(calm_since_)) : std::nullopt;
    guidance.value = spot_.floor_percent.value_or(0);
    if (!was_lowered_ || is_moved || at_spot_.empty())
        return Hindrance::kLower;
    if (const double tilt_deg = tiltBetween_deg(at_spot_.back(), moments_.back().moment);
        tilt_deg > kMostTurned_deg) {
        guidance.value = radians(tilt_deg);
        return Hindrance::kTilted;
    }
    return static_cast<double>(health.sample - calm_since_) >= kCalm_s * rate_hz_ ? Hindrance::kNone
                                                                                  : Hindrance::kLower;
}

Hindrance FieldGuide::seeTurn(Guidance& guidance) {
    judgeSome();
    bool all = true;
    for (int board = 0; board < boardCount(); ++board) {
        if (!asks(board) || turnOf(board).state() == FieldTurnState::kDone)
            continue;
        // One that is not heard hinders more than directions that are missing.
        if (guidance.boards[index(board)] == GuidedBoard::kAbsent)
            return Hindrance::kNone;
        guidance.boards[index(board)] = GuidedBoard::kMoves;
        all = false;
    }
    guidance.value = leastShare();
    guidance.board = leastBoard();
    return all ? Hindrance::kNone : Hindrance::kTurnOn;
}

Hindrance FieldGuide::see(const HealthReport& health, Guidance& guidance) {
    const Step step = !isDone(kSpot) ? kSpot : !isDone(kFloor) ? kFloor : kTurn;
    guidance.step = step;
    const bool any = collect(health, step);
    bool any_board = false;
    for (int board = 0; board < boardCount(); ++board) {
        any_board |= asks(board) && isHeard(health, board);  // an unplugged wire carries noise
        if (isHeardNow(health, board))
            guidance.boards[index(board)] = GuidedBoard::kRight;
    }
    if (!any)
        return any_board ? Hindrance::kNoField : Hindrance::kNoReadings;
    return step == kTurn    ? seeTurn(guidance)
           : step == kFloor ? seeFloor(health, guidance)
                            : seeSpot(health, guidance);
}

}  // namespace noctule
