// SPDX-License-Identifier: Apache-2.0
// Findings as cards, the worst few until all are asked for; without findings a line that says so.
#pragma once

#include <QWidget>
#include <vector>

#include "core/calibration/findings.h"

class QVBoxLayout;

namespace noctule::ui {

class FindingList : public QWidget {
    Q_OBJECT
public:
    explicit FindingList(QWidget* parent = nullptr);

    /// The worst first.
    void setFindings(const std::vector<Finding>& findings);

private:
    void refresh();

    QVBoxLayout* column_;
    std::vector<Finding> findings_;
    bool shows_all_ = false;
};

}  // namespace noctule::ui
