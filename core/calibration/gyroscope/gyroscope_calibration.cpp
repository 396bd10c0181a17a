// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/gyroscope/gyroscope_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/body/text.h"
#include "core/calibration/gyroscope/gyroscope_fit.h"
#include "core/calibration/gyroscope/gyroscope_turns.h"
#include "core/calibration/gyroscope/turntable_speed.h"
#include "core/calibration/worn_part_names.h"
#include "core/suit/calibration_entries.h"
#include "core/suit/calibration_lack.h"

namespace noctule {
namespace {

using GyroLimits = GyroscopeLimits;

constexpr double kUsualWander_rad_per_s = 2e-4;  ///< per root of a second, where too little tells
constexpr double kLeastWander_rad_per_s = 2e-5;  ///< a few boards may seem to have none
constexpr double kFewestWanderFreedoms = 6;

double observedSpeed_rad_per_s(const std::vector<TableBoard>& tables) {
    double sum = 0;
    size_t count = 0;
    for (const TableBoard& table : tables)
        for (const double speed : table.speeds_rad_per_s()) {
            sum += speed;
            ++count;
        }
    return count == 0 ? 0 : sum / static_cast<double>(count);
}

double chooseNominal_rpm(const std::vector<Observations>& takes, double asked_rpm,
                         double observed_rad_per_s) {
    if (asked_rpm > 0)
        return asked_rpm;
    for (const Observations& take : takes)
        if (take.turntable_rpm > 0)
            return take.turntable_rpm;
    return nearestTableSpeed_rpm(observed_rad_per_s / turningRate_rad_per_s(1));
}

/// A board that has all its turns, on the way to its values.
struct GyroWork {
    size_t index = 0;  ///< in the report
    const TableBoard* table = nullptr;
    std::vector<KnownRate> rates;
    double slope_rad_per_s = 0;  ///< nominal, of a count
    GyroscopeFit fit;
};

void fitAll(std::vector<GyroWork>& works, double wander_rad_per_s) {
    for (GyroWork& work : works)
        work.fit = fitGyroscope(work.rates, std::pow(wander_rad_per_s / work.slope_rad_per_s, 2));
}

/// How much the zeros must wander, all alike, for what is left to be no surprise; then the fits with it.
double fitWandering(std::vector<GyroWork>& works) {
    double low = std::log(kLeastWander_rad_per_s), high = std::log(1e-2);
    double freedoms = 0;
    fitAll(works, kUsualWander_rad_per_s);
    for (const GyroWork& work : works)
        freedoms += work.fit.freedoms;
    if (freedoms < kFewestWanderFreedoms)
        low = high = std::log(kUsualWander_rad_per_s);
    while (high - low > 0.02) {
        fitAll(works, std::exp((low + high) / 2));
        double excess = 0;
        for (const GyroWork& work : works)
            excess += work.fit.chi_square - work.fit.freedoms;
        (excess > 0 ? low : high) = (low + high) / 2;
    }
    fitAll(works, std::exp(high));
    return std::exp(high);
}

HeadingBoard headingOf(const GyroWork& work, size_t takes) {
    HeadingBoard heading;
    heading.record = work.table->record;
    heading.matrix = work.fit.axes.matrix;
    heading.zeros.resize(takes);
    for (size_t k = 0; k < work.rates.size(); ++k) {
        const KnownRate& rate = work.rates[k];
        heading.zeros[static_cast<size_t>(rate.take)].emplace_back((rate.begin_s + rate.end_s) / 2,
                                                                   work.fit.zeros_counts[k]);
        if (work.table->stretches[k].about)
            heading.turns.push_back(work.table->stretches[k].steady);
    }
    return heading;
}

class GyroscopeSolver {
public:
    GyroscopeSolver(const std::vector<Observations>& takes, double asked_rpm)
        : takes_(takes), records_(boardRecords(takes)) {
        for (const BoardRecord& record : records_)
            tables_.push_back(tableBoard(record));
        const double observed_rad_per_s = observedSpeed_rad_per_s(tables_);
        report_.nominal_rpm = chooseNominal_rpm(takes, asked_rpm, observed_rad_per_s);
        report_.rpm = report_.nominal_rpm;
        report_.sigma_rpm = GyroLimits::kTableSpread * report_.nominal_rpm;
        wrong_speed_ = observed_rad_per_s > 0 &&
                       std::abs(observed_rad_per_s / turningRate_rad_per_s(report_.nominal_rpm) - 1) >
                           GyroLimits::kWrongSpeed;
        if (wrong_speed_)
            say({Grade::kNotUsable, "",
                 "The table turned at about " + text::number(observed_rad_per_s * 30 / std::numbers::pi, 0) +
                     " rpm" + ", not at " + speedWords(report_.nominal_rpm),
                 "State the speed that the table is set to"});
    }

