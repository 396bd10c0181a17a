// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/shortcuts_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/search_field.h"

namespace noctule::ui {
namespace {

QString keysOf(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& key : action.shortcuts())
        keys.append(keysText(key));
    return keys.join(ShortcutsDialog::tr(" or ", "between two keys for the same"));
}

QString keysIn(std::initializer_list<const char*> keys) {
    QStringList texts;
    for (const char* key : keys)
        texts.append(keysText(QKeySequence(key)));
    return texts.join(QStringLiteral(", "));
}

QString textOf(const QAction& action) {
    return action.text().remove('&').remove("…");
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(const QList<ShortcutGroup>& groups, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Shortcuts"));
    auto* column = makeColumn(this, {24, 20, 24, 20}, 12);
    auto* head = addRow(column, 12);
    head->addWidget(new Label(tr("Shortcuts"), TextRole::kPage, Ink::kValue, true), 1);
    search_ = new SearchField(tr("Find a key or a command"));
    keepSize(*search_, 240, 0);
    head->addWidget(search_);
    column->addWidget(new Label(tr("Plain keys act only while no text field has the keyboard."),
                                TextRole::kSecondary, Ink::kHint));
    table_ = new QTreeWidget;
    table_->setColumnCount(2);
    table_->setHeaderHidden(true);
    table_->setRootIsDecorated(false);
    table_->setAccessibleName(tr("Shortcuts"));
    table_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->header()->setStretchLastSection(false);
    column->addWidget(table_, 1);
    nothing_ = new Label(tr("No key and no command is called that."), TextRole::kBody, Ink::kLabel);
    nothing_->hide();
    column->addWidget(nothing_);
    auto* row = addRow(column);
    row->addStretch();
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(search_, &SearchField::textChanged, this, &ShortcutsDialog::find);

    for (const ShortcutGroup& group : groups) {
        QList<QPair<QString, QString>> rows;
        for (const QAction* action : group.actions)
            if (!action->shortcuts().isEmpty())
                rows.append({textOf(*action), keysOf(*action)});
        addGroup(group.title, rows);
    }
    addTimeline();
    addView3d();
    placeDialog(*this, {Theme::get().px(620), Theme::get().px(640)});
    search_->setFocus();
}

void ShortcutsDialog::addGroup(const QString& title, const QList<QPair<QString, QString>>& rows) {
    if (rows.isEmpty())
        return;
    auto* group = new QTreeWidgetItem(table_, {title});
    group->setFont(0, Theme::get().font(TextRole::kBody, true));
    group->setFlags(Qt::ItemIsEnabled);
    group->setData(1, Qt::AccessibleTextRole, title);
    for (const auto& [text, keys] : rows)
        new QTreeWidgetItem(group, {text, keys});
    group->setExpanded(true);
}

/// Taken by the timeline itself while it has the keyboard.
void ShortcutsDialog::addTimeline() {
    addGroup(tr("On the timeline, contacts of the feet"),
             {{tr("The left or right foot's contact at the cursor"), keysIn({"Up", "Down"})},
              {tr("The contact before or after it"), keysIn({"Ctrl+Left", "Ctrl+Right"})},
              {tr("It begins or ends at the cursor"), keysIn({"I", "O"})},
              {tr("Delete it, let go of it"), keysIn({"Del", "Esc"})}});
}

/// The picture takes its keys and the mouse by itself, so there are no actions to ask.
void ShortcutsDialog::addView3d() {
    addGroup(tr("On the 3D picture"),
             {{tr("Front, side, top"), keysIn({"1", "3", "7"})},
              {tr("Bring the body into the picture"), keysIn({"F"})},
              {tr("Follow the body"), keysIn({"Shift+F"})},
              {tr("Rays, ghost"), keysIn({"R", "G"})},
              {tr("Orbit"), tr("Middle button, or Alt and left button (preferences)")},
              {tr("Move sideways"), tr("Shift and middle button, or Alt and middle button")},
              {tr("Nearer, further"), tr("Wheel")}});
}

void ShortcutsDialog::find(const QString& text) {
    for (int i = 0; i < table_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = table_->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < group->childCount(); ++j) {
            QTreeWidgetItem* row = group->child(j);
            const bool fits = row->text(0).contains(text.trimmed(), Qt::CaseInsensitive) ||
                              row->text(1).contains(text.trimmed(), Qt::CaseInsensitive);
            row->setHidden(!fits);
            any |= fits;
        }
        group->setHidden(!any);
    }
    nothing_->setVisible(shownRows() == 0);
}

int ShortcutsDialog::shownRows() const {
    int rows = 0;
    for (int i = 0; i < table_->topLevelItemCount(); ++i)
        for (int j = 0; j < table_->topLevelItem(i)->childCount(); ++j)
            rows += !table_->topLevelItem(i)->child(j)->isHidden();
    return rows;
}

}  // namespace noctule::ui
