// SPDX-License-Identifier: Apache-2.0
#include "ui/style/words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace noctule::ui {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void expectText(const QString& text, const char* expected) {
    EXPECT_EQ(text.toStdString(), expected);
}

class WordsTest : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale::c()); }
    void TearDown() override { QLocale::setDefault(before_); }

private:
    QLocale before_;
};

TEST_F(WordsTest, time) {
    expectText(timeText(17.4), "0:17.4");
    expectText(timeText(0), "0:00.0");
    expectText(timeText(59.96), "1:00.0");
    expectText(timeText(31.6, 2), "0:31.60");
    expectText(timeText(42.4, 0), "0:42");
    expectText(timeText(3725, 0), "1:02:05");
    expectText(timeText(-0.412, 3), "−0:00.412");
    expectText(timeText(-0.04), "0:00.0");
    expectText(timeText(kNone), "–");
}

TEST_F(WordsTest, AFullStopIsAddedOnce) {
    expectText(withFullStop("The box is gone"), "The box is gone.");
    expectText(withFullStop("The box is gone."), "The box is gone.");
}

TEST_F(WordsTest, TimesOfTheDayHaveTwoDigitsEach) {
    expectText(clockText(QTime(9, 5, 1)), "09:05:01");
    expectText(clockText(QTime(23, 0, 59)), "23:00:59");
}

TEST_F(WordsTest, NoLineEndsWithinAUnit) {
    expectText(unbroken("known to 0.003 °/s and 0.11 %. Two words"),
               "known to 0.003\u00a0°/\u2060s and 0.11\u00a0%. Two words");
}

TEST_F(WordsTest, units) {
    expectText(degreesText(24.1 * kPi / 180), "24.1°");
    expectText(degreesText(-kPi / 2, 0), "−90°");
    expectText(millimetresText(0.0018), "1.8\u00A0mm");
    expectText(percentText(0.914), "91\u00A0%");
    expectText(secondsText(27.4), "27.4\u00A0s");
    expectText(millimetresText(kNone), "–");
    expectText(degreesText(std::numeric_limits<double>::infinity()), "–");
}

TEST_F(WordsTest, whatRoundsToZeroHasNoSign) {
    expectText(numberText(-0.04, 1), "0.0");
    expectText(numberText(-0.06, 1), "−0.1");
}

TEST_F(WordsTest, groups) {
    expectText(countText(836), "836");
    expectText(countText(3836), "3\u2009836");
    expectText(countText(-1234567), "−1\u2009234\u2009567");
    expectText(numberText(12345.6, 1), "12\u2009345.6");
}

TEST_F(WordsTest, milliseconds) {
    expectText(millisecondsText(0.0434), "43\u00A0ms");
    expectText(millisecondsText(std::numeric_limits<double>::quiet_NaN()), "–");
}

TEST_F(WordsTest, keys) {
    expectText(keysText(QKeySequence("Ctrl+R")), "Ctrl+R");
    expectText(keysText(QKeySequence("Del")), "Del");
    expectText(keysText(QKeySequence(Qt::Key_Return)), "Enter");
    expectText(keysText(QKeySequence("Ctrl+Return")), "Ctrl+Enter");
}

TEST_F(WordsTest, bytes) {
    expectText(bytesText(512), "512\u00A0B");
    expectText(bytesText(2'900'000), "2.9\u00A0MB");
    expectText(bytesText(194'000'000), "194\u00A0MB");
    expectText(bytesText(999'999), "1.0\u00A0MB");
    expectText(bytesText(780'000'000'000), "780\u00A0GB");
}

TEST_F(WordsTest, dates) {
    const QDateTime now(QDate(2026, 11, 18), QTime(12, 0));
    expectText(dateText(QDateTime(QDate(2026, 11, 18), QTime(9, 5)), now), "Today, 09:05");
    expectText(dateInside(QDateTime(QDate(2026, 11, 18), QTime(9, 5)), now), "today, 09:05");
    expectText(ageText(now.addSecs(-60), now), "just now");
    expectText(ageText(now.addSecs(-40 * 60), now), "40 min");
    expectText(ageText(now.addDays(-12), now), "12 day(s)");
    expectText(dateText(QDateTime(QDate(2026, 11, 17), QTime(23, 59)), now), "Yesterday");
    expectText(dateText(QDateTime(QDate(2026, 11, 16), QTime(1, 0)), now), "16 November");
    expectText(dateText(QDateTime(QDate(2025, 12, 31), QTime(1, 0)), now), "31 December 2025");
    expectText(dateText(QDateTime(), now), "–");
}

TEST_F(WordsTest, germanDecimalsAndMonths) {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    expectText(timeText(17.4), "0:17,4");
    expectText(degreesText(24.1 * kPi / 180), "24,1°");
    expectText(numberText(12345.6, 1), "12\u2009345,6");
    expectText(countText(3836), "3\u2009836");
    const QDateTime now(QDate(2026, 11, 18), QTime(12, 0));
    expectText(dateText(QDateTime(QDate(2026, 5, 16), QTime(1, 0)), now), "16 Mai");
}

}  // namespace
}  // namespace noctule::ui
