// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/shortcuts_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/keys.h"
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

QString textOf(const QAction& action) {
    return action.text().remove('&').remove("…");
}

/// Takes one key at once; Qt waits a second for another one.
class KeyField : public QKeySequenceEdit {
protected:
    void keyPressEvent(QKeyEvent* event) override {
        QKeySequenceEdit::keyPressEvent(event);
        if (!keySequence().isEmpty())
            emit editingFinished();
    }
};

bool isForTexts(const QKeySequence& key) {
    const auto standards = {QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste,
                            QKeySequence::SelectAll};
    return std::any_of(standards.begin(), standards.end(), [&](QKeySequence::StandardKey standard) {
        return QKeySequence::keyBindings(standard).contains(key);
    });
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
    column->addWidget((new Label(tr("Plain keys act only while no text field has the keyboard."),
                                 TextRole::kSecondary, Ink::kHint))
                          ->wrapped());
    addTable(*column);
    addKeyField(*column);
    auto* row = addRow(column);
    restore_ = makeButton(ButtonKind::kText, tr("Restore defaults"));
    restore_->setFlush(true);
    row->addWidget(restore_);
    row->addStretch();
    Button* close = makeButton(ButtonKind::kOutlined, tr("Close"), {}, QKeySequence("Esc"));
    row->addWidget(close);
    for (const ShortcutGroup& group : groups)
        addActions(group);
    addTimeline();
    addView3d();
    addRobot();
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(search_, &SearchField::textChanged, this, &ShortcutsDialog::find);
    connect(restore_, &QPushButton::clicked, &Keys::get(), &Keys::restoreUsual);
    connect(&Keys::get(), &Keys::changed, this, &ShortcutsDialog::showKeys);
    connect(table_, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showChosen);
    connect(key_, &QKeySequenceEdit::editingFinished, this, &ShortcutsDialog::takeKey);
    showChosen();
    placeDialog(*this, {Theme::get().px(720), Theme::get().px(640)});
    search_->setFocus();
}

void ShortcutsDialog::addTable(QVBoxLayout& column) {
    table_ = new QTreeWidget;
    table_->setColumnCount(2);
    table_->setHeaderHidden(true);
    table_->setRootIsDecorated(false);
    table_->setAccessibleName(tr("Shortcuts"));
    table_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->header()->setStretchLastSection(false);
    column.addWidget(table_, 1);
    nothing_ = new Label(tr("No key and no command is called that."), TextRole::kBody, Ink::kLabel);
    nothing_->hide();
    column.addWidget(nothing_);
}

void ShortcutsDialog::addKeyField(QVBoxLayout& column) {
    auto* row = addRow(&column, 12);
    command_ = (new Label({}, TextRole::kBody, Ink::kLabel))->wrapped();
    key_ = new KeyField;
    keepSize(*key_, 200, 0);
    row->addWidget(command_, 1);
    row->addWidget(key_);
    problem_ = (new Label({}, TextRole::kSecondary, Ink::kWarn))->wrapped();
    problem_->hide();
    column.addWidget(problem_);
}

QTreeWidgetItem* ShortcutsDialog::addGroup(const QString& title) {
    auto* group = new QTreeWidgetItem(table_, {title});
    group->setFont(0, Theme::get().font(TextRole::kBody, true));
    group->setFlags(Qt::ItemIsEnabled);
    group->setData(1, Qt::AccessibleTextRole, title);
    group->setExpanded(true);
    return group;
}

void ShortcutsDialog::addActions(const ShortcutGroup& group) {
    QTreeWidgetItem* title = nullptr;
    for (QAction* action : group.actions) {
        const bool is_fixed = Keys::get().nameOf(*action).isEmpty();
        if (is_fixed && action->shortcuts().isEmpty())
            continue;
        if (!title)
            title = addGroup(group.title);
        auto* row = new QTreeWidgetItem(title, {textOf(*action), keysOf(*action)});
        if (!is_fixed)
            actions_[row] = action;
    }
}

void ShortcutsDialog::addFixed(QTreeWidgetItem& group, const QString& text,
                               std::initializer_list<const char*> keys) {
    QStringList texts;
    for (const char* key : keys) {
        fixed_[QKeySequence(key)] = text;
        texts.append(keysText(QKeySequence(key)));
    }
    new QTreeWidgetItem(&group, {text, texts.join(QStringLiteral(", "))});
}

