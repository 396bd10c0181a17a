// SPDX-License-Identifier: Apache-2.0
// The few pieces of HTML that the report is put together from. Arguments named `html` are markup already;
// all other text is escaped here.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/job/grade.h"

namespace noctule::html {

struct Column {
    std::string title;
    bool is_number = true;
    std::string group = {};  ///< over neighbouring columns with the same one; empty: none
};

struct Row {
    std::vector<std::string> cells_html;  ///< the first is the row's header
    std::string css_class;
};

struct Table {
    std::string caption;  ///< for listeners; not drawn
    std::vector<Column> columns;
    std::vector<Row> rows;
};

std::string table(const Table& table);

/// A titled part of the page with a sentence that says how to read it.
std::string section(const std::string& id, const std::string& title, const std::string& lead,
                    const std::string& body_html);

/// A whole page that needs nothing else. `kind` says what it is ("Take report"), `about` whose and when.
std::string page(const std::string& title, const std::string& kind, const std::string& about,
                 const std::string& body_html, const std::string& footer);

/// The page's first words: a badge, the headline (id "verdict") and what it rests on.
std::string verdict(Grade grade, const std::string& headline, const std::string& explanation);
/// What is wrong, one sentence each; nothing when nothing is.
std::string problems(const std::vector<std::string>& sentences);

/// A quiet line for a part that has nothing to show.
std::string nothing(const std::string& sentence);

std::string heading(const std::string& text);
/// Shown when its title is chosen.
std::string folded(const std::string& title, const std::string& body_html);
std::string note(const std::string& sentence);
std::string list(const std::vector<std::string>& sentences);

/// Name and value, one below the other.
std::string definitions(const std::vector<std::pair<std::string, std::string>>& entries);

/// A bar of shares (0..1) side by side, each with its css class; the words are its accessible name.
std::string bar(const std::vector<std::pair<double, std::string>>& parts, const std::string& words);

/// What the classes of a bar mean: css class and word.
std::string key(const std::vector<std::pair<std::string, std::string>>& entries);

/// The confidence colours between the words for their ends.
std::string scale(const std::string& low, const std::string& high);

/// check, warn or error of the product's icon set.
std::string icon(const std::string& name);

}  // namespace noctule::html
