// SPDX-License-Identifier: Apache-2.0
// Whose body, plots and report Review shows, in a take of several people: a button for each. Hidden for one.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/models/studio.h"

class QBoxLayout;
class QToolButton;

namespace noctule::ui {

class PerformerSwitch : public QWidget {
    Q_OBJECT
public:
    explicit PerformerSwitch(Studio& studio, QWidget* parent = nullptr);

    const std::vector<QToolButton*>& buttons() const { return buttons_; }
    /// The next one, after the last the first.
    static void showNext(TakeDocument& take);

private:
    void refresh();
    void decorate();

    Studio& studio_;
    QBoxLayout* row_;
    std::vector<QToolButton*> buttons_;
};

/// "Ada"; without a name "Performer 2".
QString performerName(const TakeDocument& take, int index);

}  // namespace noctule::ui
