// SPDX-License-Identifier: Apache-2.0
#include "ui/style/lengths.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <limits>

namespace noctule::ui {
namespace {

class LengthsTest : public testing::Test {
protected:
    void TearDown() override { chooseUnits(Units::kMetric); }
};

TEST_F(LengthsTest, AreMetricUnlessChosenOtherwise) {
    QSettings().clear();
    EXPECT_EQ(chosenUnits(), Units::kMetric);
    EXPECT_EQ(lengthText(1.78).toStdString(), "1.78\u00A0m");
    EXPECT_EQ(shortLengthText(0.25).toStdString(), "25.0\u00A0cm");
    EXPECT_EQ(lengthText(std::numeric_limits<double>::quiet_NaN()).toStdString(), "–");
}

TEST_F(LengthsTest, TheChoiceIsKeptAndReadOnce) {
    chooseUnits(Units::kImperial);
    EXPECT_EQ(QSettings().value("units").toString(), "imperial");
    QSettings().clear();
    EXPECT_EQ(chosenUnits(), Units::kImperial) << "for each cell of a table the file would be looked at";
}

TEST_F(LengthsTest, AreWrittenInFeetAndInches) {
    chooseUnits(Units::kImperial);
    const std::pair<double, const char*> kTexts[] = {{1.8034, "5′11″"},  {1.78, "5′10.1″"}, {0.25, "9.8″"},
                                                     {1.8288, "6′"},     {1.8287, "6′"},    {0.9144, "3′"},
                                                     {-1.6002, "−5′3″"}, {0, "0″"},         {-0.0001, "0″"}};
    for (const auto& [metres, text] : kTexts)
        EXPECT_EQ(lengthText(metres).toStdString(), text);
    EXPECT_EQ(shortLengthText(0.25).toStdString(), "9.8″");
    EXPECT_EQ(lengthText(1.78, 2, Units::kMetric).toStdString(), "1.78\u00A0m") << "of files";
    EXPECT_EQ(lengthText(std::numeric_limits<double>::infinity()).toStdString(), "–");
}

TEST_F(LengthsTest, AreReadInEveryUnit) {
    const std::pair<const char*, double> kTyped[] = {
        {"5'11\"", 1.8034},  {"5′11″", 1.8034}, {"5’ 11”", 1.8034},    {"5 ft 11 in", 1.8034},
        {"5'11", 1.8034},    {"6 ft.", 1.8288}, {"5' 10.5''", 1.7907}, {"71 in", 1.8034},
        {"71 Zoll", 1.8034}, {"180 cm", 1.8},   {"180\u00A0cm", 1.8},  {"1.8 m", 1.8},
        {"1,8 m", 1.8},      {"1800 mm", 1.8},  {"57 CM", 0.57},       {"57", 0.57}};
    for (const auto& [text, metres] : kTyped) {
        const auto length_m = lengthFrom(QString::fromUtf8(text), 0.01);
        ASSERT_TRUE(length_m) << text;
        EXPECT_EQ(*length_m, metres) << text;
    }
    EXPECT_EQ(lengthFrom("71", kMetresPerInch), 1.8034);
    for (const char* nonsense : {"", "abc", "-5", "1e9", "5 km", "'", "5'11 cm", "180 cm 2"})
        EXPECT_FALSE(lengthFrom(nonsense, 0.01)) << nonsense;
}

}  // namespace
}  // namespace noctule::ui
