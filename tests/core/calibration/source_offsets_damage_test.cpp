// SPDX-License-Identifier: Apache-2.0
// Every way in which a jig, its take or its table can be wrong: said in words, what is right stays right.
#include <gtest/gtest.h>

#include "core/calibration/source_offsets/source_offsets.h"
#include "tests/core/calibration/jig_take.h"
#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

using test::CsvCells;
using test::findingsText;
using test::findingWith;
using test::JigTake;
using test::nominalJig;

constexpr double kStillRight_m = 3e-4;

void expectFinding(const SourceOffsetReport& report, Grade grade, const std::vector<std::string>& words) {
    const Finding* finding = findingWith(report.findings, words);
    ASSERT_TRUE(finding) << words.front() << " in:\n" << findingsText(report.findings);
    EXPECT_EQ(finding->grade, grade) << finding->what;
    EXPECT_FALSE(finding->remedy.empty());
    EXPECT_NE(finding->what.back(), '.');
    for (const char* part : {"board", "source", "placement"})
        EXPECT_FALSE(finding->what.starts_with(part)) << finding->what;
}

int calibratedCount(const SourceOffsetReport& report) {
    return static_cast<int>(std::ranges::count(report.sources, true, &SourceOffset::calibrated));
}

/// All of the table's lengths, changed.
std::string withLengths(const std::string& csv, const std::function<double(double)>& change) {
    return test::withRows(csv, [&](CsvCells& cells) {
        for (size_t i = 3; i < cells.size(); ++i)
            cells[i] = std::to_string(change(std::stod(cells[i])));
    });
}

void moveAlongZ(CsvCells& cells, double by_m) {
    cells[5] = std::to_string(std::stod(cells[5]) + by_m);
}

TEST(SourceOffsetMistakes, AWrongUnitIsNamed) {
    const JigTake& jig = nominalJig();
    std::string in_mm = jig.csv;
    in_mm.replace(in_mm.find("x_m,y_m,z_m"), 11, "x_mm,y_mm,z_mm");
    const struct {
        std::string csv;
        std::vector<std::string> words;
    } mistakes[] = {
        {withLengths(jig.csv, [](double x) { return 1000 * x; }), {"1000 times too large", "millimetres"}},
        {withLengths(jig.csv, [](double x) { return 100 * x; }), {"100 times too large", "centimetres"}},
        {withLengths(jig.csv, [](double x) { return 10 * x; }), {"10.0 times too large"}},
        {withLengths(jig.csv, [](double x) { return 25.4 * x; }), {"25.4 times too large", "inches"}},
        {withLengths(jig.csv, [](double x) { return x / 0.0254; }), {"39.4 times too large", "inches"}},
        {withLengths(jig.csv, [](double x) { return x / 0.3048; }), {"3.3 times too large", "feet"}},
        {in_mm, {"1000 times too small", "metres stood under a heading in millimetres"}},
        {withLengths(in_mm, [](double x) { return 100 * x; }), {"10.0 times too small", "centimetres"}},
        {withLengths(in_mm, [](double x) { return x / 0.0254; }), {"25.4 times too small", "inches"}},
    };
    for (const auto& mistake : mistakes) {
        const SourceOffsetReport report = jig.solveWith(mistake.csv);
        expectFinding(report, Grade::kNotUsable, mistake.words);
        EXPECT_EQ(report.grade(), Grade::kNotUsable);
        EXPECT_EQ(calibratedCount(report), 0);
        EXPECT_TRUE(report.applied({}).sources.empty());
    }
    const std::string exchanged = test::withSwapped(jig.csv, "source", "hat", "navel");
    expectFinding(jig.solveWith(withLengths(exchanged, [](double x) { return 1000 * x; })), Grade::kNotUsable,
                  {"1000 times too large"});
}

