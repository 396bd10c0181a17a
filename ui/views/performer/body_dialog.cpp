// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/body_dialog.h"

#include <QComboBox>
#include <QFileInfo>
#include <algorithm>

#include "core/body/actor.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/models/part_names.h"
#include "ui/views/job_progress.h"
#include "ui/views/performer/landmark_editor.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {
namespace {

constexpr int kBodyLabels = 120, kBoneWidth = 220;
constexpr int kDialogWidth = 560, kLandmarksWidth = 1040;

bool isMain(const std::string& joint) {
    const auto& main = mainJoints();
    return std::find(main.begin(), main.end(), joint) != main.end();
}

}  // namespace

BodyDialog::BodyDialog(SharedContext& shared, QWidget* parent)
    : DialogFrame(
          tr("Body of the view"),
          tr("Views, pictures and films of this session show this body, moved by the captured motion."),
          tr("Use it"), parent),
      choose(makeButton(ButtonKind::kOutlined, tr("Choose a mesh"), "folder")),
      ours(makeButton(ButtonKind::kText, tr("Noctule's own"))),
      find_again(makeButton(ButtonKind::kText, tr("Find again"))),
      blending(new QComboBox),
      shared_(shared),
      draft_(shared.session().session().body),
      name_(new Label),
      heading_(new Label({}, TextRole::kSection, Ink::kValue, true)),
      progress_(new JobProgress) {
    setWide(kDialogWidth);
    auto* form = new FormRows(kBodyLabels);
    form->addRow(tr("Body"), name_);
    auto* buttons = new QWidget;
    auto* row = makeRow(buttons, {}, 8);
    row->addWidget(choose);
    row->addWidget(ours);
    row->addStretch();
    form->addControl(buttons);
    blending->addItem(tr("Linear, as other programs do"), static_cast<int>(Blending::kLinear));
    blending->addItem(tr("Dual quaternions, which keep the volume"),
                      static_cast<int>(Blending::kDualQuaternion));
    form->addRow(tr("Skin bends"), blending);
    content()->addWidget(form);
    content()->addWidget(progress_);
    auto* head = addRow(content(), 8);
    head->addWidget(heading_, 1);
    head->addWidget(find_again);
    auto* area = new QWidget;
    rows_column_ = makeColumn(area);
    content()->addWidget(area, 1);

    blending->setCurrentIndex(blending->findData(static_cast<int>(draft_.blending)));
    connect(blending, qOverload<int>(&QComboBox::currentIndexChanged), this,
            [this] { draft_.blending = static_cast<Blending>(blending->currentData().toInt()); });
    connect(choose, &QPushButton::clicked, this, &BodyDialog::chooseFile);
    connect(ours, &QPushButton::clicked, this, [this] { setMesh({}); });
    connect(find_again, &QPushButton::clicked, this, &BodyDialog::findAgain);
    connect(progress_, &JobProgress::ended, this, [this] {
        refresh();
        fitHeight();
    });
    readMesh();
}

void BodyDialog::chooseFile() {
    const QString path =
        FileChoice{"meshes", tr("Choose a mesh"), tr("Meshes (*.glb *.gltf *.vrm *.fbx *.dae *.obj *.ply)")}
            .toOpen(this);
    if (!path.isEmpty())
        setMesh(path);
}

void BodyDialog::setMesh(const QString& path) {
    const Session& session = shared_.session().session();
    draft_.mesh = path.isEmpty() ? std::string() : meshNameIn(session.folder, path.toStdString());
    draft_.choices = {};
    readMesh();
    if (draft_.isOurs())
        fitHeight();
}

void BodyDialog::readMesh() {
    if (reading_)
        reading_->cancel();
    mesh_.reset();
    problem_.reset();
    clearRows();
    if (!draft_.isOurs()) {
        reading_ = shared_.shownBody().read(draft_, this, [this](const ReadBody& read) { present(read); });
        progress_->follow(reading_);
    }
    refresh();
}

void BodyDialog::present(const ReadBody& read) {
    if (read.path != draft_.pathIn(shared_.session().session().folder).string())
        return;  // another was chosen meanwhile
    mesh_ = read.mesh;
    problem_ = read.problem;
    clearRows();
    if (mesh_ && mesh_->isRigged()) {
        found_ = findBoneMap(*mesh_);
        makeBoneRows();
    } else if (read.standing) {
        problem_of_found_ = draft_.choices.landmarks ? std::nullopt : read.problem;
        makeLandmarks(*read.standing);
    }
    refresh();
    fitHeight();
}

void BodyDialog::clearRows() {
    delete rows_;
    rows_ = nullptr;
    landmarks_ = nullptr;
    bones_.clear();
}

