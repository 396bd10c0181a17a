// SPDX-License-Identifier: Apache-2.0
// In and out of the open take: what the timeline says goes into the session as one undo step, and what the
// session says (on opening, on undo) goes to the timeline.
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/models/review_context.h"

namespace noctule::ui {

class TakeRange : public QObject {
    Q_OBJECT
public:
    explicit TakeRange(ReviewContext& review, QObject* parent = nullptr);

private:
    void read();
    void choose();
    void writeDragged();
    void write(const QString& merge_key = {});

    ReviewContext& review_;
    QTimer pause_;  ///< a drag is one step
    bool reading_ = false;
};

}  // namespace noctule::ui
