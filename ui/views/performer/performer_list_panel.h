// SPDX-License-Identifier: Apache-2.0
// The performers of the session: choose, add, rename, duplicate, remove, and who wears the suit.
#pragma once

#include <QListWidget>
#include <QWidget>

namespace noctule::ui {

class Button;
class PerformerEditor;
class ToolButton;

class PerformerListPanel : public QWidget {
    Q_OBJECT
public:
    explicit PerformerListPanel(PerformerEditor& editor, QWidget* parent = nullptr);

    QListWidget& list() { return *list_; }

private:
    static QWidget* makeWearsNow();
    QWidget* makeTools();
    void refresh();

    PerformerEditor& editor_;
    QListWidget* list_;
    ToolButton* duplicate_;
    ToolButton* rename_;
    ToolButton* remove_;
    Button* wear_;
    QWidget* wears_;
};

}  // namespace noctule::ui
