// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_html.h"

#include <gtest/gtest.h>

#include <QApplication>

#include "core/report/html.h"
#include "core/report/svg_plot.h"
#include "ui/style/theme.h"

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

}  // namespace
}  // namespace noctule::ui
