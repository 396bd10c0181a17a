// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_evidence.h"

#include <algorithm>
#include <cmath>

#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

constexpr double kNominalZero_counts = 2048;
constexpr double kUsualAccelSpread_counts = 60;  // of zeros that nobody has calibrated
constexpr double kLeastAccelSpread_m_per_s2 = 0.02;
constexpr size_t kBoardsForSpread = 3;
constexpr double kLeastConfidence = 0.05;
constexpr double kLeastForce_m_per_s2 = 1;
constexpr double kGyroSpread_rad_per_s = 0.03, kNominalGyroSpread_rad_per_s = 0.5;
constexpr double kLeastForceSigma_m_per_s2 = 0.1;
constexpr double kCauchyScaleSquare = 4;

bool isNominal(const AxisCalibration& axes) {
    return axes.zero_counts == Vector3d::Constant(kNominalZero_counts);
}

double boundedCost(double residual_in_sigma) {
    return kCauchyScaleSquare * std::log1p(residual_in_sigma * residual_in_sigma / kCauchyScaleSquare);
}

}  // namespace

RestEvidenceMaker::RestEvidenceMaker(const Observations& take, const StillStretch& still,
                                     double sigma_distance_m)
    : take_(take), still_(still), sigma_distance_m_(sigma_distance_m) {
    const Calibration nominal = nominalCalibration(take.suit);
    for (size_t b = 0; b < take.suit.boards.size(); ++b) {
        const BoardCalibration* known = take.calibration.findBoard(take.suit.boards[b].id);
        calibrations_.push_back(known ? *known : nominal.boards[b]);
    }
    spread_calibrated_m_per_s2_ = spread_m_per_s2(true);
    spread_nominal_m_per_s2_ = spread_m_per_s2(false);
}

bool RestEvidenceMaker::accelIsCalibrated(int board) const {
    return !isNominal(calibration(board).accel);
}

double RestEvidenceMaker::spread_m_per_s2(bool calibrated) const {
    std::vector<double> errors;
    double scale_m_per_s2 = 0;
    for (int b = 0; b < static_cast<int>(calibrations_.size()); ++b)
        if (still_.boards[static_cast<size_t>(b)].heard() && accelIsCalibrated(b) == calibrated) {
            errors.push_back(std::abs(accel({b, b}).norm() - take_.g_m_per_s2));
            scale_m_per_s2 = std::max(scale_m_per_s2, calibration(b).accel.matrix.norm() / std::sqrt(3.0));
        }
    if (errors.size() < kBoardsForSpread)
        return calibrated ? kLeastForceSigma_m_per_s2 : kUsualAccelSpread_counts * scale_m_per_s2;
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::ranges::nth_element(errors, middle);
    return std::max(kLeastAccelSpread_m_per_s2, 1.4826 * *middle);
}

Arrangement RestEvidenceMaker::asDescribed() const {
    Arrangement arrangement;
    for (int b = 0; b < static_cast<int>(calibrations_.size()); ++b)
        arrangement.push_back({b, b});
    return arrangement;
}

Vector3d RestEvidenceMaker::accel(const StreamPlace& board) const {
    return calibration(board.calibration)
        .accel.apply(still_.boards[static_cast<size_t>(board.stream)].accel_counts);
}

Vector3d RestEvidenceMaker::gyro_rad_per_s(const StreamPlace& board) const {
    return calibration(board.calibration)
        .gyro.apply(still_.boards[static_cast<size_t>(board.stream)].gyro_counts);
}

double RestEvidenceMaker::sigmaUp_rad(int board) const {
    const double spread_m_per_s2 =
        accelIsCalibrated(board) ? spread_calibrated_m_per_s2_ : spread_nominal_m_per_s2_;
    return std::atan(spread_m_per_s2 / take_.g_m_per_s2);
}

bool RestEvidenceMaker::sameCalibration(int a, int b) const {
    const auto same = [](const AxisCalibration& x, const AxisCalibration& y) {
        return x.zero_counts == y.zero_counts && x.matrix == y.matrix;
    };
    return same(calibration(a).gyro, calibration(b).gyro) && same(calibration(a).accel, calibration(b).accel);
}

