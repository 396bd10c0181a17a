// SPDX-License-Identifier: Apache-2.0
// A spin box of a length in metres. It writes in the chosen units and reads all of them (lengths.h). Text
// that nobody changed leaves the value as it was, to the last bit. A typed one counts with Return or once the
// box is left; interpretText() asks for it before.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace noctule::ui {

class LengthBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    enum class Metric { kMetres, kCentimetres };  ///< unit of metric numbers: "1.75 m", "175.0 cm"

    LengthBox(double least_m, double most_m, Metric metric, QWidget* parent = nullptr);

    QString textFromValue(double value_m) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& cursor) const override;
    void fixup(QString&) const override {}
    void stepBy(int steps) override;

private:
    std::optional<double> read(const QString& text) const;

    Metric metric_;
};

}  // namespace noctule::ui
