// SPDX-License-Identifier: Apache-2.0
#include "core/report/html.h"

#include <algorithm>

#include "core/body/text.h"
#include "core/report/style.h"

namespace noctule::html {

using text::escaped;

namespace {

constexpr const char* kMark =
    "<svg class=\"mark\" viewBox=\"0 0 26 18\" aria-hidden=\"true\"><path d=\"M13 3.2l1.5-1.7 1 2.4c2-.2 "
    "2.9-1.6 "
    "3-3.4 3.4 1.5 6.2 4.6 7 9.5-1.7-1.100-3.5-1-4.9.3-1.5-1.2-3.3-.8-4.2 1-.7 1.7-1.8 "
    "3.4-3.4 5-1.6-1.6-2.7-3.3-3.4-5-.9-1.8-2.7-2.2-4.2-1-1.4-1.3-3.2-1.4-4.9-.3.8-4.9 "
    "3.6-8 7-9.5.1 1.8 1 3.2 3 3.4l1-2.4z\"/></svg>";

/// Style class and icon.
struct Badge {
    std::string css_class, icon;
};

Badge badgeOf(Grade grade) {
    switch (grade) {
        case Grade::kGood:
            return {"ok", "check"};
        case Grade::kUsable:
            return {"warn", "warn"};
        case Grade::kNotUsable:
            return {"err", "err"};
        case Grade::kUnknown:
            break;
    }
    return {"info", "info"};
}

/// A row of headings over neighbouring columns; nothing when no column belongs to a group.
std::string groupRow(const std::vector<Column>& columns) {
    std::string out = "<tr>";
    bool any = false;
    for (size_t i = 0, end = 0; i < columns.size(); i = end) {
        for (end = i + 1; end < columns.size() && columns[end].group == columns[i].group;)
            ++end;
        const std::string span = " colspan=\"" + std::to_string(end - i) + "\"";
        if (columns[i].group.empty())
            out += "<td" + span + "></td>";
        else
            out +=
                "<th class=\"group\" scope=\"colgroup\"" + span + ">" + escaped(columns[i].group) + "</th>";
        any = any || !columns[i].group.empty();
    }
    return any ? out + "</tr>" : "";
}

}  // namespace

std::string page(const std::string& title, const std::string& kind, const std::string& about,
                 const std::string& body_html, const std::string& footer) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(title) +
           ", " + escaped(kind) +
           "</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
           "<meta name=\"generator\" content=\"Noctule\"><style>" +
           styleSheet() + "</style></head>\n<body><header><div>" + kMark + "<strong>" + escaped(title) +
           "</strong><span>" + escaped(about) + "</span><span class=\"what\">" + escaped(kind) +
           "</span></div></header>\n<main>" + body_html + "<footer>Made by Noctule. " + escaped(footer) +
           "</footer></main></body></html>\n";
}

std::string verdict(Grade grade, const std::string& headline, const std::string& explanation) {
    const Badge badge = badgeOf(grade);
    return "<div class=\"verdict\"><div class=\"badge " + badge.css_class + "\">" + icon(badge.icon) +
           "</div><h1 id=\"verdict\">" + escaped(headline) + "</h1><p>" + escaped(explanation) +
           "</p></div>\n";
}

std::string problems(const std::vector<std::string>& sentences) {
    if (sentences.empty())
        return "";
    std::string out = "<ul class=\"problems\">";
    for (const std::string& sentence : sentences)
        out += "<li>" + icon("warn") + "<span>" + escaped(sentence) + "</span></li>";
    return out + "</ul>\n";
}

