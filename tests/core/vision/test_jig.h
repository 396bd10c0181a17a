// SPDX-License-Identifier: Apache-2.0
// A jig like an open book: 18 boards on one leaf, 8 sources on the other, 30 to 90 cm apart, and a camera
// that goes around it. In each placement everything stands elsewhere.
#pragma once

#include "core/suit/default_suit.h"
#include "core/vision/marker_photographs.h"
#include "core/vision/marker_plan.h"
#include "tests/support/photographed_jig.h"

namespace noctule::test {

inline const Vector3d kJigMiddle(0.25, 0, 0.12);

inline Matrix3d facing(const Vector3d& normal, std::mt19937& random) {
    std::uniform_real_distribution<double> tilt(-0.3, 0.3), turn(-3, 3);
    const Quaterniond tilted = expQuaternion({tilt(random), tilt(random), 0});
    const Quaterniond q =
        smallestRotation(Vector3d::UnitZ(), normal) * tilted * axisAngle(Vector3d::UnitZ(), turn(random));
    return q.toRotationMatrix();
}

inline std::vector<StuckMarker> stickMarkers(const Suit& suit, int placement, double side_m = 0.04) {
    std::mt19937 random(100 + unsigned(placement));
    std::uniform_real_distribution<double> play(-0.008, 0.008);
    std::vector<int> seats(18), places(8);
    std::iota(seats.begin(), seats.end(), 0);
    std::iota(places.begin(), places.end(), 0);
    std::ranges::shuffle(seats, random);
    std::ranges::shuffle(places, random);
    const double apart_m = 0.02 * placement;
    std::vector<StuckMarker> markers;
    const std::vector<PlannedMarker> plan = planMarkers(suit).value();
    for (const PlannedMarker& planned : plan) {
        StuckMarker marker{planned.number, {}, {}, side_m};
        Vector3d normal = Vector3d::UnitZ();
        if (planned.kind == PlannedMarker::Kind::kBoard) {
            const int seat = seats[size_t(planned.part)];
            marker.p_m = {0.078 * (seat % 6) - 0.22, 0.1 * (seat / 6) - 0.1, 0};
        } else if (planned.kind == PlannedMarker::Kind::kSource) {
            const int place = places[size_t(planned.part)];
            const double along = 0.08 * (place % 2);
            marker.p_m = {0.5 + apart_m + 0.6 * along, 0.09 * (place / 2) - 0.135, 0.22 + 0.8 * along};
            normal = Vector3d(-0.8, 0, 0.6);
        } else {
            marker.p_m = {0.34, -0.18, 0.1};
            normal = Vector3d(-0.3, 0.3, 1).normalized();
        }
        marker.p_m += Vector3d{play(random), play(random), play(random)};
        marker.R = facing(normal, random);
        markers.push_back(marker);
    }
    return markers;
}

/// The how many-th photograph of a placement.
inline TestCamera cameraOf(int placement, int photograph, const TestCamera& lens = {}) {
    std::mt19937 random(unsigned(1000 + 50 * placement + photograph));
    std::uniform_real_distribution<double> play(-0.08, 0.08);
    const double azimuth[] = {-0.5, 0.35, -0.1, 0.1, -0.35, 0.2},
                 elevation[] = {0.2, 0.1, 0.6, -0.35, -0.15, 0.4}, roll[] = {0, 0.1, 1.6, -0.2, 3.1, -1.5};
    const auto k = size_t(photograph % 6);
    const Vector3d towards(std::sin(azimuth[k]) * std::cos(elevation[k]), std::sin(elevation[k]),
                           std::cos(azimuth[k]) * std::cos(elevation[k]));
    TestCamera camera = lens;
    // Drawn one by one: compilers evaluate arguments in different orders.
    const Vector3d from = kJigMiddle + (1.05 + play(random)) * towards,
                   at = kJigMiddle + Vector3d{play(random), play(random), play(random)};
    camera.look(from, at, roll[k] + play(random));
    return camera;
}

struct JigErrors {
    int distances = 0;
    double rms_m = 0, worst_m = 0;
    double chi_square = 0;  ///< per distance, by the fit's sigma
};

/// `stuck` of each placement, whose label is its number from 1.
inline JigErrors compare(const PhotographedDistances& found, const Suit& suit,
                         const std::vector<std::vector<StuckMarker>>& stuck) {
    JigErrors errors;
    double sum_m2 = 0;
    for (size_t i = 0; i < found.known.distances.size(); ++i) {
        const KnownDistance& known = found.known.distances[i];
        const auto& markers = stuck[size_t(std::stoi(known.placement) - 1)];
        const auto placeOf = [&](int number) {
            return std::ranges::find(markers, number, &StuckMarker::number)->p_m;
        };
        const double truth_m = (placeOf(kFirstSourceMarker + suit.findSource(known.source)) -
                                placeOf(kFirstBoardMarker + suit.findBoard(known.board)))
                                   .norm();
        const double error_m = known.distance_m - truth_m;
        sum_m2 += error_m * error_m;
        errors.worst_m = std::max(errors.worst_m, std::abs(error_m));
        errors.chi_square += std::pow(error_m / found.fit_sigma_m[i], 2);
        ++errors.distances;
    }
    errors.rms_m = std::sqrt(sum_m2 / std::max(1, errors.distances));
    errors.chi_square /= std::max(1, errors.distances);
    return errors;
}

inline bool says(const std::vector<Finding>& findings, const std::vector<std::string>& words,
                 Grade grade = Grade::kUsable) {
    return std::ranges::any_of(findings, [&](const Finding& finding) {
        return finding.grade == grade && !finding.remedy.empty() &&
               std::ranges::all_of(words, [&](const std::string& word) {
                   return finding.what.find(word) != std::string::npos;
               });
    });
}

inline std::string all(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += finding.what + "\n";
    return text;
}

}  // namespace noctule::test
