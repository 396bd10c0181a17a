// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/recording_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QGridLayout>

#include "core/import/import_format.h"
#include "core/import/segment_map.h"
#include "core/import/sensor_findings.h"
#include "ui/language/core_words.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

constexpr int kRecordingDialogWidth = 1000, kFoundWidth = 328, kFoundLabels = 100, kSegmentWidth = 150,
              kSensorsHeight = 120;
constexpr double kAsFileSays_hz = 0, kMostRate_hz = 10000;

QString wordsOf(const std::vector<std::string>& sentences) {
    QStringList lines;
    for (const std::string& sentence : sentences)
        lines.append(coreWords(sentence) + (sentence.ends_with('.') ? "" : "."));
    return lines.join('\n');
}

/// What the sensor measures, in short.
QString quantitiesText(const SensorFindings& found) {
    QStringList parts;
    if (found.gyroscope)
        parts.append(RecordingDialog::tr("rate"));
    if (found.accelerometer)
        parts.append(RecordingDialog::tr("acceleration"));
    if (found.magnetometer)
        parts.append(RecordingDialog::tr("field"));
    if (found.attitude)
        parts.append(RecordingDialog::tr("attitude"));
    return parts.isEmpty() ? RecordingDialog::tr("nothing") : parts.join(", ");
}

QString titleOf(const QStringList& paths) {
    const QString first = QFileInfo(paths.value(0)).fileName();
    return paths.size() == 1
               ? RecordingDialog::tr("Import %1").arg(first)
               : RecordingDialog::tr("Import %1 and %n more", nullptr, int(paths.size()) - 1).arg(first);
}

}  // namespace

RecordingDialog::RecordingDialog(SharedContext& shared, const QStringList& paths, QWidget* parent)
    : DialogFrame(titleOf(paths),
                  tr("The recording becomes a take of this session. Its files stay as they are; nothing is "
                     "written before Import."),
                  tr("Import"), parent),
      world(new QComboBox),
      rate(new QDoubleSpinBox),
      by_movement(makeButton(ButtonKind::kOutlined, tr("Find by movement"), "search")),
      choose_map(makeButton(ButtonKind::kText, tr("Choose a map"))),
      say_columns(makeButton(ButtonKind::kOutlined, tr("Say what the columns are"))),
      shared_(shared),
      format_((new Label)->wrapped()),
      sensors_((new Label)->wrapped()),
      gaps_((new Label)->wrapped()),
      reference_((new Label)->wrapped()),
      notes_((new Label({}, TextRole::kSecondary, Ink::kHint))->wrapped()),
      warnings_((new Label({}, TextRole::kSecondary, Ink::kWarn))->wrapped()),
      open_((new Label({}, TextRole::kSecondary, Ink::kWarn))->wrapped()),
      progress_(new JobProgress) {
    request_.paths = paths;
    setWide(kRecordingDialogWidth);
    makeFields();
    content()->addWidget(progress_);
    connect(progress_, &JobProgress::ended, this, &RecordingDialog::refresh);
    connect(rate, &QDoubleSpinBox::editingFinished, this, &RecordingDialog::read);
    connect(world, qOverload<int>(&QComboBox::currentIndexChanged), this, &RecordingDialog::read);
    connect(by_movement, &QPushButton::clicked, this, &RecordingDialog::find);
    connect(choose_map, &QPushButton::clicked, this, &RecordingDialog::askForMap);
    connect(say_columns, &QPushButton::clicked, this, &RecordingDialog::askForColumns);
    read();
}

