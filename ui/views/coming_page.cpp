// SPDX-License-Identifier: Apache-2.0
#include "ui/views/coming_page.h"

#include <QVBoxLayout>

#include "ui/views/scaled_layout.h"
#include "ui/views/session_commands.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {
namespace {

void addSection(QVBoxLayout& column, const QString& title, const QStringList& lines) {
    auto* section = new QWidget;
    auto* content = makeColumn(section);
    content->addWidget(new SectionHeader(title));
    auto* texts = new QWidget;
    auto* text_column = makeColumn(texts, {}, 8);
    for (const QString& line : lines)
        text_column->addWidget((new Label(line, TextRole::kBody, Ink::kLabel))->wrapped());
    content->addWidget(texts);
    column.addWidget(section);
}

}  // namespace

ComingPage::ComingPage(Studio& studio, const Words& words, QWidget* parent)
    : Page(parent), studio_(studio), title_(words.title) {
    auto* content = new QWidget;
    auto* column = makeColumn(content, {12, 16, 12, 12}, 12);
    auto* verdict = new VerdictHeader;
    verdict->setVerdict(Tone::kNeutral, words.verdict, words.why);
    column->addWidget(verdict);
    addSection(*column, tr("What will be here"), words.what_comes);
    addSection(*column, tr("Until then"), {words.until_then});
    auto* ways = new QWidget;
    way_column_ = makeColumn(ways, {}, 8);
    column->addWidget(ways);
    column->addStretch();
    dock_ = new ScrollArea(content, this);
    dock_->hide();
    setDockTitles({}, words.title);
}

void ComingPage::setDrawing(QWidget* drawing, const QMargins& margins) {
    makeColumn(this, margins)->addWidget(drawing);
}

Button* ComingPage::addWay(const QString& text, const QString& icon, std::function<void()> act) {
    Button* button = makeButton(ways_.isEmpty() ? ButtonKind::kPrimary : ButtonKind::kOutlined, text, icon);
    connect(button, &QPushButton::clicked, this, std::move(act));
    way_column_->addWidget(button);
    ways_.append(button);
    return button;
}

void ComingPage::addVirtualSuitWay() {
    addWay(tr("Try the virtual suit"), "play", [this] { studio_.tryVirtualSuit(); });
}

void ComingPage::addImportWay() {
    addWay(tr("Import takes"), "open", [this] { SessionCommands::askForImport(window(), studio_); });
}

}  // namespace noctule::ui
