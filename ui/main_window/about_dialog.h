// SPDX-License-Identifier: Apache-2.0
// Name, version and licences, to read and to copy.
#pragma once

#include <QDialog>
#include <string>

namespace noctule::ui {

class AboutDialog : public QDialog {
    Q_OBJECT
public:
    explicit AboutDialog(const std::string& software, QWidget* parent = nullptr);
};

}  // namespace noctule::ui