TEST(SourceOffsetMistakes, AScaleThatNoAirHasIsNamed) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport report = jig.solveWith(withLengths(jig.csv, [](double x) { return 1.06 * x; }));
    expectFinding(report, Grade::kNotUsable, {"as if the air were", "warmer"});
    const SourceOffsetReport slight = jig.solveWith(withLengths(jig.csv, [](double x) { return 0.99 * x; }));
    expectFinding(slight, Grade::kUsable, {"as if the air were", "colder"});
    EXPECT_TRUE(slight.swaps.empty()) << findingsText(slight.findings);
}

TEST(SourceOffsetMistakes, APointThatWasMissedIsNamedAndLeftOut) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport once = jig.solveWith(test::withRows(jig.csv, [](CsvCells& cells) {
        if (cells[0] == "3" && cells[2] == "l_forearm")
            moveAlongZ(cells, -0.02);
    }));
    expectFinding(once, Grade::kGood, {"Board 7, l_forearm, in placement 3", "less than the file", "8 of 8"});
    EXPECT_LT(jig.worstError_m(once), kStillRight_m);
    const SourceOffsetReport always = jig.solveWith(test::withRows(jig.csv, [](CsvCells& cells) {
        if (cells[2] == "l_forearm")
            moveAlongZ(cells, 0.015);
    }));
    expectFinding(always, Grade::kUsable, {"Board 7, l_forearm: ", "more than the file"});
    EXPECT_LT(jig.worstError_m(always), kStillRight_m);
    const SourceOffsetReport source = jig.solveWith(test::withRows(jig.csv, [](CsvCells& cells) {
        if (cells[0] == "1" && cells[2] == "hat")
            moveAlongZ(cells, 0.03);
    }));
    expectFinding(source, Grade::kGood, {"Source 8, hat, in placement 1", "less than the file"});
    EXPECT_LT(jig.worstError_m(source), kStillRight_m);
}

TEST(SourceOffsetMistakes, WhatStandsInTheWayIsNamedAndLeftOut) {
    JigTake jig = nominalJig();
    for (FlightTime& flight : jig.observations.flights)
        if (jig.observations.placements[1].contains(flight.time_s) && flight.source == 2 && flight.board == 9)
            flight.flight_s += 0.05 / flight.c_m_per_s;
    const SourceOffsetReport report = jig.solve();
    expectFinding(report, Grade::kGood, {"Source 3, rib_l to board 10, l_leg, in placement 2", "50 mm more"});
    EXPECT_LT(jig.worstError_m(report), kStillRight_m);
}

TEST(SourceOffsetMistakes, WhatMovedIsNamedAndLeftOut) {
    JigTake jig = nominalJig();
    const Stretch& third = jig.observations.placements[2];
    for (FlightTime& flight : jig.observations.flights)
        if (third.contains(flight.time_s) && flight.time_s > (third.begin_s + third.end_s) / 2)
            flight.flight_s += 0.01 / flight.c_m_per_s;
    const SourceOffsetReport report = jig.solve();
    expectFinding(report, Grade::kUsable, {"Placement 3 moved"});
    EXPECT_LT(jig.worstError_m(report), kStillRight_m);
}

TEST(SourceOffsetMistakes, PulsesAtTheEdgesAndWithoutConfidenceDoNotCount) {
    JigTake jig = nominalJig();
    for (FlightTime& flight : jig.observations.flights) {
        const bool doubtful = flight.source % 2 == 0 && static_cast<int>(flight.time_s * 1000) % 3 == 0;
        for (const Stretch& stretch : jig.observations.placements)
            if (doubtful || flight.time_s < stretch.begin_s + 0.25 || flight.time_s > stretch.end_s - 0.25)
                if (stretch.contains(flight.time_s))
                    flight.flight_s += 1e-3;
        if (doubtful)
            flight.confidence = 0.2;
    }
    const SourceOffsetReport report = jig.solve();
    EXPECT_LT(jig.worstError_m(report), kStillRight_m);
    EXPECT_EQ(report.grade(), Grade::kGood) << findingsText(report.findings);
}

