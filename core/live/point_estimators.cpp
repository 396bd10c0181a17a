// SPDX-License-Identifier: Apache-2.0
#include "core/live/point_estimators.h"

#include "core/job/contract.h"

namespace noctule {
namespace {

using cooperative::PointMethod;

const ParameterTable<PointSetup>& pointTable() {
    using S = PointSetup;
    static const ParameterTable<S> kTable{
        {"q", "m^2/s^3", 1e-6, 1e4, at(&S::q_m2_per_s3),
         "Process noise: white acceleration of each point; 0.03 fits a calm handshake, 0.3 a dance. Larger: "
         "faster motion is followed, less is smoothed.",
         "Welch 2018, equations 7 to 9"},
        {"share", "-", 0, 1, at(&S::share), "Share of the ranges of each pulse that are used.",
         "Welch 2018, section 3.3"},
        {"rule", "count", 0, 2, at(&S::rule),
         "Which ranges the share keeps: 0 by Welch's ratio, 1 greedy by the trace of the places' covariance, "
         "2 greedy by its determinant.",
         "Welch 2018, equations 17 to 24; greedy: ours"},
        {"letter", "switch", 0, 1, at(&S::letter),
         "1: the paper to the letter. Unused ranges shrink the covariance, covariances between reference "
         "users are dropped, the share is by ratio.",
         "Welch 2018, section 3"},
        {"initial.place_sigma", "m", 1e-4, 10, at(&S::start_m),
         "Initial standard deviation of each point about the rest pose, per axis.", "-"},
        {"initial.speed_sigma", "m/s", 1e-4, 10, at(&S::start_m_per_s),
         "Initial standard deviation of each point's velocity, per axis.", "-"},
        {"range_floor", "m", 0, 1, at(&S::floor_m),
         "Standard deviation added to the stated one of each range: survey, mounting, offsets of sources.",
         "-"},
        {"gate", "-", 1, 1000, at(&S::gate_sigma),
         "A range farther off than this many standard deviations is left out.", "-"},
        {"rows_per_s", "1/s", 1, 1000, at(&S::rows_per_s), "Rows of the table of points per second.", "-"},
    };
    return kTable;
}

}  // namespace

bool givesPoints(const std::string& estimator) {
    const auto method = cooperative::pointMethodFromText(estimator);
    return method && *method != PointMethod::kOwn;
}

std::vector<ParameterDescription> pointParameters(const std::string& estimator) {
    std::vector<ParameterDescription> rows = describe(pointTable());
    if (estimator != "ms-comocap")
        std::erase_if(
            rows, [](const ParameterDescription& row) { return row.name == "share" || row.name == "rule"; });
    return rows;
}

PointSetup pointSetup(const ParameterValues& values) {
    return settingsFrom(pointTable(), values);
}

cooperative::PointFilterSettings filterSettings(const std::string& estimator, const PointSetup& setup) {
    const auto method = cooperative::pointMethodFromText(estimator);
    require(method.has_value(), "an estimator of points that was checked before");
    cooperative::PointFilterSettings settings;
    settings.method = *method;
    settings.q_m2_per_s3 = setup.q_m2_per_s3;
    if (setup.letter)
        settings = cooperative::welchSettings(*method, setup.q_m2_per_s3);
    else if (*method == PointMethod::kMsComocap)
        settings.rule = setup.rule == 0   ? cooperative::SelectionRule::kRatio
                        : setup.rule == 1 ? cooperative::SelectionRule::kTrace
                                          : cooperative::SelectionRule::kLogDet;
    if (*method == PointMethod::kMsComocap)
        settings.share = setup.share;
    return settings;
}

}  // namespace noctule
