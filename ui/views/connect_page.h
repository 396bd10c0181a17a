// SPDX-License-Identifier: Apache-2.0
// Step Connect: the suit on the body. The studio does not use devices yet; the drawing shows where boards
// and sources of the performer's suit sit, and choosing one says it in words.
#pragma once

#include "ui/views/coming_page.h"

namespace noctule::ui {

class BodyMap;
class Label;

class ConnectPage : public ComingPage {
    Q_OBJECT
public:
    explicit ConnectPage(Studio& studio, QWidget* parent = nullptr);

    void enter() override;

private:
    void showSuit();

    QWidget* frame_;
    BodyMap* map_ = nullptr;
    Label* chosen_;
};

}  // namespace noctule::ui