TEST(SourceOffsetMistakes, OffsetsThatNoSourceCanHaveAreNamed) {
    const JigTake& jig = nominalJig();
    KnownDistances known = jig.known();
    const auto with = [&](double longer_m) {
        KnownDistances changed = known;
        for (KnownDistance& distance : changed.distances)
            distance.distance_m += distance.source == "hat" ? longer_m : 0;
        return calibrateSourceOffsets({jig.observations}, changed);
    };
    expectFinding(with(0.1), Grade::kNotUsable, {"Source 8, hat", "offset of \u22121", "no source can have"});
    expectFinding(with(-0.07), Grade::kNotUsable, {"Source 8, hat", "no source can have"});
    expectFinding(with(-0.03), Grade::kUsable, {"Source 8, hat", "are usual"});
}

TEST(SourceOffsetMistakes, LabelsThatDoNotMatchAreNamed) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport none =
        jig.solveWith(test::withRows(jig.csv, [](CsvCells& cells) { cells[0] = "P" + cells[0]; }));
    expectFinding(none, Grade::kNotUsable, {"No placement of jig.csv", "P1", "1, 2"});
    expectFinding(none, Grade::kNotUsable, {"No source could be calibrated"});
    const SourceOffsetReport one = jig.solveWith(
        test::withRows(jig.csv, [](CsvCells& cells) { cells[0] = cells[0] == "6" ? "six" : cells[0]; }));
    expectFinding(one, Grade::kUsable, {"no marker", "six"});
    expectFinding(one, Grade::kUsable, {"no distances", "6"});
    EXPECT_LT(jig.worstError_m(one), kStillRight_m);
}

TEST(SourceOffsetMistakes, PartsThatAreMissingAreNamed) {
    const JigTake& jig = nominalJig();
    const SourceOffsetReport report = jig.solveWith(test::withRows(jig.csv, [](CsvCells& cells) {
        if (cells[2] == "hat")
            cells[2] = "hut";
        if (cells[2] == "head")
            cells.clear();
    }));
    expectFinding(report, Grade::kUsable, {"does not have: source hut"});
    expectFinding(report, Grade::kUsable, {"board 4, head"});
    expectFinding(report, Grade::kUsable, {"Source 8, hat could not be calibrated"});
    EXPECT_EQ(calibratedCount(report), 7);
    EXPECT_FALSE(report.applied({}).findSource("hat"));
    JigTake silent = jig;
    std::erase_if(silent.observations.flights,
                  [](const FlightTime& flight) { return flight.board == 5 || flight.source == 0; });
    const SourceOffsetReport deaf = silent.solve();
    expectFinding(deaf, Grade::kNotUsable, {"Board 6, l_arm heard no source"});
    expectFinding(deaf, Grade::kUsable, {"Source 1, chest_l could not be calibrated", "no board heard it"});
}

TEST(SourceOffsetMistakes, TooFewMeasurementsAreNotEnough) {
    const JigTake& jig = nominalJig();
    KnownDistances known = jig.known();
    std::erase_if(known.distances, [](const KnownDistance& distance) {
        return distance.source == "navel" && (distance.placement != "1" || distance.board > "head");
    });
    const SourceOffsetReport report = calibrateSourceOffsets({jig.observations}, known);
    expectFinding(report, Grade::kUsable, {"Source 5, navel could not be calibrated", "2 of 2"});
    known.distances.resize(1);
    const SourceOffsetReport single = calibrateSourceOffsets({jig.observations}, known);
    EXPECT_EQ(single.grade(), Grade::kNotUsable);
    EXPECT_EQ(calibratedCount(single), 0);
}

TEST(SourceOffsetMistakes, DistancesAllAlikeCannotTellTheSpeedOfSound) {
    const JigTake& jig = nominalJig();
    KnownDistances known = jig.known();
    std::erase_if(known.distances, [](const KnownDistance& distance) {
        return distance.placement != "4" || distance.distance_m < 0.59 || distance.distance_m > 0.61;
    });
    for (KnownDistance& distance : known.distances)
        distance.sigma_m = 2e-3;
    const SourceOffsetReport report = calibrateSourceOffsets(
        {jig.observations}, known,
        {.speed_of_sound = SourceOffsetSettings::SpeedOfSound::kEstimate, .min_measurements = 1});
    expectFinding(report, Grade::kUsable, {"too much alike to tell the speed of sound"});
    EXPECT_NE(report.grade(), Grade::kGood);
}

