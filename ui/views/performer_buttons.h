// SPDX-License-Identifier: Apache-2.0
// A row of buttons, one per performer, with letter and name; one of them is down. Hidden for fewer than two.
#pragma once

#include <QWidget>
#include <vector>

class QBoxLayout;
class QToolButton;

namespace noctule::ui {

class PerformerButtons : public QWidget {
    Q_OBJECT
public:
    /// `title` stands before them.
    explicit PerformerButtons(const QString& title, QWidget* parent = nullptr);

    const std::vector<QToolButton*>& buttons() const { return buttons_; }
    void setPerformers(const QStringList& names, int chosen);

signals:
    void chosen(int index);

private:
    void decorate();

    QBoxLayout* row_;
    std::vector<QToolButton*> buttons_;
    int chosen_ = 0;
};

}  // namespace noctule::ui
