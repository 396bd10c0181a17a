// SPDX-License-Identifier: Apache-2.0
// Whose sources the pairs of Review are of, in a take of several people or with anchors: the shown one's own,
// another one's, the room's. A button for each; hidden where there is no choice.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/models/review_context.h"

class QBoxLayout;
class QToolButton;

namespace noctule::ui {

class HeardSwitch : public QWidget {
    Q_OBJECT
public:
    explicit HeardSwitch(ReviewContext& review, QWidget* parent = nullptr);

    const std::vector<QToolButton*>& buttons() const { return buttons_; }

private:
    void refresh();
    void decorate();

    ReviewContext& review_;
    QBoxLayout* row_;
    std::vector<QToolButton*> buttons_;
};

/// "B to A", "Room to A", or "Own".
QString heardWords(const TakeDocument& take, int party);
QString heardWords(const TakeDocument& take);

}  // namespace noctule::ui
