// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/review_sidebar.h"

#include <QInputDialog>
#include <QMenu>

#include "ui/models/file_choice.h"
#include "ui/views/job_progress.h"
#include "ui/views/open_take.h"
#include "ui/views/review/made_with_panel.h"
#include "ui/views/review/markers_panel.h"
#include "ui/views/review/notes_panel.h"
#include "ui/views/review/process_takes_dialog.h"
#include "ui/views/review/reference_panel.h"
#include "ui/views/review/run_list.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/session/session_commands.h"
#include "ui/views/show_folder.h"
#include "ui/views/take_list.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

/// The heading stands in from the dock's edge, the content keeps its own margins.
void addSection(QBoxLayout& into, SectionHeader* header, const std::vector<QWidget*>& parts) {
    into.addWidget(new Divider);
    auto* section = new QWidget;
    auto* column = makeColumn(section, {0, 8, 0, 12}, 4);
    addRow(column, 0, {12, 0, 12, 0})->addWidget(header);
    for (QWidget* part : parts)
        column->addWidget(part);
    into.addWidget(section);
}

}  // namespace

ReviewSidebar::ReviewSidebar(Studio& studio, FullReport& report, QWidget* parent)
    : QWidget(parent), studio_(studio), takes_(new TakeList(studio)) {
    auto* column = makeColumn(this);
    auto* heading = addRow(column, 0, {12, 4, 8, 2});
    auto* header = new SectionHeader(tr("Takes"));
    header->addTrailing(makeMenu());
    heading->addWidget(header);
    takes_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    column->addWidget(takes_);
    of_take_ = makeTakeParts(report);
    column->addWidget(new ScrollArea(of_take_), 1);
    connect(takes_, &TakeList::notesWanted, notes_, &NotesPanel::edit);
    connect(takes_, &TakeList::transferWanted, this, [this](int take, SessionModel::Transfer how) {
        SessionCommands::askForTransfer(window(), studio_, take, how);
    });
    connect(&studio.take(), &TakeDocument::opened, this, &ReviewSidebar::refresh);
    connect(&studio.take(), &TakeDocument::processingChanged, this, &ReviewSidebar::refresh);
    refresh();
}

ToolButton* ReviewSidebar::makeMenu() {
    auto* more = new ToolButton("more", tr("Session menu"));
    auto* menu = new QMenu(more);
    more->setMenu(menu);
    more->setPopupMode(QToolButton::InstantPopup);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
    return more;
}

QWidget* ReviewSidebar::makeTakeParts(FullReport& report) {
    auto* parts = new QWidget;
    auto* column = makeColumn(parts);
    results_ = new SectionHeader({});
    runs_ = new RunList(studio_, report);
    reprocess_ = makeButton(ButtonKind::kOutlined, tr("Reprocess"), "redo");
    progress_ = new JobProgress;
    auto* below = new QWidget;
    auto* below_column = makeColumn(below, {12, 4, 12, 0}, 8);
    auto* button_row = addRow(below_column);
    button_row->addWidget(reprocess_);
    button_row->addStretch();
    below_column->addWidget(progress_);
    addSection(*column, results_, {runs_, below});
    reference_ = new ReferencePanel(studio_);
    addSection(*column, new SectionHeader(tr("Reference")), {reference_});
    addSection(*column, new SectionHeader(tr("Markers")), {new MarkersPanel(studio_)});
    notes_ = new NotesPanel(studio_);
    addSection(*column, new SectionHeader(tr("Notes")), {notes_});
    addSection(*column, new SectionHeader(tr("Made with")), {new MadeWithPanel(studio_)});
    column->addStretch();
    connect(reprocess_, &QPushButton::clicked, this, &ReviewSidebar::processingWanted);
    return parts;
}

QStringList ReviewSidebar::unprocessedTakes() const {
    QStringList names;
    if (studio_.session().isOpen())
        for (const SessionTake& take : studio_.session().session().takes)
            if (!take.processed &&
                (take.state == TakeState::kComplete || take.state == TakeState::kRecovered))
                names += QString::fromStdString(take.name);
    return names;
}

void ReviewSidebar::fillMenu(QMenu& menu) {
    menu.clear();
    SessionModel& session = studio_.session();
    const bool is_open = session.isOpen();
    QAction* rename = menu.addAction(tr("Rename session"), this, [this] {
        bool accepted = false;
        const QString name =
            QInputDialog::getText(this, tr("Rename session"), tr("Name"), QLineEdit::Normal,
                                  QString::fromStdString(studio_.session().session().name), &accepted);
        if (accepted && !name.trimmed().isEmpty())
            studio_.session().renameSession(name.trimmed());
    });
    QAction* import = menu.addAction(tr("Import takes"), this, [this] {
        const QStringList paths =
            FileChoice{"last_take", tr("Import takes"), tr("Takes (*.noctule)")}.severalToOpen(this);
        if (!paths.isEmpty())
            studio_.session().importTakes(paths);
    });
    QAction* folder = menu.addAction(tr("Show in folder"), this, [this] {
        showFolder(studio_, QString::fromStdString(studio_.session().session().folder.string()));
    });
    menu.addSeparator();
    const QStringList unprocessed = unprocessedTakes();
    QAction* process = menu.addAction(tr("Process all unprocessed takes"), this, [this, unprocessed] {
        ProcessTakesDialog dialog(studio_, std::nullopt, window(), ProcessTakesDialog::With::kTheirOwn);
        dialog.tick(unprocessed);
        dialog.exec();
    });
    process->setEnabled(!unprocessed.isEmpty());
    menu.addAction(tr("Performers"), this, [this] { studio_.goTo(Step::kPerformer); })->setEnabled(is_open);
    for (QAction* action : {rename, import, folder})
        action->setEnabled(is_open);
}

void ReviewSidebar::refresh() {
    const auto overview = studio_.take().overview();
    of_take_->setVisible(overview != nullptr);
    const bool has_runs = overview && !overview->runs.empty();
    results_->setTitle(tr("Results of %1").arg(openTakeName(studio_)));
    reprocess_->setText(has_runs ? tr("Reprocess") : tr("Process"));
    Job* job = studio_.take().processing();
    reprocess_->setDisabledBecause(job && !has_runs ? tr("The take is being processed.") : QString());
    // A failure stays to be read until another take is opened.
    const QString path = studio_.take().path();
    const bool is_other_take = std::exchange(followed_, path) != path;
    if (is_other_take || (job && job != progress_->job()))
        progress_->follow(job);
}

}  // namespace noctule::ui
