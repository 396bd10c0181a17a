// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/motion_dialog.h"

#include <QComboBox>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSlider>

#include "core/body/bone_names.h"
#include "core/body/joint_names.h"
#include "core/mesh/rig/bone_map.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/models/part_names.h"
#include "ui/style/lengths.h"
#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/length_box.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/session/motion_picture.h"
#include "ui/widgets/button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

constexpr int kMotionDialogWidth = 1000, kFactsWidth = 450, kFactLabels = 110, kJointWidth = 200,
              kFactsHeight = 300;
constexpr double kLeastHeight_m = 0.3, kMostHeight_m = 3, kAsShown_m = 0.29;
constexpr const char* kScenarioKey = "motions/scenario";

int rowOf(const QComboBox& box, int value) {
    return std::max(0, box.findData(value));
}

/// Warnings name the option that helps on the command line; here the fields beside them do.
QString withoutOptions(const QString& warning) {
    static const QRegularExpression kEndOfClause("(?<=[.;]) ");
    QStringList kept;
    for (const QString& clause : warning.split(kEndOfClause))
        if (!clause.contains("--"))
            kept.append(clause);
    QString text = kept.isEmpty() ? warning : kept.join(' ');
    if (text.endsWith(';'))
        text.chop(1);
    return withFullStop(text);
}

}  // namespace

MotionDialog::MotionDialog(Studio& studio, const QString& path, QWidget* parent)
    : DialogFrame(tr("Import %1").arg(QFileInfo(path).fileName()),
                  tr("The motion becomes a take of this session: a simulated suit is worn by the person that "
                     "it shows."),
                  tr("Import"), parent),
      up(new QComboBox),
      unit(new QComboBox),
      scenario(new QComboBox),
      height(new LengthBox(kAsShown_m, kMostHeight_m, LengthBox::Metric::kMetres)),
      exchange_sides(makeButton(ButtonKind::kOutlined, tr("Exchange left and right"), "swap")),
      find_again(makeButton(ButtonKind::kText, tr("Find again"))),
      save_bones(makeButton(ButtonKind::kText, tr("Save as bone map"))),
      frame(new QSlider(Qt::Horizontal)),
      studio_(studio),
      path_(path),
      picture_(new MotionPicture),
      figure_((new Label)->wrapped()),
      frames_(new Label),
      rest_(new Label),
      kept_((new Label({}, TextRole::kSecondary, Ink::kHint))->wrapped()),
      matched_(new Label({}, TextRole::kSection, Ink::kValue, true)),
      warnings_((new Label({}, TextRole::kSecondary, Ink::kWarn))->wrapped()),
      progress_(new JobProgress) {
    setWide(kMotionDialogWidth);
    auto* columns = addRow(content(), 20);
    columns->addWidget(makePicture(), 1);
    auto* facts = new ScrollArea(makeFacts());
    keepSize(*facts, kFactsWidth, 0);
    columns->addWidget(facts);
    content()->addWidget(progress_);
    connect(progress_, &JobProgress::ended, this, &MotionDialog::refresh);
    read();
}

QWidget* MotionDialog::makePicture() {
    auto* side = new QWidget;
    auto* column = makeColumn(side, {}, 8);
    keepMinimumHeight(*picture_, 150);
    column->addWidget(picture_, 1);
    frame->setAccessibleName(tr("Frame of the motion"));
    column->addWidget(frame);
    connect(frame, &QSlider::valueChanged, this, [this](int value) { picture_->setFrame(value); });
    column->addWidget(warnings_);
    column->addWidget(kept_);
    return side;
}

