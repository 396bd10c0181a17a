// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <algorithm>

#include "ui/models/file_choice.h"
#include "ui/style/words.h"
#include "ui/views/export/export_take_list.h"
#include "ui/views/open_take.h"
#include "ui/views/review_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

constexpr int kLabels = 76;
constexpr QSize kPictureSizes[] = {{1280, 720}, {1920, 1080}, {3840, 2160}, {1080, 1920}, {1080, 1080}};
constexpr double kRates[] = {24,  25, 30000.0 / 1001, 30, 48, 50, 60000.0 / 1001, 60, 90, 100, 120, 144,
                             200, 240};

QDoubleSpinBox* makeSeconds(const QString& name) {
    auto* field = new QDoubleSpinBox;
    field->setRange(0, 86400);
    field->setDecimals(2);
    field->setSuffix(ExportForm::tr(" s"));
    field->setAccessibleName(name);
    return field;
}

enum class ResultChoice { kLast, kShown, kEach, kAll };
/// What several programs want of one take at once.
/// All four in one line.
constexpr std::pair<ExportFormat, const char*> kAlso[] = {{ExportFormat::kFbx, "FBX"},
                                                          {ExportFormat::kGlb, "GLB"},
                                                          {ExportFormat::kBvh, "BVH"},
                                                          {ExportFormat::kCsv, "CSV"}};

template <class T>
void chooseData(QComboBox* box, const T& value) {
    const int index = box->findData(QVariant::fromValue(value));
    box->setCurrentIndex(std::max(0, index));
}

}  // namespace

ExportForm::ExportForm(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      range(new QComboBox),
      format(new QComboBox),
      frames(new QComboBox),
      root(new QComboBox),
      unit(new QComboBox),
      names(new QComboBox),
      body(new QComboBox),
      size(new QComboBox),
      camera(new QComboBox),
      run(new QComboBox),
      angles(new QCheckBox(tr("Joint angles too, in degrees"))),
      one_file(new QCheckBox(tr("One file with all takes or performers"))),
      lock_feet(new QCheckBox(tr("Standing feet keep their place"))),
      name_pattern(new QLineEdit),
      try_one_frame(makeButton(ButtonKind::kOutlined, tr("Write one frame and check"))),
      review_(review) {
    auto* column = makeColumn(this, {20, 12, 20, 12}, 12);
    makeTakes();
    column->addWidget(makeWhat());
    column->addWidget(new Divider);
    column->addWidget(makeWhere());
    column->addStretch(1);
    FormRows::alignLabels(rows_);
    for (QComboBox* box : {range, format, frames, root, unit, names, body, size, camera})
        connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportForm::read);
    connect(run, qOverload<int>(&QComboBox::currentIndexChanged), this, &ExportForm::read);
    for (QCheckBox* box : {angles, one_file, lock_feet})
        connect(box, &QCheckBox::toggled, this, &ExportForm::read);
    connect(name_pattern, &QLineEdit::textChanged, this, &ExportForm::read);
    for (QDoubleSpinBox* field : {own_from_, own_to_})
        connect(field, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ExportForm::read);
    connect(takes_, &ExportTakeList::changed, this, &ExportForm::changed);
    connect(try_one_frame, &QPushButton::clicked, this, &ExportForm::tryWanted);
    connect(&review.take(), &TakeDocument::runsChanged, this, &ExportForm::refresh);
    setSettings({});
}

FormRows* ExportForm::makeRows() {
    rows_.push_back(new FormRows(kLabels));
    return rows_.back();
}

void ExportForm::makeTakes() {
    takes_part_ = new QWidget(this);
    auto* column = makeColumn(takes_part_, {20, 12, 20, 16}, 8);
    column->addWidget(new SectionHeader(tr("Takes")));
    takes_ = new ExportTakeList(review_);
    column->addWidget(takes_);
    FormRows* rows = makeRows();
    run->addItem(tr("As shown in Review"), static_cast<int>(ResultChoice::kShown));
    run->addItem(tr("Last of each take"), static_cast<int>(ResultChoice::kLast));
    run->addItem(tr("Chosen for each take"), static_cast<int>(ResultChoice::kEach));
    run->addItem(tr("All of each take"), static_cast<int>(ResultChoice::kAll));
    rows->addRow(tr("Result"), run);
    column->addWidget(rows);
}

