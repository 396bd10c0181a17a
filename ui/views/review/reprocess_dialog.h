// SPDX-License-Identifier: Apache-2.0
// How a take is to be processed: which sensors, which filter, where the root comes from and which
// calibration. At first the most accurate settings; sensors, root and filter as the last result was made.
// Nothing is replaced, every processing adds a result.
#pragma once

#include "core/processing/process_take.h"
#include "ui/models/studio.h"
#include "ui/views/dialog_frame.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace noctule::ui {

class ChoiceRow;
class Label;

class ReprocessDialog : public DialogFrame {
    Q_OBJECT
public:
    /// `overview`: of the take.
    ReprocessDialog(Studio& studio, const TakeOverview& overview, QWidget* parent = nullptr);

    ProcessRequest request() const;

    // For those who fill it in, the operator and tests.
    ChoiceRow *accelerometers, *gyroscopes, *distances;
    ChoiceRow *root_free, *root_given;
    QComboBox* ground;  ///< items in the order of Ground
    ChoiceRow *ours, *paper, *independent;
    ChoiceRow *not_smoothed, *smoothed_half_second, *smoothed_whole, *most_probable;
    ChoiceRow *matched, *inflection;
    ChoiceRow *calibration_in_force, *calibration_in_use, *calibration_from_file;
    QLineEdit* name;

    void setCalibrationFile(const QString& path);
    /// Which suits are processed and how, by their performers: "Ada, Ben: all suits are processed together".
    QString people() const;

private:
    void addSensors(QBoxLayout& into);
    void addRoot(QBoxLayout& into);
    void addFilter(QBoxLayout& into);
    void addSmoothing(QBoxLayout& into);
    void addDetector(QBoxLayout& into);
    void addCalibration(QBoxLayout& into);
    void addName(QBoxLayout& into);
    void chooseCalibration();
    void startFrom(const RunSettings& settings);
    void refresh();
    void showLack();
    CalibrationLack lackOfChosen() const;
    /// Several people whose suits may hear each other; smoothers go over one body only.
    bool areTogether() const;

    Studio& studio_;
    const TakeOverview overview_;
    QWidget* process_row_;
    Label* people_;
    QDoubleSpinBox* process_sigma_;
    std::optional<Calibration> calibration_;
    QString file_problem_;
};

}  // namespace noctule::ui
