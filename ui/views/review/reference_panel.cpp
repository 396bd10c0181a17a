// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/reference_panel.h"

#include <QDialog>
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>
#include <cmath>

#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/open_take.h"
#include "ui/views/review/performer_switch.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

struct Attached {
    AttachSummary summary;
    std::vector<std::string> warnings;
    AttachedChange change;
};

std::shared_ptr<const AttachedMotion> held(Result<AttachedMotion> motion) {
    return motion ? std::make_shared<const AttachedMotion>(std::move(*motion)) : nullptr;
}

/// With its way back, unless what it replaces cannot be read.
Result<Attached> attachTo(const std::string& take_path, const AttachChoice& choice,
                          const JobContext& context) {
    Attached attached;
    auto request = readAttachment(choice.path.toStdString(), attached.warnings, context);
    if (!request)
        return request.error();
    request->take_path = take_path;
    request->as = choice.as;
    request->shift_s = choice.shift_s;
    request->overwrite = choice.overwrite;
    attached.change.before = held(attachedMotion(take_path, choice.as, context));
    auto summary = attachReference(*request, context);
    if (!summary)
        return summary.error();
    attached.change.after = held(attachedMotion(take_path, choice.as, {}));
    attached.summary = std::move(*summary);
    attached.warnings.insert(attached.warnings.end(), attached.summary.warnings.begin(),
                             attached.summary.warnings.end());
    return attached;
}

/// Names of files that can be attached, as a file dialog has them.
const QString& namePatterns() {
    static const QString patterns = "*.bvh *.fbx *.glb *.gltf *.vrm *.dae *.c3d *.trc *.csv";
    return patterns;
}

QString motionFile(const QMimeData& dragged) {
    for (const QUrl& url : dragged.urls())
        if (QDir::match(namePatterns().split(' '), QFileInfo(url.toLocalFile()).fileName()))
            return url.toLocalFile();
    return {};
}

/// Steps of one session cannot be undone in another.
std::string folderOf(const SessionModel& session) {
    return session.isOpen() ? session.session().folder.string() : std::string();
}

}  // namespace