QWidget* ExportForm::makeWhat() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {}, 8);
    column->addWidget(new SectionHeader(tr("What and how")));
    FormRows* rows = makeRows();
    addMotionRows(*rows);
    addFigureRows(*rows);
    column->addWidget(rows);
    column->addWidget(pictures_ = makePictures());
    return part;
}

/// Which part of the motion, in what, at what rate.
void ExportForm::addMotionRows(FormRows& rows) {
    range->addItem(tr("In to out of each take"), static_cast<int>(ExportRange::kInToOut));
    range->addItem(tr("Whole takes"), static_cast<int>(ExportRange::kWholeTake));
    range->addItem(tr("Chosen seconds"), static_cast<int>(ExportRange::kOwn));
    rows.addRow(tr("Range"), range);
    own_range_ = new QWidget;
    auto* own = makeRow(own_range_, {}, 8);
    own_from_ = makeSeconds(tr("First second"));
    own_to_ = makeSeconds(tr("Last second"));
    own->addWidget(own_from_, 1);
    own->addWidget(new Label(tr("to"), TextRole::kSecondary, Ink::kLabel));
    own->addWidget(own_to_, 1);
    rows.addControl(own_range_);
    for (const ExportFormat each :
         {ExportFormat::kFbx, ExportFormat::kGlb, ExportFormat::kBvh, ExportFormat::kMot, ExportFormat::kSto,
          ExportFormat::kCsv, ExportFormat::kVideo, ExportFormat::kPng})
        format->addItem(formatName(each), static_cast<int>(each));
    rows.addRow(tr("Format"), format);
    rows.addRow(tr("Also as"), makeAlso());
    rows.addControl(one_file);
    one_file->setToolTip(
        tr("Each take is an animation under its name; {take} in the file name becomes the session’s "
           "name. Of one take, each performer is a character of its own."));
    for (const double rate : kRates)
        frames->addItem(tr("%1 per second").arg(rateText(rate)), rate);
    rows.addRow(tr("Frames"), frames);
    root->addItem(tr("Moves as captured"), static_cast<int>(RootMotion::kMoving));
    root->addItem(tr("Stays in place"), static_cast<int>(RootMotion::kInPlace));
    root->addItem(tr("In place, facing +Z"), static_cast<int>(RootMotion::kHeading));
    rows.addRow(tr("Root"), root);
}

/// What moves so, and how the file writes it down.
void ExportForm::addFigureRows(FormRows& rows) {
    unit->addItem(tr("Centimetres"), 0.01);
    unit->addItem(tr("Metres"), 1.0);
    not_of_pictures_.push_back(rows.addRow(tr("Unit"), unit));
    names->addItem(tr("Common (Hips, Spine, LeftArm)"), static_cast<int>(JointNames::kOwn));
    names->addItem(tr("HumanIK"), static_cast<int>(JointNames::kHumanIk));
    not_of_pictures_.push_back(rows.addRow(tr("Names"), names));
    not_of_pictures_.insert(not_of_pictures_.end(), {unit, names});
    body->addItem(tr("Skinned, in the performer's measures"), static_cast<int>(ExportBody::kOurs));
    body->addItem(tr("Skeleton alone"), static_cast<int>(ExportBody::kSkeleton));
    body->addItem(tr("The session's body"), static_cast<int>(ExportBody::kSessions));
    rows.addRow(tr("Body"), body);
    rows.addControl(lock_feet);
    lock_feet->setToolTip(
        tr("On a body of other proportions feet would slide; its legs bend a little instead."));
    rows.addControl(angles);
}

QWidget* ExportForm::makeAlso() {
    auto* boxes = new QWidget;
    auto* row = makeRow(boxes, {}, 8);
    for (const auto& [each, letters] : kAlso) {
        auto* box = new QCheckBox(letters);
        box->setAccessibleName(formatName(each));
        box->setToolTip(tr("Each take is written in this format too."));
        connect(box, &QCheckBox::toggled, this, &ExportForm::read);
        row->addWidget(box);
        also[each] = box;
    }
    row->addStretch();
    return boxes;
}

QWidget* ExportForm::makePictures() {
    FormRows* rows = makeRows();
    for (const QSize& each : kPictureSizes)
        size->addItem(tr("%1 × %2").arg(each.width()).arg(each.height()), each);
    rows->addRow(tr("Size"), size);
    camera->addItem(tr("Stands in front"), static_cast<int>(CameraMove::kFront));
    camera->addItem(tr("Goes along"), static_cast<int>(CameraMove::kFollow));
    camera->addItem(tr("Goes once around"), static_cast<int>(CameraMove::kTurn));
    rows->addRow(tr("Camera"), camera);
    return rows;
}

