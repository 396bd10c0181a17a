// SPDX-License-Identifier: Apache-2.0
// What is new in this version, and what it does not have yet.
#pragma once

#include <QDialog>

namespace noctule::ui {

class NewsDialog : public QDialog {
    Q_OBJECT
public:
    explicit NewsDialog(QWidget* parent = nullptr);
};

}  // namespace noctule::ui
