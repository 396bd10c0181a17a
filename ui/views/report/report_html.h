// SPDX-License-Identifier: Apache-2.0
// The report as rich text: the markup of core/report in the subset that QTextDocument draws, with the
// drawings taken out as figures ("figure:3").
#pragma once

#include <QString>
#include <vector>

#include "core/report/html_report.h"
#include "ui/views/report/report_figure.h"

namespace noctule::ui {

struct ReportDocument {
    QString html;
    std::vector<ReportFigure> figures;
};

/// `page_width` in pixels: what plots fill. An anchor stands before every part, under its id.
ReportDocument reportDocument(const std::vector<ReportPart>& parts, int page_width);
/// For QTextDocument::setDefaultStyleSheet().
QString reportStyle(double zoom);
/// Of a figure on a page, in pixels at 100 percent zoom.
QSize figureSize(const ReportFigure& figure, int page_width);

}  // namespace noctule::ui