QWidget* MotionDialog::makeFacts() {
    auto* side = new QWidget;
    auto* column = makeColumn(side, {0, 0, 8, 0}, 10);
    auto* form = new FormRows(kFactLabels);
    form->addRow(tr("Figure"), figure_);
    form->addRow(tr("Frames"), frames_);
    form->addRow(tr("Zero pose"), rest_);
    using figure::UpAxis;
    for (const auto& [text, axis] : {std::pair{tr("Found by itself"), UpAxis::kAuto},
                                     {tr("Y is up"), UpAxis::kY},
                                     {tr("Z is up"), UpAxis::kZ}})
        up->addItem(text, static_cast<int>(axis));
    form->addRow(tr("Up axis"), up);
    for (const auto& [text, value] : {std::pair{tr("Found by itself"), BvhUnit::kAuto},
                                      {tr("Metres"), BvhUnit::kMetre},
                                      {tr("Centimetres"), BvhUnit::kCentimetre},
                                      {tr("Millimetres"), BvhUnit::kMillimetre},
                                      {tr("Inches"), BvhUnit::kInch},
                                      {tr("Decimetres (MakeHuman)"), BvhUnit::kDecimetre},
                                      {tr("CMU's unit, 5.64 cm"), BvhUnit::kCmu}})
        unit->addItem(text, static_cast<int>(value));
    form->addRow(tr("Unit"), unit);
    height->setSpecialValueText(tr("as the file shows"));
    form->addRow(tr("Height"), height);
    form->addControl(exchange_sides);
    scenario->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    scenario->setMinimumContentsLength(12);
    scenario->addItem(tr("Ideal: no noise at all"), "ideal");
    scenario->addItem(tr("Nominal: as in a good room"), "nominal");
    scenario->addItem(tr("Realistic: slipping boards, soft tissue"), "realistic");
    scenario->setCurrentIndex(
        std::max(0, scenario->findData(studio_.settings().value(kScenarioKey, "nominal").toString())));
    form->addRow(tr("Suit and room"), scenario);
    for (QWidget* field : std::initializer_list<QWidget*>{up, unit, height, exchange_sides, scenario})
        keepMinimumHeight(*field, 30);
    keepMinimumHeight(*form, kFactsHeight);  // a wrapped label's height is not asked for in time
    column->addWidget(form);
    auto* head = addRow(column, 8);
    head->addWidget(matched_, 1);
    head->addWidget(find_again);
    head->addWidget(save_bones);
    auto* area = new QWidget;
    rows_column_ = makeColumn(area);
    column->addWidget(area);
    column->addStretch(1);

    const auto corrected = [this] {
        if (fills_)
            return;
        hints_.up = static_cast<UpAxis>(up->currentData().toInt());
        hints_.unit = static_cast<BvhUnit>(unit->currentData().toInt());
        hints_.height_m = height->value() < kLeastHeight_m ? 0 : height->value();
        understand();
    };
    connect(up, qOverload<int>(&QComboBox::currentIndexChanged), this, corrected);
    connect(unit, qOverload<int>(&QComboBox::currentIndexChanged), this, corrected);
    connect(height, qOverload<double>(&QDoubleSpinBox::valueChanged), this, corrected);
    connect(exchange_sides, &QPushButton::clicked, this, &MotionDialog::exchangeSides);
    connect(save_bones, &QPushButton::clicked, this, &MotionDialog::askWhereToSave);
    connect(find_again, &QPushButton::clicked, this, [this] {
        hints_ = {};
        kept_->clear();
        understand();
    });
    return side;
}