ReferencePanel::ReferencePanel(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      name_(new ElidedLabel),
      detail_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      present_(new QWidget),
      absent_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      attach_(makeButton(ButtonKind::kText, tr("Attach"), "link")),
      compare_(new ToolButton("ghost", tr("Compare with the reference"))),
      progress_(new JobProgress) {
    setAcceptDrops(true);
    auto* column = makeColumn(this, {12, 0, 12, 0}, 4);
    auto* rows = makeGrid(present_, {}, 4);
    rows->setColumnStretch(0, 1);
    rows->addWidget(name_, 0, 0);
    rows->addWidget(compare_, 0, 1);
    rows->addWidget(detail_->wrapped(), 1, 0, 1, 2);
    name_->setElideMode(Qt::ElideMiddle);
    column->addWidget(present_);
    column->addWidget(absent_->wrapped());
    column->addWidget(progress_);
    auto* buttons = addRow(column, 4);
    buttons->addWidget(attach_);
    buttons->addStretch();
    absent_->setText(tr("A motion, markers or positions of another system, to compare with."));
    compare_->setCheckable(true);
    connect(attach_, &QPushButton::clicked, this, &ReferencePanel::chooseFile);
    connect(compare_, &QToolButton::clicked, this, [this] {
        TakeDocument& take = review_.take();
        take.setComparedRun(take.comparedRun() == TakeDocument::kReference ? -1 : TakeDocument::kReference);
    });
    connect(&review.take(), &TakeDocument::opened, this, [this] {
        if (std::exchange(attached_to_, review_.take().path()) != review_.take().path())
            progress_->follow(nullptr);  // what failed there says nothing of this take
        readFacts();
    });
    connect(&review.take(), &TakeDocument::runsChanged, this, &ReferencePanel::refresh);
    connect(progress_, &JobProgress::ended, this, &ReferencePanel::refresh);
    readFacts();
}

void ReferencePanel::readFacts() {
    facts_.reset();
    ++ticket_;
    const auto overview = review_.take().overview();
    if (overview && overview->has_reference)
        review_.shared().jobs().start<ReferenceFacts>(
            tr("Looking at the reference"),
            [path = overview->path](const JobContext&) { return referenceFacts(path); },
            [self = QPointer(this), ticket = ticket_](Result<ReferenceFacts> facts) -> QString {
                if (self && self->ticket_ == ticket && facts) {
                    self->facts_ = *facts;
                    self->refresh();
                }
                return {};
            },
            Jobs::Loudness::kQuiet);
    refresh();
}

void ReferencePanel::refresh() {
    const auto overview = review_.take().overview();
    const bool has = overview && overview->has_reference;
    present_->setVisible(has);
    absent_->setVisible(!has);
    attach_->setText(has ? tr("Replace") : tr("Attach"));
    attach_->setDisabledBecause(whyNotAttached());
    compare_->setChecked(review_.take().comparedRun() == TakeDocument::kReference);
    if (has)
        showFacts();
}

void ReferencePanel::showFacts() {
    const bool simulated = review_.take().overview()->reference_kind == "simulated";
    const QString name = facts_ ? QString::fromStdString(facts_->name) : QString();
    name_->setText(!name.isEmpty() ? name
                   : simulated     ? tr("Truth of the simulation")
                                   : tr("Attached reference"));
    if (!facts_) {
        detail_->setText(tr("in the take"));
        return;
    }
    const QString matched = tr("%1 of %2 joints matched").arg(facts_->matched).arg(facts_->joints);
    const QString shift = facts_->shift_s ? numberText(*facts_->shift_s, 3) + QChar(0x00A0) + "s" : QString();
    detail_->setText(shift.isEmpty() ? matched : tr("aligned by %1, %2").arg(shift, matched));
}

/// Empty: a reference can be attached.
QString ReferencePanel::whyNotAttached() const {
    const TakeDocument& take = review_.take();
    if (!take.isOpen())
        return tr("Open a take first.");
    if (progress_->isRunning())
        return tr("A motion is being attached.");
    return take.subject() > 0 ? tr("A reference is attached to %1, the first performer of the take.")
                                    .arg(performerName(take, 0))
                              : QString();
}

void ReferencePanel::chooseFile() {
    if (!whyNotAttached().isEmpty())
        return;
    const QString path = FileChoice{"references", tr("Choose a recording of the same performance"),
                                    tr("Motions and positions (%1)").arg(namePatterns())}
                             .toOpen(this);
    if (!path.isEmpty())
        ask(path);
}

void ReferencePanel::ask(const QString& path) {
    if (!whyNotAttached().isEmpty())
        return;
    AttachDialog dialog(*review_.take().overview(), path, window());
    if (dialog.exec() == QDialog::Accepted)
        attach(dialog.choice());
}

void ReferencePanel::attach(const AttachChoice& choice) {
    const QString take_path = review_.take().path(), file = QFileInfo(choice.path).fileName(),
                  take = openTakeName(review_);
    SessionModel& session = review_.shared().session();
    Job* job = review_.shared().jobs().start<Attached>(
        {tr("Attaching %1 to %2"), file, take},
        [path = take_path.toStdString(), choice](const JobContext& context) {
            return attachTo(path, choice, context);
        },
        [self = QPointer(this), take_path, what = tr("Attach %1 to %2").arg(file, take),
         folder = folderOf(session),
         kept = session.keepInPlace(take_path)](Result<Attached> attached) -> QString {
            if (!attached)
                return {};
            const bool can_be_undone = attached->change.before && attached->change.after;
            if (self && can_be_undone && folder == folderOf(self->review_.shared().session()))
                self->review_.changes().pushWritten(what, take_path, attached->change);
            if (self && self->review_.take().path() == take_path)
                self->review_.take().reload(false);
            QString words = tr("Aligned by %1, %2 frames lie within the take.")
                                .arg(numberText(attached->summary.shift_s, 3) + QChar(0x00A0) + "s",
                                     countText(attached->summary.rows));
            for (const std::string& warning : attached->warnings)
                words += " " + coreWords(warning);
            if (!can_be_undone)
                words += " " + tr("This cannot be undone.");
            return words;
        });
    progress_->follow(job);
    refresh();
}

void ReferencePanel::dragEnterEvent(QDragEnterEvent* event) {
    if (whyNotAttached().isEmpty() && !motionFile(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void ReferencePanel::dropEvent(QDropEvent* event) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
    const QString path = motionFile(*event->mimeData());
    QTimer::singleShot(0, this, [this, path] { ask(path); });  // the drop ends before the dialog begins
}

}  // namespace noctule::ui
