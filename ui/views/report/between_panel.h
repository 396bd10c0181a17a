// SPDX-License-Identifier: Apache-2.0
// Where the people of a take are to each other, against their references: hands, pelvises, facing.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"

class QVBoxLayout;

namespace noctule::ui {

class BetweenPanel : public QWidget {
    Q_OBJECT
public:
    explicit BetweenPanel(ReviewContext& review, QWidget* parent = nullptr);

    /// Hidden in a take of one.
    void refresh();

private:
    QWidget* tableOf(const std::vector<BetweenEvaluation>& found, size_t first) const;

    ReviewContext& review_;
    QVBoxLayout* column_;
    QWidget* content_ = nullptr;
};

}  // namespace noctule::ui