TEST(SourceOffsetMistakes, AFileOfAnotherJigIsNotUsable) {
    const JigTake& jig = nominalJig();
    for (const SourceOffsetReport& report :
         {jig.solveWith(nominalJig(2).csv), jig.solveWith(test::withRows(jig.csv, [](CsvCells& cells) {
              if (cells[1] == "board")
                  std::swap(cells[3], cells[4]);
          }))}) {
        EXPECT_EQ(report.grade(), Grade::kNotUsable) << findingsText(report.findings);
        EXPECT_LT(report.findings.size(), 60u);
    }
}

TEST(SourceOffsetMistakes, TakesWithoutAJigAreRefusedInWords) {
    const JigTake& jig = nominalJig();
    expectFinding(calibrateSourceOffsets({}, jig.known()), Grade::kNotUsable, {"no take"});
    Observations take = jig.observations;
    take.placements.clear();
    expectFinding(calibrateSourceOffsets({take}, jig.known()), Grade::kNotUsable, {"no placements"});
    take = jig.observations;
    take.kind = "motion";
    EXPECT_EQ(calibrateSourceOffsets({take}, jig.known()).grade(), Grade::kGood);
    take.suit.boards.pop_back();
    expectFinding(calibrateSourceOffsets({jig.observations, take}, jig.known()), Grade::kNotUsable,
                  {"another suit"});
    take = jig.observations;
    take.suit = {};
    EXPECT_EQ(calibrateSourceOffsets({take}, jig.known()).grade(), Grade::kNotUsable);
    take = jig.observations;
    take.flights.clear();
    expectFinding(calibrateSourceOffsets({take}, jig.known()), Grade::kNotUsable,
                  {"No source could be calibrated"});
    EXPECT_EQ(calibrateSourceOffsets({jig.observations}, {"empty.csv", {}}).grade(), Grade::kNotUsable);
}

TEST(SourceOffsetMistakes, WildValuesAreIgnored) {
    JigTake jig = nominalJig();
    jig.observations.flights[1000].flight_s = std::nan("");
    jig.observations.flights[2000].c_m_per_s = 0;
    jig.observations.flights[3000].board = 99;
    jig.observations.flights[4000].source = -1;
    KnownDistances known = jig.known();
    known.distances[10].distance_m = std::nan("");
    known.distances[20].distance_m = 0;
    const SourceOffsetReport report = calibrateSourceOffsets({jig.observations}, known);
    EXPECT_LT(jig.worstError_m(report), kStillRight_m);
    EXPECT_EQ(report.measurements.size(), known.distances.size() - 2);
}

TEST(SourceOffsetMistakes, DamagedTablesNeverStopTheSolver) {
    JigTake jig = nominalJig();
    std::erase_if(jig.observations.flights,
                  [](const FlightTime& flight) { return flight.board > 3 || flight.source > 2; });
    const std::string few = test::withRows(jig.csv, [](CsvCells& cells) {
        if (cells[0] > "3" || !(cells[2] == "hips" || cells[2] == "chest_l" || cells[2] == "chest_r" ||
                                cells[2] == "head" || cells[2] == "spine"))
            cells.clear();
    });
    int64_t solved = 0;
    test::feedDamaged({few}, 1500, 40000, [&](const std::string& csv, int64_t) {
        const auto known = readDigitizerCsv(csv, "damaged.csv");
        if (!known)
            return;
        ++solved;
        const SourceOffsetReport report = calibrateSourceOffsets({jig.observations}, *known);
        for (const SourceOffset& source : report.sources)
            EXPECT_TRUE(!source.calibrated || (std::isfinite(source.offset_s) && source.sigma_s > 0));
        EXPECT_TRUE(std::isfinite(report.all_left_out.mean_m));
    });
    EXPECT_GT(solved, 0);
}

}  // namespace
}  // namespace noctule