void RecordingDialog::makeFields() {
    auto* columns = addRow(content(), 16);
    auto* left = new QWidget;
    auto* table = makeColumn(left, {}, 8);
    table->addWidget(new Label(tr("Sensors"), TextRole::kSection, Ink::kValue, true));
    auto* buttons = addRow(table, 8);
    for (QWidget* button : {by_movement, choose_map, say_columns})
        buttons->addWidget(button);
    buttons->addStretch();
    auto* area = new QWidget;
    rows_column_ = makeColumn(area);
    keepMinimumHeight(*area, kSensorsHeight);
    table->addWidget(area, 1);
    columns->addWidget(left, 1);

    auto* right = new QWidget;
    auto* facts = makeColumn(right, {0, 0, 8, 0}, 8);
    facts->addWidget(new Label(tr("What was found"), TextRole::kSection, Ink::kValue, true));
    auto* form = new FormRows(kFoundLabels);
    form->addRow(tr("Format"), format_);
    form->addRow(tr("Sensors"), sensors_);
    form->addRow(tr("Missing"), gaps_);
    form->addRow(tr("Reference"), reference_);
    rate->setRange(kAsFileSays_hz, kMostRate_hz);
    rate->setDecimals(3);
    rate->setSuffix(tr(" Hz"));
    rate->setSpecialValueText(tr("as the file says"));
    form->addRow(tr("Rate"), rate);
    world->addItem(tr("as the file says"), QString());
    for (const auto& [text, name] : {std::pair{tr("East, north, up"), "enu"},
                                     {tr("North, west, up (MVN)"), "nwu"},
                                     {tr("North, east, down"), "ned"},
                                     {tr("Forward, up, right (OpenSim)"), "opensim"},
                                     {tr("Noctule's: Y is up"), "noctule"}})
        world->addItem(text, QString(name));
    form->addRow(tr("World axes"), world);
    world->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    world->setMinimumContentsLength(12);
    for (QWidget* field : std::initializer_list<QWidget*>{rate, world})
        keepMinimumHeight(*field, 30);
    facts->addWidget(form);
    facts->addWidget(open_);
    facts->addWidget(warnings_);
    facts->addWidget(notes_);
    facts->addStretch(1);
    auto* found = new ScrollArea(right);
    keepMaximumWidth(*found, kFoundWidth);
    columns->addWidget(found);
}

bool RecordingDialog::isBusy() const {
    return job_ && job_->state() == Job::State::kRunning;
}

QComboBox* RecordingDialog::segmentOf(size_t sensor) const {
    return sensor < segments_.size() ? segments_[sensor] : nullptr;
}

/// Again whenever the operator says otherwise; corrections that come meanwhile are read together afterwards.
void RecordingDialog::read() {
    ImportChoice choice;
    choice.rate_hz = rate->value();
    choice.world = worldFrameNamed(world->currentData().toString().toStdString());
    const bool same = choice.rate_hz == request_.choice.rate_hz && choice.world == request_.choice.world;
    if (fills_ || (same && recording_))
        return;
    request_.choice = choice;
    if (isBusy()) {
        asks_again_ = true;
        return;
    }
    recording_.reset();
    job_ = shared_.jobs().start<ImportedRecording>(
        {tr("Reading %1"), QFileInfo(request_.paths.value(0)).fileName()},
        [request = request_](const JobContext& job) { return readRecording(request, job); },
        [self = QPointer(this)](Result<ImportedRecording> recording) -> QString {
            if (self)
                self->present(std::move(recording));
            return {};
        },
        Jobs::Loudness::kQuiet);
    progress_->follow(job_);
    refresh();
}

void RecordingDialog::present(Result<ImportedRecording> read_now) {
    job_ = nullptr;
    if (std::exchange(asks_again_, false))
        return read();
    found_.clear();
    problem_.reset();
    if (read_now)
        recording_ = std::make_shared<ImportedRecording>(std::move(*read_now));
    else
        problem_ = read_now.error();
    progress_->follow(nullptr);  // what went wrong is said in one place
    if (isTable() && request_.map.is_null())
        problem_ = Error{ErrorKind::kUsage,
                         tr("Nobody has said yet what the columns of this table are").toStdString(),
                         tr("Say it here, or choose a map that does").toStdString()};
    if (isTable() && !columns_)
        lookAtColumns();
    makeSensorRows();
    showFound();
    refresh();
    fitHeight();
}

void RecordingDialog::makeSensorRows() {
    delete rows_;
    rows_ = nullptr;
    segments_.clear();
    if (!recording_)
        return;
    auto* rows = new QWidget;
    auto* grid = makeGrid(rows, {0, 0, 8, 0}, 6);
    int column = 0;
    for (const QString& head :
         {tr("Sensor"), tr("Segment"), tr("Rate"), tr("Length"), tr("Missing"), tr("Holds")})
        grid->addWidget(new Label(head, TextRole::kSecondary, Ink::kHint), 0, column++);
    for (size_t sensor = 0; sensor < recording_->sensors.size(); ++sensor)
        addSensorRow(sensor, rows);
    grid->setColumnStretch(5, 1);
    grid->setRowStretch(int(recording_->sensors.size()) + 1, 1);
    auto* area = new ScrollArea(rows);
    rows_ = area;
    rows_column_->addWidget(area);
    area->show();  // at once, not with the next event: the dialog's height counts it
}

