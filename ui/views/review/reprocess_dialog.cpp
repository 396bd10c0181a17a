// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/reprocess_dialog.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLineEdit>
#include <array>

#include "core/estimation/paper_parameters.h"
#include "core/processing/outside_files.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/style/words.h"
#include "ui/views/fit_words.h"
#include "ui/views/open_take.h"
#include "ui/views/review/choice_row.h"
#include "ui/views/review_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

QBoxLayout* addGroup(QBoxLayout& into, const QString& title, const std::vector<QWidget*>& rows) {
    auto* group = new QWidget;
    into.addWidget(group);
    auto* column = makeColumn(group, {}, 8);
    column->addWidget(new Label(title, TextRole::kSection, Ink::kValue, true));
    for (QWidget* row : rows)
        column->addWidget(row);
    return column;
}

/// One of them is always chosen, at first the first.
void keepOneChosen(QObject* owner, const std::vector<ChoiceRow*>& rows) {
    auto* group = new QButtonGroup(owner);
    for (ChoiceRow* row : rows)
        group->addButton(row->button());
    rows.front()->setChecked(true);
}

QString calibrationInWords(const Calibration& calibration) {
    const QDateTime made =
        QDateTime::fromString(QString::fromStdString(calibration.created_utc), Qt::ISODate);
    return made.isValid() ? ReprocessDialog::tr("Made %1").arg(dateText(made))
                          : ReprocessDialog::tr("Nominal values of the suit");
}

}  // namespace

ReprocessDialog::ReprocessDialog(Studio& studio, const TakeOverview& overview, QWidget* parent)
    : DialogFrame((overview.runs.empty() ? tr("Process %1") : tr("Reprocess %1")).arg(openTakeName(studio)),
                  overview.runs.empty()
                      ? tr("Makes the motion out of the recording, which stays as it is.")
                      : tr("Adds a result to the take. The recording and earlier results stay as they are."),
                  overview.runs.empty() ? tr("Process") : tr("Reprocess"), parent),
      studio_(studio),
      overview_(overview) {
    auto* sides = new QWidget;
    auto* row = makeRow(sides, {0, 8, 8, 0}, 20);
    people_ = new Label({}, TextRole::kBody, Ink::kValue);
    people_->setVisible(overview.subjects.size() > 1);
    content()->addWidget(people_->wrapped());
    content()->addWidget(new ScrollArea(sides), 1);
    setWide(1024);
    std::array<QBoxLayout*, 3> columns;  // two would be higher than the smallest screen
    for (QBoxLayout*& column : columns) {
        auto* part = new QWidget;
        column = makeColumn(part, {}, 20);
        row->addWidget(part, 1);
    }
    addSensors(*columns[0]);
    addRoot(*columns[0]);
    addFilter(*columns[1]);
    addSmoothing(*columns[1]);
    addDetector(*columns[2]);
    addCalibration(*columns[2]);
    addName(*columns[2]);
    for (QBoxLayout* column : columns)
        column->addStretch();
    if (!overview.runs.empty())
        startFrom(overview.runs.back().settings);
    refresh();
}

void ReprocessDialog::addSensors(QBoxLayout& into) {
    using enum ChoiceRow::Kind;
    gyroscopes = new ChoiceRow(kCheck, tr("Gyroscopes"),
                               tr("How every limb turns: smooth and quick, but drifts by degrees a minute."));
    accelerometers =
        new ChoiceRow(kCheck, tr("Accelerometers"), tr("Which way is down: holds the tilt of every limb."));
    distances = new ChoiceRow(kCheck, tr("Distances"),
                              tr("Sound from source to board: holds heading and posture against drift."));
    addGroup(into, tr("Sensors"), {gyroscopes, accelerometers, distances});
    for (ChoiceRow* sensor : {gyroscopes, accelerometers, distances}) {
        sensor->setChecked(true);
        connect(sensor->button(), &QAbstractButton::toggled, this, &ReprocessDialog::refresh);
    }
}

void ReprocessDialog::addRoot(QBoxLayout& into) {
    using enum ChoiceRow::Kind;
    root_free = new ChoiceRow(kRadio, tr("Free"), tr("Found by the filter, as in a live recording."));
    root_given = new ChoiceRow(kRadio, tr("From another system"), tr("Its hips are used."));
    auto* under = new FormRows;
    ground = new QComboBox;
    ground->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    ground->setMinimumContentsLength(12);
    ground->addItems(
        {tr("Level floor"), tr("Uneven, steps"), tr("Treadmill"), tr("Contacts are not looked for")});
    under->addRow(tr("Ground"), ground);
    addGroup(into, tr("Root"), {root_free, root_given, under});
    keepOneChosen(this, {root_free, root_given});
    if (!overview_.has_external_root)
        root_given->setDisabledBecause(tr("Needs an external root: attach one under Reference first."));
    connect(root_given->button(), &QAbstractButton::toggled, this, &ReprocessDialog::refresh);
}