QWidget* ExportForm::makeWhere() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {}, 8);
    column->addWidget(new SectionHeader(tr("Where")));
    FormRows* rows = makeRows();
    folder_ = makeButton(ButtonKind::kOutlined, {}, "folder");
    rows->addRow(tr("Folder"), folder_);
    rows->addRow(tr("File name"), name_pattern);
    name_pattern->setToolTip(
        tr("{take} {fps} {performer} {run} {date} are filled in. A name that you type is kept "
           "for all presets until you clear the field."));
    preview_ = rows->addHint({});
    rows->addRow(tr("Try first"), try_one_frame);
    column->addWidget(rows);
    connect(folder_, &QPushButton::clicked, this, &ExportForm::chooseFolder);
    return part;
}

void ExportForm::setSettings(const ExportSettings& settings) {
    const QScopedValueRollback<bool> quiet(setting_, true);
    settings_ = settings;
    chooseData(range, static_cast<int>(settings.range));
    chooseData(frames, settings.frames_per_second);
    chooseData(root, static_cast<int>(settings.root));
    chooseData(format, static_cast<int>(settings.format));
    chooseData(unit, settings.metres_per_unit);
    chooseData(names, static_cast<int>(settings.names));
    chooseData(body, static_cast<int>(settings.body));
    chooseData(size, QSize(settings.width_px, settings.height_px));
    chooseData(camera, static_cast<int>(settings.camera));
    for (auto box = also.begin(); box != also.end(); ++box)
        box.value()->setChecked(settings.also.count(box.key()) > 0);
    angles->setChecked(settings.angles);
    one_file->setChecked(settings.one_file);
    lock_feet->setChecked(settings.lock_feet);
    preset_name_ = settings.name_pattern;
    name_pattern->setPlaceholderText(preset_name_);
    settings_.name_pattern = typed_name_.isEmpty() ? preset_name_ : typed_name_;
    name_pattern->setText(settings_.name_pattern);
    own_from_->setValue(settings.own_from_s);
    own_to_->setValue(settings.own_to_s > 0 ? settings.own_to_s : review_.time().duration());
    refresh();
}

ExportSettings ExportForm::ofPreset() const {
    ExportSettings settings = settings_;
    settings.name_pattern = preset_name_;
    return settings;
}

void ExportForm::read() {
    if (setting_)
        return;
    settings_.range = static_cast<ExportRange>(range->currentData().toInt());
    settings_.frames_per_second = frames->currentData().toDouble();
    settings_.root = static_cast<RootMotion>(root->currentData().toInt());
    settings_.format = static_cast<ExportFormat>(format->currentData().toInt());
    if (unit->isEnabled())  // else it shows the only one there is
        settings_.metres_per_unit = unit->currentData().toDouble();
    settings_.names = static_cast<JointNames>(names->currentData().toInt());
    settings_.body = static_cast<ExportBody>(body->currentData().toInt());
    settings_.width_px = size->currentData().toSize().width();
    settings_.height_px = size->currentData().toSize().height();
    settings_.camera = static_cast<CameraMove>(camera->currentData().toInt());
    settings_.also.clear();
    for (auto box = also.begin(); box != also.end(); ++box)
        if (box.value()->isChecked())
            settings_.also.insert(box.key());
    settings_.angles = angles->isChecked();
    settings_.one_file = one_file->isChecked();
    settings_.lock_feet = lock_feet->isChecked();
    const QString name = name_pattern->text();
    typed_name_ = name == preset_name_ ? QString() : name;
    settings_.name_pattern = name.isEmpty() ? preset_name_ : name;
    settings_.own_from_s = own_from_->value();
    settings_.own_to_s = own_to_->value();
    refresh();
    emit changed();
}

