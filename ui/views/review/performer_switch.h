// SPDX-License-Identifier: Apache-2.0
// Whose body, plots and report Review shows, in a take of several people: a button for each. Hidden for one.
#pragma once

#include "ui/models/review_context.h"
#include "ui/views/performer_buttons.h"

namespace noctule::ui {

class PerformerSwitch : public PerformerButtons {
    Q_OBJECT
public:
    explicit PerformerSwitch(ReviewContext& review, QWidget* parent = nullptr);

    /// The next one, after the last the first.
    static void showNext(TakeDocument& take);

private:
    void refresh();

    ReviewContext& review_;
};

/// "Ada"; without a name "Performer 2".
QString performerName(const TakeDocument& take, int index);

}  // namespace noctule::ui
