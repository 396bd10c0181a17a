// SPDX-License-Identifier: Apache-2.0
// Height and body lengths of the performer. Lengths that are left empty follow the height; what can hardly be
// right is said in words.
#pragma once

#include <QWidget>
#include <vector>

#include "core/session/body_measures.h"

namespace noctule::ui {

class LengthBox;
class LengthField;
class PerformerEditor;
class ProblemCard;

class PerformerMeasuresPanel : public QWidget {
    Q_OBJECT
public:
    explicit PerformerMeasuresPanel(PerformerEditor& editor, QWidget* parent = nullptr);

    LengthBox& height() { return *height_; }
    LengthField& field(double BodyMeasures::*length);
    /// What looks wrong, whole sentences; empty: nothing.
    static QString doubtsInWords(const BodyMeasures& measures);

private:
    void refresh();

    PerformerEditor& editor_;
    LengthBox* height_;
    std::vector<std::pair<double BodyMeasures::*, LengthField*>> fields_;
    ProblemCard* doubts_;
};

}  // namespace noctule::ui
