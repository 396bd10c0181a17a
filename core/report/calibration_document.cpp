// SPDX-License-Identifier: Apache-2.0
#include "core/report/calibration_document.h"

#include "core/body/text.h"
#include "core/report/html.h"
#include "core/report/verdict.h"

namespace noctule {
namespace {

std::string headlineOf(const CalibrationDocument& document) {
    return gradeName(gradeOf(document.findings)) + ". " + document.summary + ".";
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string sectionOf(const CalibrationTable& table, size_t number) {
    html::Table cells{table.title, {}, {}};
    for (const std::string& column : table.columns)
        cells.columns.push_back({column, !cells.columns.empty()});
    for (const auto& row : table.rows) {
        html::Row escaped;
        for (const std::string& cell : row)
            escaped.cells_html.push_back(text::escaped(cell));
        cells.rows.push_back(escaped);
    }
    return html::section("table" + std::to_string(number), table.title, table.lead, html::table(cells));
}

/// Bytes that begin a character.
size_t widthOf(const std::string& utf8) {
    return static_cast<size_t>(std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& cell, size_t width, bool to_the_right) {
    const std::string space(width - std::min(width, widthOf(cell)), ' ');
    return to_the_right ? space + cell : cell + space;
}

std::string textOf(const CalibrationTable& table) {
    std::vector<size_t> widths;
    for (const std::string& column : table.columns)
        widths.push_back(widthOf(column));
    for (const auto& row : table.rows)
        for (size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], widthOf(row[i]));
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text = "  ";
        for (size_t i = 0; i < cells.size(); ++i)
            text += (i == 0 ? "" : "  ") + padded(cells[i], widths[i], i > 0);
        return text + "\n";
    };
    std::string text = "\n" + table.title + "\n" + line(table.columns);
    for (const auto& row : table.rows)
        text += line(row);
    return text;
}

}  // namespace

std::string sentenceOf(const Finding& finding) {
    return finding.what + "." + (finding.remedy.empty() ? "" : " " + finding.remedy + ".");
}

std::string calibrationHtml(const CalibrationDocument& document) {
    std::vector<std::string> sentences;
    for (const Finding& finding : document.findings)
        sentences.push_back(sentenceOf(finding));
    std::string body = "<section id=\"summary\" aria-labelledby=\"verdict\">" +
                       html::verdict(gradeOf(document.findings), headlineOf(document),
                                     "From " + joined(document.takes) + ".") +
                       html::problems(sentences) + "</section>\n";
    for (size_t i = 0; i < document.tables.size(); ++i)
        body += sectionOf(document.tables[i], i + 1);
    return html::page(document.procedure, "Calibration", text::utc(document.created_utc), body,
                      "Standard deviations are those that the recording itself implies.");
}

std::string calibrationText(const CalibrationDocument& document) {
    std::string text = document.procedure + ": " + headlineOf(document) + "\n";
    for (const Finding& finding : document.findings)
        text += "  " + sentenceOf(finding) + "\n";
    for (const CalibrationTable& table : document.tables)
        text += textOf(table);
    return text;
}

}  // namespace noctule
