// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/performer_list_panel.h"

#include <QSignalBlocker>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/views/performer/performer_editor.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr int kRow = 28, kFewestPeople = 2, kMostPeople = 6;

}  // namespace

PerformerListPanel::PerformerListPanel(PerformerEditor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      list_(new QListWidget),
      wear_(makeButton(ButtonKind::kText, {})),
      wears_(makeWearsNow()) {
    auto* column = makeColumn(this);
    column->addWidget(list_);
    column->addWidget(makeTools());
    auto* below = addRow(column, 0, {4, 0, 12, 0});
    below->addWidget(wear_);
    below->addWidget(wears_);
    below->addStretch();
    list_->setFrameShape(QFrame::NoFrame);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setUniformItemSizes(true);
    list_->setAccessibleName(tr("Performers"));
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            editor_.choose(row);
    });
    connect(list_, &QListWidget::itemChanged, this,
            [this](const QListWidgetItem* item) { editor_.rename(item->text()); });
    connect(wear_, &QPushButton::clicked, &editor_, &PerformerEditor::wearSuit);
    connect(&editor, &PerformerEditor::performerChanged, this, &PerformerListPanel::refresh);
    connect(&Theme::get(), &Theme::changed, this, &PerformerListPanel::refresh);
    refresh();
}

QWidget* PerformerListPanel::makeWearsNow() {
    auto* wears = new QWidget;
    auto* row = makeRow(wears, {8, 6, 0, 6}, 8);
    row->addWidget(new IconLabel("check", [] { return Theme::get().tokens().ok; }));
    row->addWidget(new Label(tr("Wears the suit"), TextRole::kBody, Ink::kLabel));
    return wears;
}

QWidget* PerformerListPanel::makeTools() {
    auto* tools = new QWidget;
    auto* row = makeRow(tools, {8, 4, 8, 0}, 4);
    auto* add = new ToolButton("new", tr("Add a performer"));
    duplicate_ = new ToolButton("copy", tr("Duplicate this performer"));
    rename_ = new ToolButton("edit", tr("Rename this performer"), QKeySequence(Qt::Key_F2));
    remove_ = new ToolButton("trash", tr("Remove this performer"));
    for (ToolButton* button : {add, duplicate_, rename_, remove_})
        row->addWidget(button);
    row->addStretch();
    connect(add, &QToolButton::clicked, &editor_, &PerformerEditor::add);
    connect(duplicate_, &QToolButton::clicked, &editor_, &PerformerEditor::duplicate);
    connect(remove_, &QToolButton::clicked, &editor_, &PerformerEditor::remove);
    connect(rename_, &QToolButton::clicked, this, [this] {
        list_->setFocus();
        list_->editItem(list_->currentItem());
    });
    return tools;
}

void PerformerListPanel::refresh() {
    const QSignalBlocker quiet(list_);
    const bool open = editor_.hasPerformer();
    const std::vector<Performer> none;
    const auto& performers = open ? editor_.session().session().performers : none;
    const std::string current = open ? editor_.session().session().current_performer : std::string();
    while (list_->count() > static_cast<int>(performers.size()))
        delete list_->takeItem(list_->count() - 1);
    while (list_->count() < static_cast<int>(performers.size()))
        list_->addItem(new QListWidgetItem);
    for (int i = 0; i < list_->count(); ++i) {
        const Performer& performer = performers[static_cast<size_t>(i)];
        const bool wears = performer.name == current;
        QListWidgetItem& item = *list_->item(i);
        item.setText(QString::fromStdString(performer.name));
        item.setIcon(wears ? Theme::get().icon("check", Theme::get().tokens().ok)
                           : Theme::get().icon("body"));
        item.setToolTip(wears ? tr("Wears the suit") : QString());
        item.setData(Qt::AccessibleDescriptionRole, item.toolTip());
        item.setSizeHint({0, Theme::get().px(kRow)});
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
    }
    list_->setCurrentRow(editor_.index());
    list_->setFixedHeight(Theme::get().px(kRow) * std::clamp(list_->count(), kFewestPeople, kMostPeople));
    for (ToolButton* button : {duplicate_, rename_})
        button->setEnabled(open);
    remove_->setDisabledBecause(list_->count() > 1 ? QString() : tr("A session has at least one performer."));
    const bool wears_now = open && editor_.performer().name == current;
    wear_->setVisible(open && !wears_now);
    if (open)
        wear_->setText(tr("Put the suit on %1").arg(QString::fromStdString(editor_.performer().name)));
    wears_->setVisible(wears_now);
}

}  // namespace noctule::ui
