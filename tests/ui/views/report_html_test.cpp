// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_html.h"

#include <gtest/gtest.h>

#include "core/report/html.h"

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

}  // namespace
}  // namespace noctule::ui
