// SPDX-License-Identifier: Apache-2.0
// The markers of the open take in the left dock of Review, in order of time; a click goes there.
#pragma once

#include <QListWidget>

#include "ui/models/studio.h"

namespace noctule::ui {

class MarkersPanel : public QListWidget {
    Q_OBJECT
public:
    explicit MarkersPanel(Studio& studio, QWidget* parent = nullptr);

private:
    void refresh();
    void goTo(const QListWidgetItem& item);

    Studio& studio_;
};

}  // namespace noctule::ui