void ReprocessDialog::addFilter(QBoxLayout& into) {
    using enum ChoiceRow::Kind;
    ours = new ChoiceRow(kRadio, tr("Noctule"),
                         tr("Rotations without singularities; ranges that do not fit are left out."));
    paper = new ChoiceRow(kRadio, tr("Published filter"),
                          tr("Vlasic 2007 to the letter, as a baseline for comparison."));
    independent =
        new ChoiceRow(kRadio, tr("Independent sensors"),
                      tr("First how each sensor is turned, then the body. For suits without sound."));
    auto* column = addGroup(into, tr("Filter"), {ours, paper, independent});
    process_row_ = new QWidget;
    auto* row = makeRow(process_row_, {24, 0, 0, 0}, 8);
    auto* label = new Label(tr("Process sigma"), TextRole::kSecondary, Ink::kLabel);
    process_sigma_ = new QDoubleSpinBox;
    process_sigma_->setDecimals(3);
    process_sigma_->setRange(0.001, 1000);
    process_sigma_->setSingleStep(0.01);
    process_sigma_->setValue(PaperParameters{}.process_sigma_rad_per_s2);
    process_sigma_->setSuffix(tr(" rad/s²"));
    process_sigma_->setAccessibleName(label->text());
    row->addWidget(label);
    row->addWidget(process_sigma_, 1);
    column->addWidget(process_row_);
    keepOneChosen(this, {ours, paper, independent});
    independent->setVisible(overview_.suit.sources.empty());
    independent->setChecked(overview_.suit.sources.empty());
    for (ChoiceRow* filter : {paper, independent})
        connect(filter->button(), &QAbstractButton::toggled, this, &ReprocessDialog::refresh);
}

void ReprocessDialog::addSmoothing(QBoxLayout& into) {
    using enum ChoiceRow::Kind;
    not_smoothed =
        new ChoiceRow(kRadio, tr("None"),
                      areTogether() ? tr("All performers together: where they stand to each other is found.")
                                    : tr("As in a live recording."));
    smoothed_half_second =
        new ChoiceRow(kRadio, tr("Half a second"), tr("Each pose knows the 0.3 to 0.5 s that follow."));
    smoothed_whole = new ChoiceRow(
        kRadio, tr("Whole take"),
        areTogether()
            ? tr("Each pose knows all that came before and after. Each performer for itself: where they "
                 "stand to each other is not found.")
            : tr("Each pose knows all that came before and after: the usual choice for a recorded take."));
    most_probable = new ChoiceRow(
        kRadio, tr("Most probable motion"),
        tr("All readings weighed again together until nothing changes: the reference. Takes longer."));
    const std::vector<ChoiceRow*> rows{not_smoothed, smoothed_half_second, smoothed_whole, most_probable};
    addGroup(into, tr("Smoothing"), {rows.begin(), rows.end()});
    keepOneChosen(this, rows);
    for (ChoiceRow* row : rows)
        connect(row->button(), &QAbstractButton::toggled, this, [this] { people_->setText(people()); });
    (areTogether() ? not_smoothed : smoothed_whole)->setChecked(true);
}

void ReprocessDialog::addDetector(QBoxLayout& into) {
    using enum ChoiceRow::Kind;
    inflection = new ChoiceRow(kRadio, tr("By the rise of the pulse"),
                               tr("As published by Vlasic 2007, and as in a live recording."));
    matched = new ChoiceRow(kRadio, tr("By the whole pulse"),
                            tr("Fits each source’s own pulse: finer where nothing stands in between."));
    addGroup(into, tr("Distances are measured"), {inflection, matched});
    keepOneChosen(this, {inflection, matched});
    // Suits that hear each other are told apart by carrier, which only the first of both does well.
    if (overview_.level == TakeLevel::kSignal)
        (areTogether() ? inflection : matched)->setChecked(true);
    else
        matched->setDisabledBecause(tr("Needs the recorded sound, which this take does not hold."));
    connect(paper->button(), &QAbstractButton::toggled, this, [this](bool chosen) {
        const bool by_rise = chosen || areTogether() || overview_.level != TakeLevel::kSignal;
        (by_rise ? inflection : matched)->setChecked(true);
    });
}