/// Taken by the timeline itself while it has the keyboard.
void ShortcutsDialog::addTimeline() {
    QTreeWidgetItem& group = *addGroup(tr("On the timeline, contacts of the feet"));
    addFixed(group, tr("The left or right foot's contact at the cursor"), {"Up", "Down"});
    addFixed(group, tr("The contact before or after it"), {"Ctrl+Left", "Ctrl+Right"});
    addFixed(group, tr("It begins or ends at the cursor"), {"I", "O"});
    addFixed(group, tr("Delete it, let go of it"), {"Del", "Esc"});
}

/// The picture takes its keys and the mouse by itself, so there are no actions to ask.
void ShortcutsDialog::addView3d() {
    QTreeWidgetItem& group = *addGroup(tr("On the 3D picture"));
    addFixed(group, tr("Front, side, top"), {"1", "3", "7"});
    addFixed(group, tr("Bring the body into the picture"), {"F"});
    addFixed(group, tr("Follow the body"), {"Shift+F"});
    addFixed(group, tr("Rays, ghost"), {"R", "G"});
    const auto mouse = [&](const QString& text, const QString& how) {
        new QTreeWidgetItem(&group, {text, how});
    };
    mouse(tr("Orbit"), tr("Middle button, or Alt and left button (preferences)"));
    mouse(tr("Move sideways"), tr("Shift and middle button, or Alt and middle button"));
    mouse(tr("Nearer, further"), tr("Wheel"));
}

/// The same on every computer: whoever stands beside a robot must know them.
void ShortcutsDialog::addRobot() {
    addFixed(*addGroup(tr("On Robot, for safety")), tr("The robot moves only while this key is held"),
             {"F8"});
}

QString ShortcutsDialog::problem() const {
    return problem_->text();
}

void ShortcutsDialog::choose(const QAction& action) {
    for (const auto& [row, of_row] : actions_)
        if (of_row == &action)
            table_->setCurrentItem(row);
}

QAction* ShortcutsDialog::chosen() const {
    const auto found = actions_.find(table_->currentItem());
    return found == actions_.end() ? nullptr : found->second;
}

void ShortcutsDialog::showChosen() {
    const QAction* action = chosen();
    problem_->clear();
    problem_->hide();
    key_->setEnabled(action != nullptr);
    key_->setKeySequence(action ? action->shortcut() : QKeySequence());
    const bool is_fixed = !action && table_->currentItem() && table_->currentItem()->parent();
    command_->setText(action     ? tr("Click here and press the key for “%1”:").arg(textOf(*action))
                      : is_fixed ? tr("These keys are fixed.")
                                 : tr("Choose a command above to give it another key."));
    key_->setAccessibleName(command_->text());
}

void ShortcutsDialog::showKeys() {
    for (const auto& [row, action] : actions_)
        row->setText(1, keysOf(*action));
    showChosen();
}

void ShortcutsDialog::takeKey() {
    const QKeySequence pressed = key_->keySequence();
    const QAction* action = chosen();
    if (!action || pressed.isEmpty())
        return showChosen();
    const QKeySequence key(pressed[static_cast<uint>(pressed.count() - 1)]);
    const QString name = Keys::get().nameOf(*action), why = whyNot(key, name);
    if (why.isEmpty())
        return Keys::get().choose(name, key);
    showChosen();
    problem_->setText(why);
    problem_->show();
}

/// Empty: the command may have it.
QString ShortcutsDialog::whyNot(const QKeySequence& key, const QString& name) const {
    if (const QAction* holder = Keys::get().holderOf(key, name))
        return tr("%1 already means “%2”. Give that command another key first.", "key, command")
            .arg(keysText(key), textOf(*holder));
    if (Keys::get().isUsual(key, name))
        return {};
    if (const auto found = fixed_.find(key); found != fixed_.end())
        return tr("%1 already means “%2”, which is fixed.", "key, what it does")
            .arg(keysText(key), found->second);
    if (isForTexts(key))
        return tr("%1 is for texts: to copy, cut, paste or select.", "key").arg(keysText(key));
    const int pressed = static_cast<int>(key[0]),
              plain = pressed & ~static_cast<int>(Qt::KeyboardModifierMask);
    const bool has_ctrl = pressed & Qt::ControlModifier, has_alt = pressed & Qt::AltModifier;
    const bool is_function = plain >= Qt::Key_F1 && plain <= Qt::Key_F35;
    if (has_alt && !has_ctrl)
        return tr("Keys with Alt open menus. Take one with Ctrl.");
    if (Keys::actsEverywhere(name) && !has_ctrl && !is_function)
        return tr("This command acts on every page: it needs a key with Ctrl, or one of F1 to F12.");
    return {};
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