    GyroscopeReport solve() {
        std::vector<GyroWork> works;
        for (size_t b = 0; b < tables_.size(); ++b) {
            report_.boards.push_back({});
            report_.boards.back().board = records_[b].board;
            for (const Finding& finding : turnFindings(tables_[b], report_.nominal_rpm))
                say(finding);
            if (report_.boards.back().grade != Grade::kNotUsable && !wrong_speed_)
                works.push_back(workOf(b));
        }
        if (!works.empty()) {
            report_.wander_rad_per_s_per_sqrt_s = fitWandering(works);
            measureSpeed(works);
        }
        for (const GyroWork& work : works)
            finish(work);
        for (const Grade grade : {Grade::kNotUsable, Grade::kUsable})
            for (const bool restarted : {true, false})
                sayUncertain(grade, restarted);
        return std::move(report_);
    }

private:
    /// Of the last board so far, or of all.
    void say(const Finding& finding) {
        report_.findings.push_back(finding);
        if (!finding.part.empty())
            report_.boards.back().grade = std::max(report_.boards.back().grade, finding.grade);
    }

    GyroWork workOf(size_t b) {
        GyroWork work;
        work.index = b;
        work.table = &tables_[b];
        work.slope_rad_per_s = records_[b].board.gyro_full_scale_rad_per_s / 2048;
        for (const TableStretch& stretch : tables_[b].stretches)
            work.rates.push_back(
                {stretch.gyro, stretch.steady.begin_s, stretch.steady.end_s, stretch.steady.take,
                 stretch.about ? Vector3d(turningRate_rad_per_s(report_.nominal_rpm) * stretch.about->up())
                               : Vector3d::Zero(),
                 takes_[static_cast<size_t>(stretch.steady.take)].began_s});
        return work;
    }

    void measureSpeed(const std::vector<GyroWork>& works) {
        std::vector<HeadingBoard> headings;
        for (const GyroWork& work : works)
            headings.push_back(headingOf(work, takes_.size()));
        const std::optional<SpeedRatio> ratio = turntableSpeed(headings);
        report_.speed_measured = ratio && ratio->sigma < GyroLimits::kTableSpread;
        if (report_.speed_measured) {
            report_.rpm = report_.nominal_rpm * (1 + ratio->excess);
            report_.sigma_rpm = report_.nominal_rpm * ratio->sigma;
            if (std::abs(ratio->excess) > GyroLimits::kOffSpeed)
                say({Grade::kUsable, "",
                     "The table turned " + text::number(100 * std::abs(ratio->excess), 1) + " % " +
                         (ratio->excess > 0 ? "faster" : "slower") + " than " +
                         speedWords(report_.nominal_rpm) + "; its measured speed counts",
                     "Set the table's speed with its stroboscope and repeat, to be sure"});
        } else {
            say({Grade::kUsable, "",
                 "The table's true speed does not show, as it stands level or turned too briefly; " +
                     speedWords(report_.nominal_rpm) + " counts, which is good to about 0.1 %",
                 "For a better result tilt the table by a third of a degree and repeat"});
        }
    }

    void finish(const GyroWork& work) {
        GyroscopeBoard& board = report_.boards[work.index];
        board.sigma_matrix = work.fit.sigma_matrix;
        board.sigma_mean_zero_counts = *work.fit.axes.sigma_zero_counts;
        board.axes = work.fit.axes;
        board.axes->matrix *= report_.rpm / report_.nominal_rpm;
        for (int i = 0; i < 3; ++i)
            board.sigma_matrix(i, i) = std::hypot(board.sigma_matrix(i, i),
                                                  board.axes->matrix(i, i) * report_.sigma_rpm / report_.rpm);
        board.axes->sigma_zero_counts =
            (board.sigma_mean_zero_counts.array().square() + std::pow(wanderedBy_counts(work), 2)).sqrt();
        const BoardCalibration* in_force = work.table->record->in_force->findBoard(work.table->record->id);
        const bool is_known = knowsGyroscope(board.board, in_force);
        for (size_t k = 0; k < work.rates.size(); ++k) {
            const KnownRate& rate = work.rates[k];
            const Vector3d found = work.fit.axes.matrix * (rate.mean.counts - work.fit.zeros_counts[k]);
            board.turns.push_back({rate.take,
                                   rate.begin_s,
                                   rate.end_s,
                                   work.table->stretches[k].up,
                                   work.table->stretches[k].about,
                                   found - rate.rate_rad_per_s,
                                   {}});
            if (is_known)
                board.turns.back().residual_before_rad_per_s =
                    in_force->gyro.apply(rate.mean.counts) - rate.rate_rad_per_s;
        }
        judge(board, work);
    }

