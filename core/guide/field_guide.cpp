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

Vector3d asField_ut(const Vector3d& counts) {
    return AxisCalibration::nominal(FieldTurnLimits::kFullScale_ut).apply(counts);
}

}  // namespace

FieldGuide::FieldGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz)
    : Guide(suit, calibration, sample_rate_hz, kSteps),
      rate_hz_(sample_rate_hz),
      turns_(suit.boards.size()),
      read_at_(suit.boards.size(), -1),
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
    iron_[index(board)] = false;
}

void FieldGuide::unlearn(int step) {
    if (step == kSpot)
        moments_.clear();
    for (int board = 0; step == kTurn && board < boardCount(); ++board)
        startAnew(board);
}

bool FieldGuide::collect(const HealthReport& health, bool turns) {
    SpotMoment moment{std::vector<std::optional<Vector3d>>(turns_.size()),
                      std::vector<std::optional<Vector3d>>(turns_.size())};
    bool any = false;
    turning_deg_per_s_ = 0;
    for (int board = 0; board < boardCount(); ++board) {
        const BoardHealth& now = health.boards[index(board)];
        if (!asks(board) || now.silent || !now.field)
            continue;
        any = true;
        if (now.means) {
            const Vector3d rate = calibrationOf(board).gyro.apply(now.means->gyro_counts);
            turning_deg_per_s_ = std::max(turning_deg_per_s_, degrees(rate.norm()));
            moment.up[index(board)] = calibrationOf(board).accel.apply(now.means->accel_counts);
        }
        const Vector3d field_ut = asField_ut(now.field->counts);
        moment.field_ut[index(board)] =
            calibrationOf(board).mag ? calibrationOf(board).mag->apply(now.field->counts) : field_ut;
        if (turns && now.field->sample != std::exchange(read_at_[index(board)], now.field->sample))
            turns_[index(board)].add(field_ut);
    }
    if (any && !turns)
        moments_.push_back({health.sample, std::move(moment)});
    return any;
}

/// In turn, so that fits of many boards do not hold up the screen.
void FieldGuide::judgeSome() {
    for (int n = 0; n < std::min(kJudgedAtOnce, boardCount()); ++n) {
        judged_ = (judged_ + 1) % boardCount();
        if (asks(judged_))
            turns_[index(judged_)].judge();
    }
    std::vector<std::optional<double>> uneven(turns_.size());
    for (int board = 0; board < boardCount(); ++board)
        if (asks(board))
            uneven[index(board)] = turnOf(board).uneven_percent();
    iron_ = carriesIron(uneven);
}

Hindrance FieldGuide::seeSpot(const HealthReport& health) {
    const auto window = static_cast<int64_t>(kSpotWindow_s * rate_hz_);
    while (!moments_.empty() &&
           (moments_.front().sample < health.sample - window || moments_.front().sample > health.sample))
        moments_.pop_front();
    std::vector<SpotMoment> moments;
    for (const Moment& moment : moments_)
        moments.push_back(moment.moment);
    spot_ = spotField(moments);
    const bool long_enough =
        !moments_.empty() &&
        static_cast<double>(health.sample - moments_.front().sample) >= kLeastSpot_s * rate_hz_;
    if (!long_enough || tiltBetween_deg(moments.front(), moments.back()) > kMostTurned_deg)
        return Hindrance::kCarry;
    return spot_.isEven() ? Hindrance::kNone : Hindrance::kBentField;
}

Hindrance FieldGuide::seeTurn(Guidance& guidance) {
    judgeSome();
    bool all = true;
    for (int board = 0; board < boardCount(); ++board) {
        const FieldTurn& turn = turnOf(board);
        if (!asks(board) || turn.state() == FieldTurnState::kDone)
            continue;
        if (guidance.boards[index(board)] == GuidedBoard::kRight)
            guidance.boards[index(board)] = GuidedBoard::kMoves;
        all = false;
    }
    guidance.value = leastShare();
    guidance.board = leastBoard();
    return all ? Hindrance::kNone : Hindrance::kTurnOn;
}

Hindrance FieldGuide::see(const HealthReport& health, Guidance& guidance) {
    guidance.step = isDone(kSpot) ? kTurn : kSpot;
    const bool any = collect(health, *guidance.step == kTurn);
    for (int board = 0; board < boardCount(); ++board) {
        const BoardHealth& now = health.boards[index(board)];
        if (asks(board) && !now.silent && now.field)
            guidance.boards[index(board)] = GuidedBoard::kRight;
    }
    if (!any)
        return Hindrance::kNoField;
    if (*guidance.step == kTurn)
        return seeTurn(guidance);
    const Hindrance hindrance = seeSpot(health);
    guidance.value = spot_.uneven_percent;
    return hindrance;
}

}  // namespace noctule
