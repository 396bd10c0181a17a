// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/main_window.h"

#include <QPainter>
#include <QStackedWidget>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/main_window/jobs_panel.h"
#include "ui/main_window/noticed_page.h"
#include "ui/main_window/pages.h"
#include "ui/main_window/panel_tab.h"
#include "ui/main_window/panel_walk.h"
#include "ui/main_window/session_notices.h"
#include "ui/main_window/side_docks.h"
#include "ui/main_window/status_line.h"
#include "ui/main_window/top_bar.h"
#include "ui/main_window/undo_keys.h"
#include "ui/main_window/window_menus.h"
#include "ui/robot/robot_drive.h"
#include "ui/scene/scene_canvas.h"
#include "ui/style/theme.h"
#include "ui/views/page.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/window_place.h"

namespace noctule::ui {
namespace {

constexpr const char* kGeometry = "window/geometry";
constexpr const char* kMaximised = "window/maximised";
constexpr int kWhenIdle_ms = 300;

const std::map<Step, Command>& commandOfStep() {
    static const std::map<Step, Command> commands{
        {Step::kStart, Command::kStepStart},         {Step::kConnect, Command::kStepConnect},
        {Step::kCalibrate, Command::kStepCalibrate}, {Step::kRecord, Command::kStepRecord},
        {Step::kReview, Command::kStepReview},       {Step::kExport, Command::kStepExport},
        {Step::kRobot, Command::kStepRobot}};
    return commands;
}

/// What pages stand on: one step darker than docks.
class Backdrop : public QWidget {
protected:
    void paintEvent(QPaintEvent*) override { QPainter(this).fillRect(rect(), Theme::get().tokens().bg); }
};

/// Takes what docks and bars leave: a page that wanted more would push the right dock out of the window.
/// Pages fold and scroll instead.
class PageStack : public QStackedWidget {
public:
    QSize minimumSizeHint() const override { return {Theme::get().px(320), Theme::get().px(200)}; }
};

}  // namespace

MainWindow::MainWindow(Studio& studio, QWidget* parent)
    : QMainWindow(parent),
      studio_(studio),
      recent_(studio.settings(), studio.jobs()),
      actions_(new WindowActions(*this)),
      robot_(new RobotDrive(studio, this)) {
    setObjectName("main_window");
    setAcceptDrops(true);
    setAnimated(Theme::get().motion_ms(1) > 0);
    setDockOptions(AllowNestedDocks | (isAnimated() ? AnimatedDocks : DockOptions{}));
    buildParts();
    new UndoKeys(this);
    connect(qApp, &QApplication::focusChanged, this, &MainWindow::keepFocusOnPage);
    connectActions();
    connectSteps();
    connectStudio();
    connectSuit();
    restoreGeometryKept();
    if (studio_.session().isOpen())
        onSessionOpened();
    goTo(Step::kStart);
    // A first take need wait neither for the driver nor for its page, the largest of all.
    QTimer::singleShot(kWhenIdle_ms, this, [] { SceneCanvas::missing(); });
    QTimer::singleShot(2 * kWhenIdle_ms, this, [this] { page(Step::kReview); });
}

MainWindow::~MainWindow() {
    docks_->keep();
    for (const auto& [step, page] : pages_)
        docks_->release(*page);
    // It uses the robot, which goes with the window.
    if (const auto robot = pages_.find(Step::kRobot); robot != pages_.end())
        delete robot->second;
}

void MainWindow::buildParts() {
    actions_->adopt(Command::kUndo, studio_.session().undoStack().createUndoAction(this, tr("Undo")),
                    {QKeySequence("Ctrl+Z")});
    actions_->adopt(Command::kRedo, studio_.session().undoStack().createRedoAction(this, tr("Redo")),
                    {QKeySequence("Ctrl+Shift+Z")});

    top_bar_ = new TopBar;
    menus_ = new WindowMenus(*actions_, recent_, top_bar_->menuBar());
    top_bar_->fold(menus_->all());
    setMenuWidget(top_bar_);

    docks_ = new SideDocks(*this, studio_.settings());
    menus_->addPanels({&docks_->left(), &docks_->right()});
    setCentralWidget(makeCentre());

    status_ = new StatusLine(studio_);
    addBottomLine();
    jobs_panel_ = new JobsPanel(studio_.jobs(), this);
}

/// Notices above the page; above them the tabs of docks that gave it their room.
QWidget* MainWindow::makeCentre() {
    notices_ = new Notices;
    session_notices_ = new SessionNotices(studio_, *notices_, this);
    stack_ = new PageStack;
    middle_ = new NoticedPage(notices_, stack_);
    auto* centre = new Backdrop;
    auto* column = makeColumn(centre);
    auto* tabs = addRow(column, 0);
    tabs->addWidget(&docks_->leftTab());
    tabs->addStretch();
    tabs->addWidget(&docks_->rightTab());
    column->addWidget(middle_, 1);
    return centre;
}

/// As a tool bar and not as QStatusBar, which adds margins that cannot be taken off.
void MainWindow::addBottomLine() {
    auto* bar = new QToolBar(tr("Status"));
    bar->setObjectName("status");
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->toggleViewAction()->setVisible(false);
    bar->addWidget(status_);
    addToolBar(Qt::BottomToolBarArea, bar);
    const auto trim = [bar] { bar->layout()->setContentsMargins(0, 0, 0, 0); };
    trim();
    connect(&Theme::get(), &Theme::changed, bar, trim);
}

Page& MainWindow::page(Step step) {
    Page*& page = pages_[step];
    if (!page) {
        page = makePage(step);
        page->setAccessibleName(page->title());  // a page can take the focus itself
        stack_->addWidget(page);
    }
    return *page;
}

void MainWindow::goTo(Step step) {
    if (const auto before = pages_.find(step_); before != pages_.end() && step != step_)
        before->second->leave();
    Page& next = page(step);
    // Docks, then the page: the page gets its final size at once.
    docks_->show(step, next);
    step_ = step;
    stack_->setCurrentWidget(&next);
    stack_->updateGeometry();
    top_bar_->showStep(step);
    const auto& commands = commandOfStep();
    for (const auto& [other, command] : commands)
        (*actions_)[command]->setChecked(other == step);
    actions_->setReviewShown(step == Step::kReview);
    showPageActions();
    refreshTitle();
    next.enter();
}

void MainWindow::showPageActions() {
    for (const auto& [step, page] : pages_)
        for (QAction* action : page->menuActions()) {
            const bool shown = step == step_;
            // The page knows whether its action can be done; the window only takes it off the keyboard
            // meanwhile.
            if (shown)
                addAction(action);
            else
                removeAction(action);
        }
    menus_->showPageActions(step_, pages_.at(step_)->menuActions());
}

void MainWindow::refreshTitle() {
    const SessionModel& session = studio_.session();
    const QString page = pages_.at(step_)->title();
    if (session.isOpen())
        setWindowTitle(tr("%1 – %2 – Noctule", "page, session")
                           .arg(page, QString::fromStdString(session.session().name)));
    else
        setWindowTitle(step_ == Step::kStart ? tr("Noctule") : tr("%1 – Noctule", "page").arg(page));
}

void MainWindow::restoreGeometryKept() {
    followScale();
    resize(1440, 900);
    restoreGeometry(studio_.settings().value(kGeometry).toByteArray());
    const WindowPlace place = placeWithin(geometry(), freeRoom(*this));
    if (place.content != geometry())
        setGeometry(place.content);
    if (place.maximised || studio_.settings().value(kMaximised, false).toBool())
        setWindowState(windowState() | Qt::WindowMaximized);
}

/// Larger type needs a larger window, but never more than the screen has.
void MainWindow::followScale() {
    const Theme& theme = Theme::get();
    const QSize room = placeWithin(freeRoom(*this), freeRoom(*this)).content.size();
    setMinimumSize(QSize(std::min(theme.px(960), 1280), std::min(theme.px(640), 760)).boundedTo(room));
}

/// Where a control goes that was just used, Qt gives the focus to the next one, possibly a step of the top
/// bar; the next key would leave the page.
void MainWindow::keepFocusOnPage(QWidget* before, QWidget* now) {
    if (!now || !before || !top_bar_->isAncestorOf(now) || top_bar_->isAncestorOf(before) ||
        !isAncestorOf(before) || (before->isVisible() && before->isEnabled()))
        return;
    if (const auto page = pages_.find(step_); page != pages_.end() && page->second->isVisible())
        page->second->setFocus(Qt::OtherFocusReason);
}

void MainWindow::focusNextPanel(bool forward) {
    walkPanels({top_bar_, &docks_->left(), &docks_->leftTab(), middle_, &docks_->right(), &docks_->rightTab(),
                status_},
               forward);
}

}  // namespace noctule::ui