    /// How far a zero is from its mean at the end of the last take.
    double wanderedBy_counts(const GyroWork& work) const {
        double begin_s = work.rates.back().begin_s;
        for (const KnownRate& rate : work.rates)
            if (rate.take == work.rates.back().take)
                begin_s = std::min(begin_s, rate.begin_s);
        const double lasted_s = work.rates.back().end_s - begin_s;
        return report_.wander_rad_per_s_per_sqrt_s / work.slope_rad_per_s * std::sqrt(lasted_s / 3);
    }

    void judge(GyroscopeBoard& board, const GyroWork& work) {
        const double zero = board.sigmaZero_rad_per_s(), slope = board.sigmaSlope();
        Grade grade = Grade::kGood;
        if (!(zero <= GyroLimits::kZero_rad_per_s && slope <= GyroLimits::kSlope))
            grade = Grade::kNotUsable;
        else if (zero > GyroLimits::kGoodZero_rad_per_s ||
                 (slope > GyroLimits::kGoodSlope && report_.speed_measured))
            grade = Grade::kUsable;
        board.grade = std::max(board.grade, grade);
        if (grade != Grade::kGood)
            uncertain_.push_back(
                {grade, work.fit.restart_probability > 0.5, work.table->record, zero, slope});
        if (grade == Grade::kNotUsable)
            board.axes.reset();
    }

    struct UncertainBoard {
        Grade grade;
        bool restarted;  ///< between two takes
        const BoardRecord* record;
        double zero_rad_per_s, slope;

        /// How far beyond what is usable; not finite: nothing was found.
        double excess() const {
            const double zero = zero_rad_per_s / GyroLimits::kZero_rad_per_s,
                         of_slope = slope / GyroLimits::kSlope;
            return std::isfinite(zero + of_slope) ? std::max(zero, of_slope) : INFINITY;
        }
    };

    /// One cause, so one finding: the boards turned together.
    void sayUncertain(Grade grade, bool restarted) {
        std::vector<const UncertainBoard*> boards;
        for (const UncertainBoard& board : uncertain_)
            if (board.grade == grade && board.restarted == restarted)
                boards.push_back(&board);
        if (boards.empty())
            return;
        const UncertainBoard& worst = **std::ranges::max_element(boards, {}, &UncertainBoard::excess);
        Finding finding{grade, worst.record->id,
                        text::capitalised(worst.record->words) + ": its zero is known to " +
                            text::number(degrees(worst.zero_rad_per_s), 3) + " °/s and its slope to " +
                            text::number(100 * worst.slope, 3) + " %",
                        "Turn the six sides one soon after the other, each evenly for nine seconds or more"};
        if (restarted)
            finding.remedy =
                "Leave box and boards switched on from the first side to the last and repeat: a zero jumped "
                "between two takes, as it does when a board is switched off";
        if (boards.size() > 1) {
            finding.part.clear();
            finding.what = "The zeros and slopes of " + std::to_string(boards.size()) +
                           " boards are uncertain; worst is " + worst.record->words +
                           ", whose zero is known to " + text::number(degrees(worst.zero_rad_per_s), 3) +
                           " °/s and slope to " + text::number(100 * worst.slope, 3) + " %";
            for (const UncertainBoard* board : boards)
                finding.parts.push_back(board->record->id);
        }
        report_.findings.push_back(finding);
    }

    const std::vector<Observations>& takes_;
    std::vector<BoardRecord> records_;
    std::vector<UncertainBoard> uncertain_;
    std::vector<TableBoard> tables_;
    bool wrong_speed_ = false;
    GyroscopeReport report_;
};

}  // namespace

double GyroscopeBoard::sigmaZero_rad_per_s() const {
    return axes->matrix.diagonal().cwiseProduct(sigma_mean_zero_counts).cwiseAbs().maxCoeff();
}

double GyroscopeBoard::sigmaSlope() const {
    return sigma_matrix.diagonal().cwiseQuotient(axes->matrix.diagonal()).cwiseAbs().maxCoeff();
}

Calibration GyroscopeReport::applied(const Calibration& base) const {
    Calibration calibration = base;
    for (const GyroscopeBoard& board : boards)
        if (board.axes)
            entryOf(calibration, board.board).gyro = *board.axes;
    return calibration;
}

GyroscopeReport calibrateGyroscopes(const std::vector<Observations>& takes, double nominal_rpm) {
    return GyroscopeSolver(takes, nominal_rpm).solve();
}

}  // namespace noctule