void ExportForm::refresh() {
    own_range_->setVisible(settings_.range == ExportRange::kOwn);
    const QString name = formatName(settings_.format);
    const auto offer = [](QComboBox* box, bool is_offered, const QString& why_not) {
        box->setEnabled(is_offered);
        box->setToolTip(is_offered ? QString() : why_not);
    };
    const std::vector<ExportFormat> formats = formatsOf(settings_);
    const auto offers = [&](bool (*has)(ExportFormat)) {
        return std::any_of(formats.begin(), formats.end(), has);
    };
    const bool moves = std::any_of(formats.begin(), formats.end(),
                                   [](ExportFormat each) { return each != ExportFormat::kPng; });
    for (QComboBox* box : {range, frames})
        offer(box, moves, tr("The frame at Review’s time cursor; of other takes one in the middle."));
    offer(unit, offers(hasUnit), tr("%1: always in metres.").arg(name));
    offer(names, offers(hasNames), tr("%1: names of its own.").arg(name));
    offer(body, offers(showsBody), tr("%1: has no place for a body.").arg(name));
    {
        const QScopedValueRollback<bool> quiet(setting_, true);
        chooseData(unit, offers(hasUnit) ? settings_.metres_per_unit : 1.0);
    }
    for (auto box = also.begin(); box != also.end(); ++box)
        box.value()->setDisabled(box.key() == settings_.format);
    angles->setVisible(settings_.format == ExportFormat::kCsv);
    lock_feet->setVisible(offers(showsBody) && settings_.body == ExportBody::kSessions);
    one_file->setVisible(offers(holdsSeveral));
    pictures_->setVisible(isPicture(settings_.format));
    for (QWidget* part : not_of_pictures_)
        part->setVisible(!isPicture(settings_.format));
    const auto choice = static_cast<ResultChoice>(run->currentData().toInt());
    takes_->setResultsShown(choice == ResultChoice::kEach || choice == ResultChoice::kAll,
                            choice == ResultChoice::kEach);
    refreshWhere();
    const auto overview = review_.take().overview();
    const int shown = review_.take().shownRun();
    run->setItemText(0, overview && shown >= 0
                            ? tr("Shown: %1").arg(numberedTitle(overview->runs[static_cast<size_t>(shown)]))
                            : tr("As shown in Review"));
}

void ExportForm::refreshWhere() {
    const bool is_open = review_.shared().session().isOpen();
    const QString folder =
        is_open ? exportFolder(review_.shared().session().session(), settings_) : settings_.folder;
    const QFileInfo place(folder);
    folder_->setText(folder.isEmpty() ? tr("exports of the session")
                                      : tr("%1/%2").arg(place.dir().dirName(), place.fileName()));
    folder_->setToolTip(QDir::toNativeSeparators(folder));
}

bool ExportForm::sendsAllResults() const {
    return run->currentData().toInt() == static_cast<int>(ResultChoice::kAll);
}

QStringList ExportForm::resultsOf(const QString& take) const {
    const auto choice = static_cast<ResultChoice>(run->currentData().toInt());
    if (choice == ResultChoice::kEach)
        return {takes_->chosenResult(take)};
    if (choice == ResultChoice::kAll)
        return takes_->resultNames(take);
    const TakeDocument& open = review_.take();
    const bool is_open = open.isOpen() && openTakeName(review_) == take;
    if (choice == ResultChoice::kShown && is_open && open.shownRun() >= 0)
        return {QString::fromStdString(open.overview()->runs[static_cast<size_t>(open.shownRun())].run.name)};
    const SessionModel& session = review_.shared().session();
    const int index = session.isOpen() ? session.session().findTake(take.toStdString()) : -1;
    if (choice != ResultChoice::kShown || index < 0)
        return {QString()};
    return {QString::fromStdString(session.session().takes[static_cast<size_t>(index)].shown_result)};
}

void ExportForm::chooseFolder() {
    const QString start = review_.shared().session().isOpen()
                              ? exportFolder(review_.shared().session().session(), settings_)
                              : QString();
    const QString folder =
        FileChoice{.kind = "exports", .title = tr("Folder for exported files"), .at = start}.folder(this);
    if (folder.isEmpty())
        return;
    const bool is_usual =
        review_.shared().session().isOpen() &&
        QDir(folder) ==
            QDir(QString::fromStdString(review_.shared().session().session().exportsFolder().string()));
    settings_.folder = is_usual ? QString() : folder;
    refresh();
    emit changed();
}

QStringList ExportForm::takes() const {
    return takes_->ticked();
}

void ExportForm::setTakes(const QStringList& chosen) {
    takes_->tick(chosen);
}

QString ExportForm::preview() const {
    return preview_->text();
}

void ExportForm::setPreview(const QString& words, bool is_problem) {
    preview_->setInk(is_problem ? Ink::kError : Ink::kHint);
    preview_->setText(words);
}

}  // namespace noctule::ui
