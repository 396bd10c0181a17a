// SPDX-License-Identifier: Apache-2.0
// The magnetometers that are turned: which share of the directions each has seen, and how uneven its field
// is.
#pragma once

#include <QWidget>

namespace noctule::ui {

class WizardRun;

class FieldTable : public QWidget {
    Q_OBJECT
public:
    explicit FieldTable(QWidget* parent = nullptr);

    void setRun(const WizardRun* run);
    void refresh();
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<int> boards() const;
    int rowHeight() const;
    void paintHead(QPainter& painter) const;
    void paintRow(QPainter& painter, int row, int board) const;

    const WizardRun* run_ = nullptr;
    size_t known_ = 0;
};

}  // namespace noctule::ui
