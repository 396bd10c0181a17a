// SPDX-License-Identifier: Apache-2.0
// The commands of Record, for the menu "Take" and for the keyboard; plain keys act wherever no text field has
// the focus.
#pragma once

#include "ui/views/page_actions.h"

namespace noctule::ui {

class PlaceReset;
class RecordPage;

class RecordActions : public PageActions {
    Q_OBJECT
public:
    RecordActions(RecordPage& page, PlaceReset& place);

private:
    void refresh();

    RecordPage& page_;
    PlaceReset& place_;
    QAction *record_ = nullptr, *end_countdown_ = nullptr, *marker_ = nullptr, *note_ = nullptr;
};

}  // namespace noctule::ui
