// SPDX-License-Identifier: Apache-2.0
// One result in the list: a check box with its letter and name, below it the error and what it is used for.
#pragma once

#include <QAbstractButton>

namespace noctule::ui {

class RunRow : public QAbstractButton {
    Q_OBJECT
public:
    explicit RunRow(const QString& name, QWidget* parent = nullptr);

    /// "A" for the result that is shown, "B" for the one that is compared, else empty.
    void setState(const QString& letter, const QString& detail);
    const QString& letter() const { return letter_; }
    const QString& detail() const { return detail_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void nextCheckState() override {}  ///< the list decides

private:
    QString letter_, detail_;
};

}  // namespace noctule::ui
