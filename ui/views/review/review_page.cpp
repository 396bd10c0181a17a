// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/review_page.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QScrollArea>
#include <QStackedWidget>

#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/report/full_report.h"
#include "ui/views/report/report_panel.h"
#include "ui/views/report/report_view.h"
#include "ui/views/review/choice_row.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_actions.h"
#include "ui/views/review/review_center.h"
#include "ui/views/review/review_sidebar.h"
#include "ui/views/review/take_range.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/empty_state.h"

namespace noctule::ui {

ReviewPage::ReviewPage(Studio& studio, QWidget* parent)
    : Page(parent),
      studio_(studio),
      full_report_(new FullReport(studio, this)),
      sidebar_(new ReviewSidebar(studio, *full_report_, this)),
      report_panel_(new ReportPanel(studio, this)),
      center_(new ReviewCenter(studio)),
      report_view_(new ReportView(studio, *full_report_)),
      empty_(new EmptyState(
          tr("A take will be seen here: its body, the confidence of its ranges and its curves."),
          tr("Try the virtual suit"), "body")),
      unreadable_(new EmptyState({}, tr("Save what can be read"))),
      stack_(new QStackedWidget),
      actions_(nullptr) {
    makeColumn(this)->addWidget(stack_);
    for (QWidget* content : {static_cast<QWidget*>(center_), static_cast<QWidget*>(report_view_),
                             static_cast<QWidget*>(empty_), static_cast<QWidget*>(unreadable_)})
        stack_->addWidget(content);
    setFocusPolicy(Qt::ClickFocus);
    sidebar_->hide();
    report_panel_->hide();
    for (QWidget* dock : {static_cast<QWidget*>(sidebar_), static_cast<QWidget*>(report_panel_)}) {
        dock->installEventFilter(this);
        // They would scroll sideways with the arrows that step frames.
        for (QScrollArea* area : dock->findChildren<QScrollArea*>())
            area->installEventFilter(this);
    }
    new TakeRange(studio, this);
    actions_ = new ReviewActions(studio, *this);

    connect(sidebar_, &ReviewSidebar::processingWanted, this, &ReviewPage::reprocess);
    connect(report_panel_, &ReportPanel::processingWanted, this, &ReviewPage::reprocess);
    connect(report_panel_, &ReportPanel::gyroscopesWanted, this, &ReviewPage::reprocessWithGyroscopes);
    connect(report_panel_, &ReportPanel::fullReportWanted, this, &ReviewPage::openFullReport);
    connect(report_panel_, &ReportPanel::exportWanted, this, [this] { studio_.goTo(Step::kExport); });
    connect(report_view_, &ReportView::closed, this, &ReviewPage::closeFullReport);
    connect(empty_, &EmptyState::activated, this, [this] { studio_.tryVirtualSuit(); });
    connect(unreadable_, &EmptyState::activated, this,
            [this] { studio_.saveReadable(studio_.unreadable().path); });
    connect(&studio.take(), &TakeDocument::opened, this, &ReviewPage::refresh);
    connect(&studio, &Studio::tornTake, this, &ReviewPage::refresh);
    connect(&studio.session(), &SessionModel::takeRenamed, this, &ReviewPage::refresh);
    connect(&studio.session(), &SessionModel::currentTakeChanged, this, &ReviewPage::refresh);
    connect(&studio.take(), &TakeDocument::runsChanged, this, &ReviewPage::compareWithEarlier);
    connect(&studio.session(), &SessionModel::opened, this, &ReviewPage::tellTitles);
    connect(&studio.session(), &SessionModel::changed, this, &ReviewPage::tellTitles);
    refresh();
    tellTitles();
}

ReviewPage::~ReviewPage() = default;

ReviewSidebar& ReviewPage::sidebar() {
    return *sidebar_;
}

ReportPanel& ReviewPage::reportPanel() {
    return *report_panel_;
}

QWidget* ReviewPage::leftDock() {
    return sidebar_;
}

QWidget* ReviewPage::rightDock() {
    return report_panel_;
}

QList<QAction*> ReviewPage::menuActions() const {
    return actions_->all();
}

void ReviewPage::enter() {
    setFocus();
}

bool ReviewPage::showsFullReport() const {
    return stack_->currentWidget() == report_view_;
}

void ReviewPage::openFullReport() {
    if (!studio_.take().isOpen() || studio_.take().shownRun() < 0)
        return;
    stack_->setCurrentWidget(report_view_);
    report_view_->enter();
}

void ReviewPage::closeFullReport() {
    refresh();
    setFocus();
}

void ReviewPage::tellTitles() {
    const SessionModel& session = studio_.session();
    const QString left = session.isOpen() ? QString::fromStdString(session.session().name) : tr("No session");
    if (left != leftDockTitle())
        setDockTitles(left, tr("Report"));
}

void ReviewPage::refresh() {
    const bool is_open = studio_.take().isOpen();
    const bool stays =
        is_open && showsFullReport() && studio_.take().shownRun() >= 0 && sender() != report_view_;
    if (!stays)
        stack_->setCurrentWidget(is_open ? center_ : emptyContent());
}

QWidget* ReviewPage::emptyContent() {
    const auto& [path, why] = studio_.unreadable();
    if (path.isEmpty())
        return empty_;
    unreadable_->setSentence(tr("%1 is damaged: %2 What can be read goes into a new take.", "take, why")
                                 .arg(QFileInfo(path).completeBaseName(), withFullStop(why)));
    return unreadable_;
}

void ReviewPage::reprocess() {
    const auto overview = studio_.take().overview();
    if (!overview)
        return;
    ReprocessDialog dialog(studio_, *overview, window());
    askHow(dialog);
}

void ReviewPage::reprocessWithGyroscopes() {
    const auto overview = studio_.take().overview();
    if (!overview)
        return;
    ReprocessDialog dialog(studio_, *overview, window());
    dialog.gyroscopes->setChecked(true);
    askHow(dialog);
}

void ReviewPage::askHow(ReprocessDialog& dialog) {
    if (dialog.exec() == QDialog::Accepted)
        process(dialog.request());
}

void ReviewPage::process(const ProcessRequest& request) {
    const auto overview = studio_.take().overview();
    const int shown = studio_.take().shownRun();
    earlier_.reset();
    if (shown >= 0)
        earlier_ = Earlier{overview->runs[static_cast<size_t>(shown)].run.run, overview->runs.size()};
    studio_.process(request);
}

void ReviewPage::compareWithEarlier() {
    const auto overview = studio_.take().overview();
    if (!overview || !earlier_ || overview->runs.size() <= earlier_->count)
        return;
    const int64_t earlier = std::exchange(earlier_, std::nullopt)->run;
    for (size_t i = 0; i < overview->runs.size(); ++i)
        if (overview->runs[i].run.run == earlier && static_cast<int>(i) != studio_.take().shownRun())
            studio_.take().setComparedRun(static_cast<int>(i));
}

bool ReviewPage::handleKey(const QKeyEvent& event) {
    return !showsFullReport() && actions_->handleKey(event);
}

void ReviewPage::keyPressEvent(QKeyEvent* event) {
    if (!handleKey(*event))
        Page::keyPressEvent(event);
}

/// Keys that nothing in a dock wanted come to its scroll areas and to itself last.
bool ReviewPage::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::KeyPress && handleKey(*static_cast<QKeyEvent*>(event)))
        return true;
    return Page::eventFilter(object, event);
}

}  // namespace noctule::ui
