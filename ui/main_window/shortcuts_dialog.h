// SPDX-License-Identifier: Apache-2.0
// All keys, made from the actions that they belong to, with a field to find one.
#pragma once

#include <QAction>
#include <QDialog>
#include <QList>

class QTreeWidget;

namespace noctule::ui {

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

private:
    void addGroup(const QString& title, const QList<QPair<QString, QString>>& rows);
    void addView3d();
    void addTimeline();

    SearchField* search_;
    QTreeWidget* table_;
    Label* nothing_;
};

}  // namespace noctule::ui