void ReprocessDialog::addCalibration(QBoxLayout& into) {
    using enum ChoiceRow::Kind;
    calibration_in_force =
        new ChoiceRow(kRadio, tr("In force in the take"), calibrationInWords(overview_.calibration));
    calibration_in_use = new ChoiceRow(kRadio, tr("In use now"), tr("Becomes the one in force."));
    calibration_from_file = new ChoiceRow(kRadio, tr("From a file"), tr("Becomes the one in force."));
    const std::vector<ChoiceRow*> rows{calibration_in_force, calibration_in_use, calibration_from_file};
    addGroup(into, tr("Calibration"), {rows.begin(), rows.end()});
    keepOneChosen(this, rows);
    const auto in_use = studio_.calibrations().inForce();
    const bool several = overview_.subjects.size() > 1;  // each has its own; one cannot be that of all
    calibration_in_use->setVisible(in_use.has_value() && !several);
    calibration_from_file->setVisible(!several);
    if (in_use && !several && lackOf(overview_.suit, *in_use).isNone() && !overview_.lack.isNone())
        calibration_in_use->setChecked(true);
    for (ChoiceRow* row : rows) {
        connect(row->button(), &QAbstractButton::toggled, this, &ReprocessDialog::refresh);
        connect(row->button(), &QAbstractButton::clicked, this, [this] {
            file_problem_.clear();  // another choice, or another file
            refresh();
        });
    }
    connect(calibration_from_file->button(), &QAbstractButton::clicked, this, [this] {
        const QString path =
            FileChoice{"calibrations", tr("Choose a calibration"), tr("Calibrations (*.json)")}.toOpen(this);
        if (path.isEmpty() && !calibration_)
            calibration_in_force->setChecked(true);
        else if (!path.isEmpty())
            setCalibrationFile(path);
    });
}

void ReprocessDialog::addName(QBoxLayout& into) {
    auto* rows = new FormRows;
    name = new QLineEdit;
    rows->addRow(tr("Name"), name);
    name->setToolTip(
        tr("Under this name batch commands and exports find the result. A, G and D stand for accelerometers, "
           "gyroscopes and distances."));
    into.addWidget(rows);
}

void ReprocessDialog::setCalibrationFile(const QString& path) {
    const auto calibration = readCalibrationFile(path.toStdString());
    file_problem_ = calibration ? QString() : coreWords(calibration.error());
    if (!calibration) {
        calibration_in_force->setChecked(true);
        return refresh();
    }
    calibration_ = *calibration;
    calibration_from_file->setChecked(true);
    refresh();
    calibration_from_file->button()->setText(QFileInfo(path).fileName());
}

bool ReprocessDialog::areTogether() const {
    return overview_.subjects.size() > 1 && !overview_.suit.sources.empty();
}

void ReprocessDialog::startFrom(const RunSettings& settings) {
    const auto has = [&](char sensor) { return settings.sensors.find(sensor) != std::string::npos; };
    accelerometers->setChecked(has('A'));
    gyroscopes->setChecked(has('G'));
    distances->setChecked(has('D'));
    if (settings.root_given && overview_.has_external_root)
        root_given->setChecked(true);
    if (const auto known = groundFromName(settings.ground))
        ground->setCurrentIndex(static_cast<int>(*known));
    if (settings.estimator == "paper") {
        paper->setChecked(true);
        inflection->setChecked(true);
    }
    if (settings.estimator == kManifoldEstimator)
        ours->setChecked(true);
    if (settings.process_sigma_rad_per_s2)
        process_sigma_->setValue(*settings.process_sigma_rad_per_s2);
    if (settings.smoother == smootherName(Smoother::kLag))
        smoothed_half_second->setChecked(true);
    if (settings.smoother == smootherName(Smoother::kFull))
        smoothed_whole->setChecked(true);
    if (settings.smoother == smootherName(Smoother::kBatch))
        most_probable->setChecked(true);
    if (settings.detector == detectorName(Detector::kMatched) && overview_.level == TakeLevel::kSignal)
        matched->setChecked(true);
    if (settings.detector == detectorName(Detector::kInflection))
        inflection->setChecked(true);
}

CalibrationLack ReprocessDialog::lackOfChosen() const {
    CalibrationLack lack = overview_.lack;
    if (calibration_from_file->isChecked() && calibration_)
        lack = lackOf(overview_.suit, *calibration_);
    else if (const auto in_use = studio_.calibrations().inForce(); calibration_in_use->isChecked() && in_use)
        lack = lackOf(overview_.suit, *in_use);
    if (overview_.level == TakeLevel::kReadings)
        lack.sources.clear();
    return lack;
}

