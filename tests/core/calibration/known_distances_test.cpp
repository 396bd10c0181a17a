// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/known_distances.h"

#include <gtest/gtest.h>

#include "tests/support/fuzzing.h"

namespace noctule {
namespace {

const char* const kPoints =
    "placement,kind,id,x_m,y_m,z_m\n"
    "A,source,hat,0,0,0.5\n"
    "A,board,hips,0.3,0,0.1\n"
    "A,board,l_hand,0,0,0\n";

void expectThePoints(const Result<KnownDistances>& known) {
    ASSERT_TRUE(known) << known.error().text();
    ASSERT_EQ(known->distances.size(), 2u);
    for (const auto& [index, board, distance_m] :
         {std::tuple{0, "hips", 0.5}, std::tuple{1, "l_hand", 0.5}}) {
        const KnownDistance& found = known->distances[static_cast<size_t>(index)];
        EXPECT_EQ(found.placement, "A");
        EXPECT_EQ(found.source, "hat");
        EXPECT_EQ(found.board, board);
        EXPECT_NEAR(found.distance_m, distance_m, 1e-12);
        EXPECT_GT(found.sigma_m, 0);
    }
}

void expectError(const Result<KnownDistances>& known, const std::vector<std::string>& words) {
    ASSERT_FALSE(known);
    EXPECT_EQ(known.error().kind, ErrorKind::kUnreadable);
    EXPECT_FALSE(known.error().remedy.empty());
    for (const std::string& word : words)
        EXPECT_NE(known.error().text().find(word), std::string::npos)
            << word << " in " << known.error().text();
}

TEST(DigitizerCsv, GivesTheDistanceOfEveryPairOfAPlacement) {
    expectThePoints(readDigitizerCsv(kPoints, "jig.csv"));
}

TEST(DigitizerCsv, ReadsWhatSpreadsheetsMakeOfIt) {
    expectThePoints(
        readDigitizerCsv("\xEF\xBB\xBFz_mm;note;ID;Kind;placement;X_mm;y_mm\r\n"
                         "\r\n"
                         "500;\"left; \"\"up\"\"\";hat;source;A;0;0\r\n"
                         ";;;;;;\r\n"
                         "100;;hips;board;A;300,0;0\r\n"
                         "0;;\"l_hand\";board; A ;0;+0;;",
                         "jig.csv"));
    expectThePoints(
        readDigitizerCsv("placement\tkind\tid\tx_m\ty_m\tz_m\rA\tsource\that\t0\t0\t0,5\r"
                         "A\tboard\thips\t0,3\t0\t1e-1\rA\tboard\tl_hand\t0\t0\t0\r",
                         "jig.csv"));
}

TEST(DigitizerCsv, NamesFileLineAndColumnOfAMistake) {
    const std::string points = kPoints;
    const auto with = [&](const std::string& row) {
        return readDigitizerCsv(points + row + "\n", "jig.csv");
    };
    expectError(with("A,board,spine,0,zero,0"), {"jig.csv", "line 5", "y_m", "\"zero\""});
    expectError(with("A,board,spine,0,nan,0"), {"line 5", "y_m", "\"nan\""});
    expectError(with("A,board,spine,0,1e999,0"), {"line 5", "y_m"});
    expectError(with("A,board,spine,0,0"), {"line 5", "z_m", "empty"});
    expectError(with(",board,spine,0,0,0"), {"line 5", "placement", "empty"});
    expectError(with("A,microphone,spine,0,0,0"), {"line 5", "\"microphone\"", "source or board"});
    expectError(with("A,board,spine,0,1,0,0,0"), {"line 5", "8 cells", "6 columns", "semicolons"});
    expectError(with("A,board,hips,0,0,0"), {"line 5", "hips", "line 3"});
    expectError(with("A,board,\"spine,0,0,0"), {"line 5", "quotation"});
    expectError(with("B,board,spine,0,0,0"), {"\"B\"", "no row of a source"});
    expectError(readDigitizerCsv("", "jig.csv"), {"jig.csv", "empty"});
    expectError(readDigitizerCsv("\n \n", "jig.csv"), {"jig.csv", "empty"});
    expectError(readDigitizerCsv("placement,kind,id,x_m,y_m,z_m\n", "jig.csv"), {"no row"});
    expectError(readDigitizerCsv("placement,kind,x_m,y_m,z_m\nA,source,0,0,0\n", "jig.csv"), {"id"});
    expectError(readDigitizerCsv("placement,kind,id,x_m,y_mm,z_m\nA,source,s,0,0,0\n", "jig.csv"),
                {"millimetres", "one unit"});
    expectError(readDigitizerCsv("placement,kind,id,x_m,x_m,y_m,z_m\n", "jig.csv"), {"two columns", "x_m"});
    expectError(readDigitizerCsv("placement,kind,id,x_cm,y_cm,z_cm\nA,source,s,0,0,0\n", "jig.csv"),
                {"x_m, y_m or z_m"});
    expectError(readDigitizerCsv("placement,source,board,distance_m\nA,hat,hips,0.5\n", "jig.csv"),
                {"other kind"});
    expectError(readDigitizerCsv(std::string("placement\0,kind,id\n", 19), "jig.csv"), {"UTF-8"});
    std::string crowd = points;
    for (int i = 0; i < 40; ++i)
        crowd += "A,board,b" + std::to_string(i) + ",0,0,0\n";
    expectError(readDigitizerCsv(crowd, "jig.csv"), {"more than 32", "board"});
}

TEST(TapeMeasureCsv, ReadsMetresAndMillimetres) {
    for (const char* text : {"placement,source,board,distance_m\n1,hat,hips,0.5125\n1,hat,head,0.3\n",
                             "board;distance_mm;source;placement\nhips;512,5;hat;1\nhead;300;hat;1\n"}) {
        const auto known = readTapeMeasureCsv(text, "tape.csv");
        ASSERT_TRUE(known) << known.error().text();
        ASSERT_EQ(known->distances.size(), 2u);
        EXPECT_EQ(known->distances[0].board, "hips");
        EXPECT_NEAR(known->distances[0].distance_m, 0.5125, 1e-12);
        EXPECT_NEAR(known->distances[1].distance_m, 0.3, 1e-12);
        EXPECT_EQ(known->distances[0].sigma_m, kTapeSigma_m);
    }
}

TEST(TapeMeasureCsv, NamesFileLineAndColumnOfAMistake) {
    const auto with = [](const std::string& row) {
        return readTapeMeasureCsv("placement,source,board,distance_m\n1,hat,hips,0.5\n" + row + "\n",
                                  "tape.csv");
    };
    expectError(with("1,hat,hips,0.6"), {"tape.csv", "line 3", "line 2"});
    expectError(with("1,hat,head,-0.6"), {"line 3", "above 0"});
    expectError(with("1,hat,head,0"), {"line 3", "above 0"});
    expectError(with("1,hat,head,inf"), {"line 3", "distance_m"});
    expectError(with("1,hat,,0.6"), {"line 3", "board", "empty"});
    expectError(with("1,hat,head,0,6"), {"line 3", "5 cells", "semicolons"});
    expectError(readTapeMeasureCsv(kPoints, "tape.csv"), {"other kind"});
    expectError(readTapeMeasureCsv("placement,source,board\n1,a,b\n", "tape.csv"), {"distance_m"});
}

TEST(KnownDistances, DamagedTablesAreReadOrRefused) {
    const std::vector<std::string> examples = {
        kPoints, "placement;source;board;distance_mm\r\n1;hat;hips;512,5\r\n1;hat;head;300\r\n"};
    test::feedDamaged(examples, 20000, 20000, [](const std::string& text, int64_t) {
        for (const auto& known : {readDigitizerCsv(text, "d.csv"), readTapeMeasureCsv(text, "t.csv")})
            if (known) {
                EXPECT_FALSE(known->distances.empty());
                for (const KnownDistance& distance : known->distances)
                    EXPECT_FALSE(distance.placement.empty() || distance.source.empty() ||
                                 distance.board.empty());
            } else {
                EXPECT_FALSE(known.error().message.empty() || known.error().remedy.empty());
            }
    });
}

}  // namespace
}  // namespace noctule