void BodyDialog::makeBoneRows() {
    QStringList names;
    for (const RigNode& node : mesh_->nodes)
        names.append(QString::fromStdString(node.name));
    const BoneMap shown = draft_.choices.bones.value_or(found_);
    auto* list = new QWidget;
    auto* grid = makeGrid(list, {0, 0, 8, 0}, 6);
    int row = 0;
    for (const std::string& joint : canonicalJointNames()) {
        auto* label = new Label(segmentName(joint), TextRole::kBody, Ink::kLabel);
        auto* bone = new QComboBox;
        bone->addItem(tr("none"));
        bone->addItems(names);
        bone->setAccessibleName(tr("Bone of %1").arg(segmentName(joint, NameCase::kInside)));
        keepSize(*bone, kBoneWidth, 0);
        const auto mapped = shown.node_of_joint.find(joint);
        bone->setCurrentIndex(mapped == shown.node_of_joint.end() ? 0 : 1 + mesh_->find(mapped->second));
        auto* consequence = (new Label({}, TextRole::kSecondary, Ink::kHint))->wrapped();
        grid->addWidget(label, row, 0);
        grid->addWidget(bone, row, 1);
        grid->addWidget(consequence, row++, 2);
        label->setBuddy(bone);
        bones_[joint] = {bone, consequence};
        connect(bone, qOverload<int>(&QComboBox::currentIndexChanged), this, &BodyDialog::takeBones);
    }
    grid->setColumnStretch(2, 1);
    showRows(new ScrollArea(list), kDialogWidth);
}

void BodyDialog::makeLandmarks(const StandingMesh& standing) {
    landmarks_ = new LandmarkEditor(standing.surface, standing.found,
                                    draft_.choices.landmarks.value_or(standing.found));
    connect(landmarks_, &LandmarkEditor::changed, this, &BodyDialog::takeLandmarks);
    showRows(landmarks_, kLandmarksWidth);
}

void BodyDialog::showRows(QWidget* rows, int dialog_width) {
    rows_ = rows;
    rows_column_->addWidget(rows);
    rows->show();  // at once, not with the next event: the dialog's height counts it
    setWide(dialog_width);
}

/// Ends below a whole row: a half one looks as if the list ended there.
void BodyDialog::fitHeight() {
    DialogFrame::fitHeight();
    layout()->activate();
    for (const ScrollArea* area : findChildren<ScrollArea*>())
        resize(width(), height() - area->cutRow_px());
}

BoneMap BodyDialog::shownBones() const {
    BoneMap map;
    for (const auto& [joint, row] : bones_)
        if (row.bone->currentIndex() > 0)
            map.node_of_joint[joint] = row.bone->currentText().toStdString();
    return map;
}

void BodyDialog::takeBones() {
    const BoneMap map = shownBones();
    draft_.choices.bones = map == found_ ? std::nullopt : std::optional(map);
    const Status checked = checkBoneMap(map, *mesh_, QFileInfo(name_->text()).fileName().toStdString());
    problem_ = checked ? std::nullopt : std::optional(checked.error());
    refresh();
}

/// Places that were set by hand may cure what was wrong with those found.
void BodyDialog::takeLandmarks() {
    const bool is_found = landmarks_->isAsFound();
    draft_.choices.landmarks = is_found ? std::nullopt : std::optional(landmarks_->places());
    problem_ = is_found ? problem_of_found_ : std::nullopt;
    refresh();
}

void BodyDialog::findAgain() {
    if (landmarks_)
        return landmarks_->findAgain();
    draft_.choices = {};
    readMesh();
}

void BodyDialog::refresh() {
    const bool reading = reading_ && reading_->state() == Job::State::kRunning;
    const QString path = QString::fromStdString(draft_.pathIn(shared_.session().session().folder).string());
    name_->setText(draft_.isOurs() ? tr("Noctule's own, in the performer's measures")
                                   : QFileInfo(path).fileName());
    name_->setToolTip(draft_.isOurs() ? QString() : path);
    ours->setVisible(!draft_.isOurs());
    heading_->setText(landmarks_ ? tr("Where its joints are") : tr("Which of its bones is which"));
    heading_->setVisible(rows_);
    find_again->setVisible(rows_ && (draft_.choices.bones || draft_.choices.landmarks));
    for (const auto& [joint, row] : bones_) {
        const bool is_mapped = row.bone->currentIndex() > 0;
        row.consequence->setText(is_mapped       ? QString()
                                 : isMain(joint) ? tr("Needed: without it the body cannot move")
                                                 : tr("Keeps its place on the bone above"));
        row.consequence->setInk(isMain(joint) ? Ink::kError : Ink::kHint);
    }
    const bool unread = !draft_.isOurs() && !mesh_ && !problem_;
    setProblem(problem_ ? coreWords(problem_->text()) : QString());
    actionButton()->setDisabledBecause(reading    ? tr("The mesh is being read.")
                                       : problem_ ? tr("This mesh cannot be used as it is.")
                                       : unread   ? tr("The mesh was not read.")
                                                  : QString());
}

QComboBox* BodyDialog::boneOf(const std::string& joint) const {
    const auto row = bones_.find(joint);
    return row == bones_.end() ? nullptr : row->second.bone;
}

void BodyDialog::accept() {
    shared_.session().setBody(draft_);
    DialogFrame::accept();
}

}  // namespace noctule::ui
