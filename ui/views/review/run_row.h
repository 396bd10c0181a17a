// SPDX-License-Identifier: Apache-2.0
// One result in the list: a check box with its number and name, below it the error and what it is used for.
#pragma once

#include <QAbstractButton>

namespace noctule::ui {

class RunRow : public QAbstractButton {
    Q_OBJECT
public:
    explicit RunRow(const QString& name, QWidget* parent = nullptr);

    /// Its number ("2"), which it keeps for good, and what it is used for.
    void setState(const QString& number, const QString& detail);
    const QString& number() const { return number_; }
    const QString& detail() const { return detail_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void nextCheckState() override {}  ///< the list decides

private:
    QString number_, detail_;
};

}  // namespace noctule::ui
