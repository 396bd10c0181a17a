// SPDX-License-Identifier: Apache-2.0
// What stands where a live suit will be: one sentence and the ways to one.
#pragma once

#include <QWidget>

#include "ui/models/capture_context.h"

namespace noctule::ui {

class Button;
class Label;

class NoSuit : public QWidget {
    Q_OBJECT
public:
    explicit NoSuit(CaptureContext& capture, QWidget* parent = nullptr);

    Button* connectButton() { return connect_; }
    Button* virtualSuitButton() { return virtual_; }

private:
    void refresh();

    CaptureContext& capture_;
    Label* sentence_;
    Button* connect_;
    Button* virtual_;
};

}  // namespace noctule::ui
