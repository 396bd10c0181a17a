// SPDX-License-Identifier: Apache-2.0
// All keys, made from the actions that they belong to, with a field to find one; the keys of commands can be
// changed here.
#pragma once

#include <QAction>
#include <QDialog>
#include <QKeySequenceEdit>
#include <QList>
#include <map>

class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace noctule::ui {

class Button;
class Label;
class SearchField;

struct ShortcutGroup {
    QString title;
    QList<QAction*> actions;
};

class ShortcutsDialog : public QDialog {
    Q_OBJECT
public:
    explicit ShortcutsDialog(const QList<ShortcutGroup>& groups, QWidget* parent = nullptr);

    int shownRows() const;
    void find(const QString& text);
    /// As by a click on its row.
    void choose(const QAction& action);
    QKeySequenceEdit& keyField() { return *key_; }
    Button& restoreButton() { return *restore_; }
    /// Why a key was not taken; else empty.
    QString problem() const;

private:
    void addTable(QVBoxLayout& column);
    void addKeyField(QVBoxLayout& column);
    QTreeWidgetItem* addGroup(const QString& title);
    void addActions(const ShortcutGroup& group);
    void addFixed(QTreeWidgetItem& group, const QString& text, std::initializer_list<const char*> keys);
    void addView3d();
    void addTimeline();
    void addRobot();
    QAction* chosen() const;
    void showChosen();
    void showKeys();
    void takeKey();
    QString whyNot(const QKeySequence& key, const QString& name) const;

    SearchField* search_;
    QTreeWidget* table_;
    Label *nothing_, *command_, *problem_;
    QKeySequenceEdit* key_;
    Button* restore_;
    std::map<QTreeWidgetItem*, QAction*> actions_;  ///< whose keys can be changed
    std::map<QKeySequence, QString> fixed_;         ///< keys that widgets take themselves, and for what
};

}  // namespace noctule::ui
