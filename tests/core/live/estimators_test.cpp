// SPDX-License-Identifier: Apache-2.0
#include "core/live/estimators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/estimation/manifold_parameters.h"
#include "core/estimation/paper_parameters.h"
#include "core/live/point_estimators.h"

namespace noctule {
namespace {

TEST(Estimators, EveryParameterIsExplainedAndItsDefaultInRange) {
    for (const EstimatorEntry& entry : estimators()) {
        SCOPED_TRACE(entry.name);
        // "orientation" has fixed settings, which core/posing describes.
        EXPECT_EQ(entry.parameters.empty(), entry.whole_take && !givesPoints(entry.name));
        std::set<std::string> names;
        for (const ParameterDescription& row : entry.parameters) {
            SCOPED_TRACE(row.name);
            EXPECT_TRUE(names.insert(row.name).second) << "is there twice";
            EXPECT_GE(row.usual, row.least);
            EXPECT_LE(row.usual, row.most);
            EXPECT_LT(row.least, row.most);
            EXPECT_FALSE(row.unit.empty() || row.source.empty());
            EXPECT_TRUE(row.meaning.size() > 10 && row.meaning.ends_with('.'));
        }
        EXPECT_TRUE(checkParameters(entry.parameters, completeParameters(entry.parameters, {}), entry.name));
    }
}

/// Changes one value after the other and sees that it alone moves: no row names another row's place.
template <class Settings>
void expectOwnPlaces(const ParameterTable<Settings>& table) {
    for (const Parameter<Settings>& changed : table) {
        Settings settings;
        const double before = valueAt(changed.place(settings));
        const double other = before == changed.least ? changed.most : changed.least;
        settings = settingsFrom(table, {{changed.name, other}});
        Settings usual;
        for (const Parameter<Settings>& row : table)
            EXPECT_EQ(valueAt(row.place(settings)),
                      row.name == changed.name ? other : valueAt(row.place(usual)))
                << changed.name << " against " << row.name;
    }
}

TEST(Estimators, EveryParameterHasAPlaceOfItsOwn) {
    expectOwnPlaces(manifoldParameters());
    expectOwnPlaces(paperParameters());
}

TEST(Estimators, AShareBelongsToMeasurementSelectionAlone) {
    const auto has = [](const char* estimator) {
        return std::ranges::count(pointParameters(estimator), "share", &ParameterDescription::name) > 0;
    };
    EXPECT_TRUE(has("ms-comocap"));
    EXPECT_FALSE(has("comocap") || has("environment"));
    const PointSetup setup = pointSetup({{"share", 0.5}, {"q", 0.03}});
    EXPECT_EQ(filterSettings("ms-comocap", setup).share, 0.5);
    EXPECT_EQ(filterSettings("comocap", setup).share, 1);
    EXPECT_EQ(filterSettings("environment", setup).method, cooperative::PointMethod::kEnvironment);
    EXPECT_TRUE(filterSettings("ms-comocap", pointSetup({{"letter", 1}})).keeps_unchosen_rows);
    EXPECT_FALSE(givesPoints("own") || givesPoints("manifold"));
}

TEST(Estimators, AValueReachesTheSettings) {
    const ManifoldSetup setup = settingsFrom(
        manifoldParameters(),
        {{"range.gate", 3}, {"noise.range_memory", 33}, {"stance.leave", 2}, {"smoother.lag", 1}});
    EXPECT_EQ(setup.filter.distance_gate_sigma, 3);
    EXPECT_EQ(setup.filter.board_noise.distance.memory, 33);
    EXPECT_EQ(setup.filter.ground.stance.leave, 2);
    EXPECT_EQ(setup.lag_s, 1);
    EXPECT_EQ(setup.filter.give.initial_rad, ManifoldParameters{}.give.initial_rad);
}

TEST(Estimators, TheDetectorIsThePapersForThePaperAlone) {
    EXPECT_EQ(findEstimator(kManifoldEstimator)->detector, Detector::kMatched);
    EXPECT_EQ(findEstimator(kPaperEstimator)->detector, Detector::kInflection);
    EXPECT_EQ(findEstimator("magic"), nullptr);
}

}  // namespace
}  // namespace noctule
