// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/performer_measures_panel.h"

#include <QCoreApplication>
#include <QSignalBlocker>
#include <QStringList>
#include <algorithm>

#include "core/job/contract.h"
#include "ui/style/lengths.h"
#include "ui/views/length_box.h"
#include "ui/views/performer/length_field.h"
#include "ui/views/performer/performer_editor.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

constexpr double kShortestLength_m = 0.02, kLongestLength_m = 1.2;
constexpr int kHeightWidth = 104;

struct MeasureWords {
    double BodyMeasures::*length;
    const char* name;
    const char* how;
};

constexpr MeasureWords kMeasures[] = {
    {&BodyMeasures::upper_arm_m, QT_TRANSLATE_NOOP("Measures", "Upper arm"),
     QT_TRANSLATE_NOOP("Measures", "From the point of the shoulder to the elbow")},
    {&BodyMeasures::forearm_m, QT_TRANSLATE_NOOP("Measures", "Forearm"),
     QT_TRANSLATE_NOOP("Measures", "From the elbow to the wrist")},
    {&BodyMeasures::hand_m, QT_TRANSLATE_NOOP("Measures", "Hand"),
     QT_TRANSLATE_NOOP("Measures", "From the wrist to the tip of the middle finger")},
    {&BodyMeasures::shoulder_width_m, QT_TRANSLATE_NOOP("Measures", "Shoulder width"),
     QT_TRANSLATE_NOOP("Measures", "From shoulder joint to shoulder joint, about 4 cm less than outside")},
    {&BodyMeasures::trunk_m, QT_TRANSLATE_NOOP("Measures", "Trunk"),
     QT_TRANSLATE_NOOP("Measures", "From the hip joints to the base of the neck")},
    {&BodyMeasures::hip_width_m, QT_TRANSLATE_NOOP("Measures", "Hip width"),
     QT_TRANSLATE_NOOP("Measures", "From hip joint to hip joint, about half the width outside")},
    {&BodyMeasures::thigh_m, QT_TRANSLATE_NOOP("Measures", "Thigh"),
     QT_TRANSLATE_NOOP("Measures", "From the hip joint to the middle of the knee")},
    {&BodyMeasures::shin_m, QT_TRANSLATE_NOOP("Measures", "Shin"),
     QT_TRANSLATE_NOOP("Measures", "From the middle of the knee to the ankle")},
    {&BodyMeasures::foot_m, QT_TRANSLATE_NOOP("Measures", "Foot"),
     QT_TRANSLATE_NOOP("Measures", "From the ankle forward to the ball of the foot")},
};

QString measureText(const char* text) {
    return QCoreApplication::translate("Measures", text);
}

}  // namespace

PerformerMeasuresPanel::PerformerMeasuresPanel(PerformerEditor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      height_(new LengthBox(kShortest_m, kTallest_m, LengthBox::Metric::kCentimetres)),
      doubts_(new ProblemCard(Tone::kWarn, tr("Measure once more"), {})) {
    auto* column = makeColumn(this, {12, 0, 12, 12}, 8);
    auto* rows = new FormRows;
    keepSize(*height_, kHeightWidth, 0);
    rows->addRow(tr("Height"), height_);
    for (const MeasureWords& words : kMeasures) {
        auto* field = new LengthField(kShortestLength_m, kLongestLength_m);
        rows->addRow(measureText(words.name), field);
        field->describe(measureText(words.name), measureText(words.how));
        fields_.emplace_back(words.length, field);
        connect(field, &LengthField::lengthEdited, this,
                [this, length = words.length](double length_m) { editor_.setLength(length, length_m); });
    }
    rows->addHint(tr("What is left empty follows the height."));
    column->addWidget(rows);
    column->addWidget(doubts_);
    connect(height_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this](double height_m) { editor_.setHeight(height_m); });
    connect(&editor, &PerformerEditor::performerChanged, this, &PerformerMeasuresPanel::refresh);
    refresh();
}

LengthField& PerformerMeasuresPanel::field(double BodyMeasures::*length) {
    const auto found =
        std::find_if(fields_.begin(), fields_.end(), [&](const auto& f) { return f.first == length; });
    require(found != fields_.end(), "every length has a field");
    return *found->second;
}

QString PerformerMeasuresPanel::doubtsInWords(const BodyMeasures& measures) {
    QStringList sentences;
    for (const MeasureWords& words : kMeasures) {
        const MeasureDoubt doubt = doubtAbout(measures, words.length);
        if (doubt == MeasureDoubt::kNone)
            continue;
        const QString sentence = doubt == MeasureDoubt::kLong
                                     ? tr("%1: %2 is long for this height, where %3 is usual.")
                                     : tr("%1: %2 is short for this height, where %3 is usual.");
        sentences += sentence.arg(measureText(words.name), shortLengthText(measures.*words.length),
                                  shortLengthText(proportionalLength_m(measures, words.length)));
    }
    const HeightCheck check = checkHeight(measures);
    if (!check.fits)
        sentences += tr("Trunk and legs make a height of %1, not %2.")
                         .arg(shortLengthText(check.sum_m), shortLengthText(measures.height_m));
    return sentences.join('\n');
}

void PerformerMeasuresPanel::refresh() {
    setEnabled(editor_.hasPerformer());
    if (!editor_.hasPerformer())
        return;
    const BodyMeasures& measures = editor_.performer().measures;
    const QSignalBlocker quiet(height_);
    if (height_->value() != measures.height_m)
        height_->setValue(measures.height_m);
    for (const auto& [length, field] : fields_)
        field->setLength(measures.*length, proportionalLength_m(measures, length));
    const QString doubts = doubtsInWords(measures);
    doubts_->setTexts(tr("Measure once more"), doubts);
    doubts_->setVisible(!doubts.isEmpty());
}

}  // namespace noctule::ui
