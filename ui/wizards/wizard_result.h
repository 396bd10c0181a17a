// SPDX-License-Identifier: Apache-2.0
// The last page of a wizard, in the middle: the verdict as a sentence, up to four numbers with what would be
// good, the picture of the errors before and after, and the tables.
#pragma once

#include <QWidget>
#include <string>

#include "core/report/calibration_document.h"
#include "core/sensor_calibration/field_sphere.h"
#include "ui/models/part_names.h"

class QVBoxLayout;

namespace noctule::ui {

class ScrollArea;
class VerdictHeader;

class WizardResult : public QWidget {
    Q_OBJECT
public:
    explicit WizardResult(QWidget* parent = nullptr);

    /// `names`: what ids of parts are called here.
    void setDocument(const CalibrationDocument& document, const PartNames& names);
    /// Of magnetometers, behind setDocument(): the directions that were seen, by the sensor that saw fewest.
    void addSphere(const FieldSphere& sphere);
    /// "Good", "Usable", "Not usable": as it stands at the top.
    const QString& verdict() const { return verdict_; }

private:
    void fill(const CalibrationDocument& document);
    static CalibrationDocument named(CalibrationDocument document, const PartNames& names);

    VerdictHeader* header_;
    ScrollArea* scroll_ = nullptr;
    QVBoxLayout* content_;
    QString verdict_;
};

}  // namespace noctule::ui