double RestEvidenceMaker::sensorCost(const StreamPlace& board) const {
    if (!still_.boards[static_cast<size_t>(board.stream)].heard())
        return 0;
    const BoardCalibration& known = calibration(board.calibration);
    const double sigma_m_per_s2 = accelIsCalibrated(board.calibration)
                                      ? std::max(kLeastForceSigma_m_per_s2, 3 * spread_calibrated_m_per_s2_)
                                      : kUsualAccelSpread_counts * known.accel.matrix.norm() / std::sqrt(3.0);
    const double sigma_rad_per_s =
        isNominal(known.gyro) ? kNominalGyroSpread_rad_per_s : kGyroSpread_rad_per_s;
    return boundedCost((accel(board).norm() - take_.g_m_per_s2) / sigma_m_per_s2) +
           boundedCost(gyro_rad_per_s(board).norm() / sigma_rad_per_s);
}

std::optional<double> RestEvidenceMaker::distance_m(const StillFlight& flight, int calibrated_as) const {
    const Source& source = take_.suit.sources[static_cast<size_t>(flight.source)];
    const SourceCalibration* known = take_.calibration.findSource(source.id);
    if (!known || !known->offsets_s.contains(take_.detector))
        return std::nullopt;
    const double delay_s = calibration(calibrated_as).mic_delay_s;
    const double distance_m =
        flight.c_m_per_s * (flight.flight_s - known->offsets_s.at(take_.detector) - delay_s);
    return distance_m > 0 && std::isfinite(distance_m) ? std::optional(distance_m) : std::nullopt;
}

void RestEvidenceMaker::addUp(int place, const StreamPlace& placed, RestEvidence& into) const {
    const Vector3d up = accel(placed);
    if (still_.boards[static_cast<size_t>(placed.stream)].heard() && up.allFinite() &&
        up.norm() > kLeastForce_m_per_s2)
        into.ups.push_back({place, up.normalized(), sigmaUp_rad(placed.calibration)});
}

void RestEvidenceMaker::addDistance(int place, const StreamPlace& placed, const StillFlight& flight,
                                    RestEvidence& into) const {
    const auto distance = distance_m(flight, placed.calibration);
    // A faint pulse arrives late or from elsewhere: as in the paper, sigma / confidence.
    const double sigma_m =
        std::hypot(sigma_distance_m_ / std::clamp(flight.confidence, kLeastConfidence, 1.0),
                   flight.c_m_per_s * flight.spread_s);
    if (distance && std::isfinite(sigma_m))
        into.distances.push_back({flight.source, place, *distance, sigma_m});
}

RestEvidence RestEvidenceMaker::make(const Arrangement& arrangement) const {
    RestEvidence evidence;
    const auto onBody = [&](const std::string& segment) { return take_.actor.skeleton.find(segment) >= 0; };
    std::vector<int> place_of_stream(arrangement.size(), -1);
    for (size_t place = 0; place < arrangement.size(); ++place)
        if (onBody(take_.suit.boards[place].segment)) {
            place_of_stream[static_cast<size_t>(arrangement[place].stream)] = static_cast<int>(place);
            addUp(static_cast<int>(place), arrangement[place], evidence);
        }
    for (const StillFlight& flight : still_.flights) {
        const int place = place_of_stream[static_cast<size_t>(flight.board)];
        if (place >= 0 && onBody(take_.suit.sources[static_cast<size_t>(flight.source)].segment))
            addDistance(place, arrangement[static_cast<size_t>(place)], flight, evidence);
    }
    return evidence;
}

RestPriors priorsOf(const Observations& take, bool oriented_as_calibrated) {
    RestPriors priors;
    const Suit placed = placedSuit(take.suit, take.calibration);
    for (size_t b = 0; b < placed.boards.size(); ++b) {
        const Board& board = placed.boards[b];
        BoardPrior prior;
        prior.joint = take.actor.skeleton.find(board.segment);
        prior.q_segment_board =
            oriented_as_calibrated ? board.q_segment_board : take.suit.boards[b].q_segment_board;
        prior.p_segment_mic_m = board.p_segment_board_m + prior.q_segment_board * board.p_board_mic_m;
        priors.boards.push_back(prior);
    }
    for (const Source& source : placed.sources)
        priors.sources.push_back({take.actor.skeleton.find(source.segment), source.p_segment_source_m, 0});
    return priors;
}

}  // namespace noctule