void RecordingDialog::addSensorRow(size_t sensor, QWidget* rows) {
    const ImportedSensor& one = recording_->sensors[sensor];
    const SensorFindings found = findingsOf(one);
    auto* grid = static_cast<QGridLayout*>(rows->layout());
    const int line = int(sensor) + 1;
    auto* name = new Label(QString::fromStdString(one.id), TextRole::kBody, Ink::kValue);
    auto* segment = new QComboBox;
    segment->addItem(tr("nowhere"), QString());
    for (const std::string& joint : canonicalJointNames())
        segment->addItem(segmentName(joint), QString::fromStdString(joint));
    segment->setCurrentIndex(std::max(0, segment->findData(QString::fromStdString(one.segment))));
    segment->setAccessibleName(tr("Segment of sensor %1").arg(name->text()));
    keepSize(*segment, kSegmentWidth, 0);
    name->setBuddy(segment);
    segments_.push_back(segment);
    const double share = found.rows > 0 ? double(found.missing) / double(found.rows) : 0;
    grid->addWidget(name, line, 0);
    grid->addWidget(segment, line, 1);
    grid->addWidget(new Label(tr("%1 Hz").arg(numberText(one.samples.rate_hz, 0))), line, 2);
    grid->addWidget(new Label(timeText(found.duration_s)), line, 3);
    grid->addWidget(new Label(found.missing == 0 ? tr("none") : percentText(share, 1), TextRole::kBody,
                              share > 0.01 ? Ink::kWarn : Ink::kValue),
                    line, 4);
    grid->addWidget((new Label(quantitiesText(found), TextRole::kSecondary, Ink::kHint))->wrapped(), line, 5);
    connect(segment, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, sensor, segment] {
        putOnSegment(sensor, segment->currentData().toString().toStdString());
    });
}

/// A segment holds one sensor: the one that sat there before sits nowhere then.
void RecordingDialog::putOnSegment(size_t sensor, const std::string& segment) {
    if (fills_)
        return;
    recording_->sensors[sensor].segment = segment;
    fills_ = true;
    for (size_t other = 0; other < segments_.size() && !segment.empty(); ++other)
        if (other != sensor && recording_->sensors[other].segment == segment) {
            recording_->sensors[other].segment.clear();
            segments_[other]->setCurrentIndex(0);
        }
    fills_ = false;
    refresh();
}

void RecordingDialog::showFound() {
    const bool there = recording_ != nullptr;
    double longest_s = 0;
    size_t rows = 0, missing = 0;
    for (size_t s = 0; there && s < recording_->sensors.size(); ++s) {
        const SensorFindings found = findingsOf(recording_->sensors[s]);
        longest_s = std::max(longest_s, recording_->sensors[s].offset_s + found.duration_s);
        rows += found.rows;
        missing += found.missing;
    }
    const ImportFormat* format = there ? findImportFormat(recording_->format) : nullptr;
    format_->setText(format ? coreWords(format->summary) : kNoValue);
    sensors_->setText(there ? tr("%1, for %2", "number of sensors, time")
                                  .arg(countText(qint64(recording_->sensors.size())), timeText(longest_s))
                            : kNoValue);
    gaps_->setText(!there ? kNoValue
                   : missing == 0
                       ? tr("none")
                       : tr("%1 of %2 rows").arg(countText(qint64(missing)), countText(qint64(rows))));
    const bool reference = there && (recording_->reference || !recording_->q_world_sensor.empty());
    reference_->setText(!there ? kNoValue : reference ? tr("comes with the recording") : tr("none"));
    showNotes();
}

void RecordingDialog::showNotes() {
    const auto& none = std::vector<std::string>();
    QString warnings = wordsOf(recording_ ? recording_->warnings : none);
    if (!found_.isEmpty())
        warnings += (warnings.isEmpty() ? "" : "\n") + found_.join('\n');
    warnings_->setText(warnings);
    warnings_->setVisible(!warnings.isEmpty());
    QString notes = wordsOf(recording_ ? recording_->notes : none);
    if (recording_ && columns_remembered_)
        notes += '\n' + tr("They are as you said for the last table with this header; check the units.");
    notes_->setText(notes);
    notes_->setVisible(!notes_->text().isEmpty());
}