void MotionDialog::read() {
    const std::string path = path_.toStdString();
    job_ = studio_.jobs().start<MotionFile>(
        {tr("Reading %1"), QFileInfo(path_).fileName()},
        [path](const JobContext& job) { return readMotionFile(path, {}, job); },
        [self = QPointer(this)](Result<MotionFile> file) -> QString {
            if (!self)
                return {};
            if (!file) {
                self->unread_ = file.error();
                self->refresh();
                return {};
            }
            const auto kept = KeptCorrections(self->studio_.settings()).find(*file->document);
            self->present(file);
            if (kept) {
                self->hints_ = *kept;
                self->kept_->setText(
                    tr("Corrections of an earlier import with the same joints are in force."));
                self->understand();
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
    progress_->follow(job_);
    refresh();
}

/// Corrections that come meanwhile are worked out together afterwards.
void MotionDialog::understand() {
    if (!file_.document)
        return;
    if (isBusy()) {
        asks_again_ = true;
        return;
    }
    job_ = studio_.jobs().start<MotionFile>(
        {tr("Understanding %1"), QFileInfo(path_).fileName()},
        [file = file_, hints = hints_](const JobContext&) -> Result<MotionFile> {
            return understoodAnew(file, hints);
        },
        [self = QPointer(this)](Result<MotionFile> file) -> QString {
            if (self)
                self->present(file);
            return {};
        },
        Jobs::Loudness::kQuiet);
    refresh();
}

void MotionDialog::present(const Result<MotionFile>& file) {
    job_ = nullptr;
    if (file)
        file_ = *file;
    else
        unread_ = file.error();
    if (std::exchange(asks_again_, false))
        return understand();
    if (!rows_ && file_.document)
        makeRows();
    showFacts();
    showRows();
    refresh();
    fitHeight();
}

void MotionDialog::makeRows() {
    QStringList names{tr("not in the file")};
    for (const BvhJoint& joint : file_.document->joints)
        names.append(QString::fromStdString(joint.name));
    rows_ = new QWidget;
    auto* grid = makeGrid(rows_, {}, 6);
    int line = 0;
    for (const std::string& joint : canonicalJointNames()) {
        auto* label = new Label(segmentName(joint), TextRole::kBody, Ink::kLabel);
        auto* bone = new QComboBox;
        bone->addItems(names);
        bone->setAccessibleName(tr("Joint of %1").arg(segmentName(joint, NameCase::kInside)));
        keepSize(*bone, kJointWidth, 0);
        grid->addWidget(label, line, 0);
        grid->addWidget(bone, line++, 1);
        label->setBuddy(bone);
        bones_[joint] = bone;
        connect(bone, qOverload<int>(&QComboBox::currentIndexChanged), this,
                [this, joint](int index) { takeBone(joint, index); });
    }
    grid->setColumnStretch(0, 1);
    rows_column_->addWidget(rows_);
    rows_->show();  // at once, not with the next event: the dialog's height counts it
}

/// Which of the file's joints plays one of ours; -1: none.
int MotionDialog::jointOf(const std::string& joint) const {
    if (file_.motion) {
        const auto found = file_.motion->joints.find(joint);
        return found == file_.motion->joints.end() ? -1 : found->second;
    }
    std::vector<NamedBone> bones;
    for (const BvhJoint& bone : file_.document->joints)
        bones.push_back({bone.name, bone.parent});
    if (const auto by_hand = hints_.joints.find(joint); by_hand != hints_.joints.end())
        for (size_t j = 0; j < bones.size(); ++j)
            if (bones[j].name == by_hand->second)
                return static_cast<int>(j);
    const auto by_name = jointsByName(bones).bone_of_joint;
    const auto found = by_name.find(joint);
    return found == by_name.end() ? -1 : found->second;
}

void MotionDialog::takeBone(const std::string& joint, int index) {
    if (fills_)
        return;
    if (index == 0)
        hints_.joints.erase(joint);
    else
        hints_.joints[joint] = file_.document->joints[static_cast<size_t>(index - 1)].name;
    understand();
}

void MotionDialog::exchangeSides() {
    if (!file_.motion)
        return;
    figure::JointsByHand exchanged = hints_.joints;
    for (const auto& [name, joint] : file_.motion->joints)
        if (const std::string other = mirroredSegment(name); other != name)
            exchanged[other] = file_.motion->clip.skeleton.joint(joint).name;
    hints_.joints = std::move(exchanged);
    understand();
}

bool MotionDialog::saveBones(const QString& path) {
    BoneMap map;
    for (const auto& [joint, box] : bones_)
        if (box->currentIndex() > 0)
            map.node_of_joint[joint] = box->currentText().toStdString();
    const Status written = writeBoneMap(path.toStdString(), map, true);
    setProblem(written ? QString() : coreWords(written.error()));
    return written.ok();
}

void MotionDialog::askWhereToSave() {
    const QString path = FileChoice{.kind = "bone_maps",
                                    .title = tr("Save as bone map"),
                                    .filter = tr("Bone maps (*.json)"),
                                    .name = QFileInfo(path_).completeBaseName() + ".bones.json",
                                    .usual = QFileInfo(path_).path()}
                             .toSave(this);
    if (!path.isEmpty())
        saveBones(path);
}

void MotionDialog::showFacts() {
    fills_ = true;
    const auto& motion = file_.motion;
    picture_->setMotion(motion);
    figure_->setText(motion ? tr("%1 tall, %2 points up, 1 unit is %3 m", "height, axis, length")
                                  .arg(lengthText(motion->measures.height_m), coreWords(toText(motion->up)),
                                       numberText(motion->metres_per_unit, 4))
                            : tr("no person was found"));
    const double step_s = motion ? motion->clip.frame_time_s : file_.document->frame_time_s;
    const int frames = static_cast<int>(motion ? motion->clip.frames.size() : file_.document->frameCount());
    frames_->setText(
        tr("%1 at %2 per second", "frames, rate").arg(countText(frames), numberText(1 / step_s, 1)));
    rest_->setText(motion ? coreWords(motion->rest_pose) : QString());
    frame->setRange(0, std::max(0, frames - 1));
    up->setCurrentIndex(rowOf(*up, static_cast<int>(hints_.up)));
    unit->setCurrentIndex(rowOf(*unit, static_cast<int>(hints_.unit)));
    // The same value would take away what is being typed.
    if (const double height_m = hints_.height_m > 0 ? hints_.height_m : kAsShown_m;
        height->value() != height_m)
        height->setValue(height_m);
    QStringList warnings;
    for (const std::string& warning : file_.reader_warnings)
        warnings.append(coreWords(warning));
    for (const auto& said : motion ? motion->warnings : std::vector<std::string>())
        warnings.append(withoutOptions(coreWords(said) + "."));
    warnings_->setText(warnings.join('\n'));
    warnings_->setVisible(!warnings.isEmpty());
    fills_ = false;
}

void MotionDialog::showRows() {
    fills_ = true;
    int matched = 0;
    for (const auto& [joint, box] : bones_) {
        const int found = jointOf(joint);
        box->setCurrentIndex(found + 1);
        matched += found >= 0;
    }
    matched_->setText(tr("%1 of %2 joints matched").arg(matched).arg(bones_.size()));
    fills_ = false;
}

bool MotionDialog::isBusy() const {
    return job_ && job_->state() == Job::State::kRunning;
}

std::string MotionDialog::scenarioName() const {
    return scenario->currentData().toString().toStdString();
}

QComboBox* MotionDialog::boneOf(const std::string& joint) const {
    const auto found = bones_.find(joint);
    return found == bones_.end() ? nullptr : found->second;
}

void MotionDialog::refresh() {
    const std::optional<Error>& problem = unread_ ? unread_ : file_.problem;
    setProblem(problem ? coreWords(problem->text()) : QString());
    kept_->setVisible(!kept_->text().isEmpty());
    exchange_sides->setDisabledBecause(file_.motion ? QString() : tr("No person was found yet."));
    save_bones->setVisible(rows_);
    find_again->setVisible(!hints_.joints.empty() || hints_.up != figure::UpAxis::kAuto ||
                           hints_.unit != BvhUnit::kAuto || hints_.height_m > 0);
    actionButton()->setDisabledBecause(isBusy()        ? tr("The motion is being read.")
                                       : unread_       ? tr("The file cannot be read.")
                                       : file_.problem ? tr("Say which joints are which first.")
                                                       : QString());
}

void MotionDialog::accept() {
    height->interpretText();
    if (!file_.motion || isBusy())
        return;
    studio_.settings().setValue(kScenarioKey, scenario->currentData());
    KeptCorrections(studio_.settings()).keep(*file_.document, hints_);
    if (!studio_.importMotion(file_.motion, scenarioName()))
        return;
    DialogFrame::accept();
}

}  // namespace noctule::ui
