// SPDX-License-Identifier: Apache-2.0
// The markers of the open take in the left dock of Review, in order of time; a click goes there.
#pragma once

#include <QListWidget>

#include "ui/models/review_context.h"

namespace noctule::ui {

class MarkersPanel : public QListWidget {
    Q_OBJECT
public:
    explicit MarkersPanel(ReviewContext& review, QWidget* parent = nullptr);

private:
    void refresh();
    void goTo(const QListWidgetItem& item);

    ReviewContext& review_;
};

}  // namespace noctule::ui