/// Said before, not by a result that cannot be used.
void ReprocessDialog::showLack() {
    if (!file_problem_.isEmpty())
        return setProblem(file_problem_);
    const std::string sensors = std::string(accelerometers->isChecked() ? "A" : "") +
                                (gyroscopes->isChecked() ? "G" : "") + (distances->isChecked() ? "D" : "");
    const CalibrationLack lack = lackOfChosen();
    const Grade grade = gradeOf(lack, sensors);
    setProblem(
        grade == Grade::kGood ? QString()
        : grade == Grade::kNotUsable
            ? tr("The result will not be usable: there is no calibration of %1. Choose one that has it.")
                  .arg(lackWords(lack))
            : tr("The result will be less exact: there is no calibration of %1.").arg(lackWords(lack)));
}

QString ReprocessDialog::people() const {
    QStringList names;
    for (const TakeSubject& subject : overview_.subjects)
        names += QString::fromStdString(subject.name);
    const QString all = names.join(tr(", "));
    if (!areTogether())
        return tr("%1: each suit is processed alone, since they measure no distances.").arg(all);
    if (independent->isChecked() || paper->isChecked())
        return tr("%1: each suit is processed alone, since this filter knows one body only.").arg(all);
    if (!not_smoothed->isChecked())
        return tr("%1: each suit is processed alone, since smoothing goes over one body only.").arg(all);
    if (root_given->isChecked())
        return tr("%1: each suit is processed alone, since another system says where everybody is.").arg(all);
    if (!distances->isChecked())
        return tr("%1: each suit is processed alone, since no distances are used.").arg(all);
    return tr("%1: all suits are processed together, with the ranges between them, where they heard each "
              "other.")
        .arg(all);
}

void ReprocessDialog::refresh() {
    const bool any = independent->isChecked() || accelerometers->isChecked() || gyroscopes->isChecked() ||
                     distances->isChecked();
    actionButton()->setDisabledBecause(any ? QString() : tr("Choose at least one kind of sensor."));
    showLack();
    people_->setText(people());
    process_row_->setVisible(paper->isChecked());
    const bool alone = independent->isChecked();
    const QString only_ours = paper->isChecked() ? tr("The filter of the paper has no smoother.") : QString(),
                  whole_only = alone
                                   ? tr("Independent sensors are smoothed over the whole take or not at all.")
                                   : only_ours;
    if (paper->isChecked())
        not_smoothed->setChecked(true);
    if (alone && !not_smoothed->isChecked())
        smoothed_whole->setChecked(true);
    smoothed_half_second->setDisabledBecause(whole_only);
    smoothed_whole->setDisabledBecause(only_ours);
    most_probable->setDisabledBecause(whole_only);
    const QString all_used = alone ? tr("Independent sensors use all that each sensor measures.") : QString();
    for (ChoiceRow* sensor : {gyroscopes, accelerometers, distances})
        sensor->setDisabledBecause(all_used);
    if (alone)
        root_free->setChecked(true);
    if (overview_.has_external_root)
        root_given->setDisabledBecause(alone ? tr("Independent sensors find the root by the feet.")
                                             : QString());
    ground->setEnabled(!paper->isChecked() && !alone);
    ground->setToolTip(root_given->isChecked()
                           ? tr("When the feet stand is found out; the root is the other system’s.")
                           : tr("Feet that stand hold the root: on a level floor their place and height, on "
                                "uneven ground their place, on a treadmill nothing."));
    name->setPlaceholderText(QString::fromStdString(defaultRunName(request().tracker)));
}

ProcessRequest ReprocessDialog::request() const {
    ProcessRequest request;
    request.take_path = overview_.path;
    const bool alone = independent->isChecked();
    request.tracker.sensors = {alone || accelerometers->isChecked(), alone || gyroscopes->isChecked(),
                               !alone && distances->isChecked()};
    request.tracker.root_given = root_given->isChecked();
    request.tracker.ground = static_cast<Ground>(ground->currentIndex());
    request.tracker.estimator = paper->isChecked() ? kPaperEstimator
                                : alone            ? kOrientationEstimator
                                                   : kManifoldEstimator;
    if (paper->isChecked())
        request.tracker.parameters[kPaperProcessSigma] = process_sigma_->value();
    request.tracker.smoother = most_probable->isChecked()          ? Smoother::kBatch
                               : smoothed_whole->isChecked()       ? Smoother::kFull
                               : smoothed_half_second->isChecked() ? Smoother::kLag
                                                                   : Smoother::kNone;
    request.detector = matched->isChecked() ? Detector::kMatched : Detector::kInflection;
    if (calibration_from_file->isChecked())
        request.calibration = calibration_;
    else if (calibration_in_use->isChecked())
        request.calibration = studio_.calibrations().inForce();
    request.run_name = name->text().trimmed().toStdString();
    request.software = studio_.parts().software;
    request.created_utc = studio_.parts().utc_now ? studio_.parts().utc_now() : std::string();
    return request;
}

}  // namespace noctule::ui
