// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_html.h"

#include <gtest/gtest.h>

#include <QApplication>

#include "core/report/html.h"
#include "core/report/html_report.h"
#include "core/report/svg_plot.h"
#include "tests/core/report/made_report.h"
#include "ui/style/theme.h"
#include "ui/views/report/report_view.h"

namespace noctule::ui {
namespace {

TEST(ReportHtml, WhatABrowserFoldsIsHeadedAndThereInTheStudio) {
    const std::string part =
        html::section("joints", "Joints", "", html::folded("Left arm", html::heading("Left wrist")));
    const QString page = reportDocument({{"joints", "Joints", part}}, 800).html;
    EXPECT_TRUE(page.contains("<h2>Left arm</h2>")) << page.toStdString();
    EXPECT_TRUE(page.contains("Left wrist</h3>")) << page.toStdString();
    EXPECT_FALSE(page.contains("summary") || page.contains("details")) << page.toStdString();
}

TEST(ReportHtml, NarrowPlotsStandTwoInARowWhereTheyStayReadable) {
    Theme::install(*qApp);
    LinePlot plot;
    plot.title = "Left wrist";
    plot.time_s = {0, 10};
    plot.values = {0, 1};
    plot.width_px = 488;
    const std::string part = html::section(
        "joints", "Joints", "",
        html::heading("Left wrist") + "<div class=\"pair\">" + svg(plot) + svg(plot) + "</div>");
    const auto imagesOf = [&](int page_width) {
        return reportDocument({{"joints", "Joints", part}}, page_width).html;
    };
    const QString wide = imagesOf(1000), narrow = imagesOf(600);
    EXPECT_EQ(wide.count("width=\"488\""), 2) << wide.toStdString();
    EXPECT_EQ(narrow.count("width=\"600\""), 2) << narrow.toStdString();
    for (const QString& page : {wide, narrow})
        EXPECT_EQ(page.count("<p class=\"figure\">"), 1) << "both in one, which is not the heading's";
}

/// Between both panels of Review in a window of 1280 pixels it has 525.
TEST(ReportHtml, TablesFitTheSmallestWindow) {
    Theme::install(*qApp);
    ReportBrowser page;
    page.resize(525, 700);
    ReportData data = noctule::test::madeReport(5);
    for (AngleStatistics* angle :
         {&data.runs.back().comparison->joints[0].angle, &data.runs.back().comparison->joints[3].angle})
        *angle = {47.123, 31.456, 52.789, 179.9, -12.345, 44.321, 99.876};
    std::vector<ReportPart> parts = reportParts(data);
    std::erase_if(parts, [](const ReportPart& part) {
        return part.id != "joints" && part.id != "ranges" && part.id != "inertia";
    });
    ASSERT_EQ(parts.size(), 3u);
    page.setParts(std::move(parts));
    EXPECT_LE(page.document()->size().width(), page.width());
    EXPECT_EQ(page.horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
}

}  // namespace
}  // namespace noctule::ui