void RecordingDialog::find() {
    if (!recording_ || isBusy())
        return;
    job_ = shared_.jobs().start<FoundSegments>(
        tr("Finding where each sensor sits"),
        [recording = std::make_shared<const ImportedRecording>(*recording_)](const JobContext& job) {
            return findSegments(*recording, job);
        },
        [self = QPointer(this)](Result<FoundSegments> found) -> QString {
            if (!self || !self->recording_)
                return {};
            self->job_ = nullptr;
            if (!found) {
                if (found.error().kind != ErrorKind::kCancelled)
                    self->setProblem(coreWords(found.error()));
                return {};
            }
            self->found_.clear();
            self->fills_ = true;
            for (size_t s = 0; s < self->segments_.size(); ++s) {
                const QString segment = QString::fromStdString(found->segments[s]);
                self->recording_->sensors[s].segment = found->segments[s];
                self->segments_[s]->setCurrentIndex(std::max(0, self->segments_[s]->findData(segment)));
                if (found->confidence[s] < 0.5)
                    self->found_.append(tr("Sensor %1 is placed on %2 without being sure.", "id, segment")
                                            .arg(QString::fromStdString(self->recording_->sensors[s].id),
                                                 segmentName(found->segments[s], NameCase::kInside)));
            }
            self->fills_ = false;
            for (const std::string& warning : found->warnings)
                self->found_.append(coreWords(warning) + ".");
            self->showNotes();
            self->refresh();
            return {};
        },
        Jobs::Loudness::kQuiet);
    progress_->follow(job_);
    refresh();
}

void RecordingDialog::refresh() {
    if (problem_ && problem_->kind != ErrorKind::kCancelled)
        setProblem(coreWords(problem_->text()));
    else
        setProblem({});
    say_columns->setVisible(isTable());
    say_columns->setDisabledBecause(isBusy()    ? tr("The recording is being read.")
                                    : !columns_ ? tr("The columns are being looked at.")
                                                : QString());
    const auto open = recording_ ? sensorsWithoutSegment(*recording_) : std::vector<std::string>();
    const bool single = recording_ && recording_->sensors.size() == 1;
    const bool none = recording_ && open.size() == recording_->sensors.size();
    open_->setText(
        single ? tr("One sensor alone makes no body; the verb orient of the command line finds how it turns.")
        : none ? tr("No sensor sits on a segment: the take will show no body.")
               : tr("%n sensor(s) sit nowhere: poses leave them out.", nullptr, int(open.size())));
    open_->setVisible(!open.empty());
    by_movement->setDisabledBecause(isBusy()      ? tr("The recording is being read.")
                                    : !recording_ ? tr("Nothing was read yet.")
                                    : single      ? tr("One sensor alone sits anywhere.")
                                                  : QString());
    actionButton()->setDisabledBecause(isBusy()      ? tr("The recording is being read.")
                                       : !recording_ ? tr("The files cannot be read.")
                                                     : QString());
}

void RecordingDialog::accept() {
    if (!recording_ || isBusy() || !shared_.session().makeSure())
        return;
    keep();
    DialogFrame::accept();
}

/// The job outlives the dialog: it is followed among the others.
void RecordingDialog::keep() {
    SharedContext* shared = &shared_;
    const RecordingToKeep request{recording_, shared->parts().software, shared->parts().utc_now()};
    emit shared->settled(About::kFile);
    shared->jobs().start<RecordingTake>(
        {tr("Importing %1"), QString::fromStdString(recording_->name)},
        [request, session = shared->session().session()](const JobContext& job) {
            return keepRecording(request, session, job);
        },
        [shared, folder = shared->session().session().folder](Result<RecordingTake> made) -> QString {
            if (!made) {
                if (made.error().kind != ErrorKind::kCancelled)
                    emit shared->failed(coreWords(made.error().message), coreWords(made.error().remedy),
                                        About::kFile);
                return {};
            }
            const QString name = QString::fromStdString(made->name);
            SessionModel& session = shared->session();
            if (session.isOpen() && session.session().folder == folder) {
                session.refresh(QString::fromStdString(
                    (session.session().takesFolder() / (made->name + ".noctule")).string()));
                session.setCurrentTake(session.session().findTake(made->name));
                shared->goTo(Step::kReview);
            }
            if (!made->warnings.empty())
                emit shared->warned(wordsOf(made->warnings).replace(QChar(0x0a), QChar(0x20)), About::kFile);
            return made->has_poses ? tr("%1 is ready").arg(name)
                                   : tr("%1 is imported, without poses").arg(name);
        });
}

}  // namespace noctule::ui
