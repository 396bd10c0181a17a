// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/error_plot.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>

#include "tests/ui/support/painted_text.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Of a plot with one row whose good errors end at half of `most`, from left to right; the last without its
/// unit.
std::vector<test::PaintedText> ticksUpTo(double most) {
    CalibrationErrors errors{"Errors", "mm", most / 2, {{"row", {}, {most}}}};
    ErrorPlot plot;
    plot.setErrors(errors);
    plot.resize(700, plot.sizeHint().height());
    std::vector<test::PaintedText> ticks;
    for (test::PaintedText& painted : test::TextRecorder::textsOf(plot)) {
        painted.text.remove("mm");
        painted.text = painted.text.trimmed();
        if (painted.text != "row" && !painted.text.isEmpty())
            ticks.push_back(painted);
    }
    std::ranges::sort(ticks, {}, [](const test::PaintedText& tick) { return tick.place.center().x(); });
    return ticks;
}

TEST(ErrorPlotTest, TicksStandWhereTheirNumbersSay) {
    Theme::install(*qApp);
    for (const double most : {0.4, 5.0, 10.0, 37.0}) {
        SCOPED_TRACE(most);
        const std::vector<test::PaintedText> ticks = ticksUpTo(most);
        ASSERT_EQ(ticks.size(), 5u);
        const double last = QLocale().toDouble(ticks.back().text);
        EXPECT_GE(last, most);
        EXPECT_LE(last, 2.5 * most) << "most of the plot is used";
        for (size_t i = 0; i < ticks.size(); ++i) {
            bool is_number = false;
            EXPECT_NEAR(QLocale().toDouble(ticks[i].text, &is_number), static_cast<double>(i) * last / 4,
                        1e-9);
            EXPECT_TRUE(is_number) << ticks[i].text.toStdString();
        }
        const double step_px = ticks[2].place.center().x() - ticks[1].place.center().x();
        EXPECT_NEAR(ticks[3].place.center().x() - ticks[2].place.center().x(), step_px, 1.5);
    }
}

TEST(ErrorPlotTest, ErrorsBeyondTheScaleAreKnownOfBothCalibrations) {
    Theme::install(*qApp);
    ErrorPlot plot;
    const auto beyond = [&plot](std::vector<double> before, std::vector<double> after) {
        plot.setErrors({"Errors", "mm", 1, {{"row", std::move(before), std::move(after)}}});
        return plot.hasBeyondScale();
    };
    EXPECT_FALSE(beyond({}, {0.5, 1}));
    EXPECT_TRUE(beyond({300}, {0.5, 1}));
    EXPECT_TRUE(beyond({}, std::vector<double>{0.5, 0.5, 0.5, 90}));
}

}  // namespace
}  // namespace noctule::ui
