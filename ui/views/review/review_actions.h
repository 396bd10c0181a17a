// SPDX-License-Identifier: Apache-2.0
// The commands of Review, for its menu and for the keyboard.
#pragma once

#include "ui/views/page_actions.h"

namespace noctule::ui {

class ReviewPage;
class Studio;

class ReviewActions : public PageActions {
    Q_OBJECT
public:
    ReviewActions(Studio& studio, ReviewPage& page);

    void refresh();

private:
    void addPlayback();
    void addRange();
    void addTake();

    Studio& studio_;
    ReviewPage& page_;
    QAction *play_ = nullptr, *loop_ = nullptr, *next_performer_ = nullptr, *side_by_side_ = nullptr;
    QAction *name_marker_ = nullptr, *delete_ = nullptr, *found_contacts_ = nullptr;
};

}  // namespace noctule::ui