std::string table(const Table& table) {
    std::string out = "<div class=\"scroll\"><table><caption>" + escaped(table.caption) +
                      "</caption><thead>" + groupRow(table.columns) + "<tr>";
    for (const Column& column : table.columns)
        out += std::string("<th scope=\"col\"") + (column.is_number ? "" : " class=\"word\"") + ">" +
               escaped(column.title) + "</th>";
    out += "</tr></thead><tbody>\n";
    for (const Row& row : table.rows) {
        out += row.css_class.empty() ? "<tr>" : "<tr class=\"" + row.css_class + "\">";
        for (size_t i = 0; i < row.cells_html.size(); ++i) {
            const bool is_word = i < table.columns.size() && !table.columns[i].is_number;
            const std::string tag = i == 0 ? "th" : "td";
            out += "<" + tag + (i == 0 ? " scope=\"row\"" : "") + (is_word ? " class=\"word\"" : "") + ">" +
                   row.cells_html[i] + "</" + tag + ">";
        }
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& lead,
                    const std::string& body_html) {
    return "<section id=\"" + id + "\" aria-labelledby=\"" + id + "-title\"><h2 id=\"" + id + "-title\">" +
           escaped(title) + "</h2>" + (lead.empty() ? "" : "<p class=\"lead\">" + escaped(lead) + "</p>") +
           "\n" + body_html + "</section>\n";
}

std::string nothing(const std::string& sentence) {
    return "<p class=\"nothing\">" + escaped(sentence) + "</p>\n";
}

std::string heading(const std::string& text) {
    return "<h3>" + escaped(text) + "</h3>\n";
}

std::string folded(const std::string& title, const std::string& body_html) {
    return "<details><summary>" + escaped(title) + "</summary>\n" + body_html + "</details>\n";
}

std::string note(const std::string& sentence) {
    return "<p class=\"note\">" + escaped(sentence) + "</p>\n";
}

std::string list(const std::vector<std::string>& sentences) {
    std::string out = "<ul class=\"statements\">";
    for (const std::string& sentence : sentences)
        out += "<li>" + escaped(sentence) + "</li>";
    return out + "</ul>\n";
}

std::string definitions(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string out = "<dl>";
    for (const auto& [name, value] : entries)
        out += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>";
    return out + "</dl>\n";
}

std::string bar(const std::vector<std::pair<double, std::string>>& parts, const std::string& words) {
    std::string out =
        "<svg class=\"bar\" role=\"img\" viewBox=\"0 0 200 8\" preserveAspectRatio=\"none\"><title>" +
        escaped(words) + "</title><rect class=\"track\" width=\"200\" height=\"8\"/>";
    double x = 0;
    for (const auto& [share, css_class] : parts) {
        const double width = 200 * std::clamp(share, 0.0, 1.0);
        if (width > 0)
            out += "<rect class=\"" + css_class + "\" x=\"" + text::coordinate(x) + "\" width=\"" +
                   text::coordinate(width) + "\" height=\"8\"/>";
        x += width;
    }
    return out + "</svg>";
}

std::string key(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string out = "<p class=\"key\">";
    for (const auto& [css_class, word] : entries)
        out += "<span><svg viewBox=\"0 0 12 12\" aria-hidden=\"true\"><rect class=\"" + css_class +
               "\" width=\"12\" height=\"12\" rx=\"2\"/></svg>" + escaped(word) + "</span>";
    return out + "</p>\n";
}

std::string scale(const std::string& low, const std::string& high) {
    std::string out = "<p class=\"key\"><span>" + escaped(low) +
                      "</span><span><svg viewBox=\"0 0 210 12\" style=\"width:210px\" aria-hidden=\"true\">";
    for (int i = 0; i <= 20; ++i)
        out += "<rect class=\"" + confidenceClass(i / 20.0) + "\" x=\"" + std::to_string(10 * i) +
               "\" width=\"10.2\" height=\"12\"/>";
    return out + "</svg></span><span>" + escaped(high) + "</span></p>\n";
}

std::string icon(const std::string& name) {
    std::string strokes = "M2.5 8.5l3.6 3.6 7.4-8";  // check
    if (name == "warn")
        strokes = "M8 2.2L14.5 13.5H1.5zM8 6.5v3.2M8 11.6v.1";
    else if (name == "err")
        strokes = "M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 4.8v3.9M8 11v.1";
    else if (name == "info")
        strokes = "M8 1.8a6.2 6.2 0 110 12.4A6.2 6.2 0 018 1.8zM8 7.3v4M8 4.8v.1";
    return "<svg class=\"icon\" viewBox=\"0 0 16 16\" aria-hidden=\"true\"><path d=\"" + strokes +
           "\"/></svg>";
}

}  // namespace noctule::html
