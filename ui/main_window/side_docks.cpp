// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/side_docks.h"

#include <QAction>
#include <QCoreApplication>
#include <QStackedWidget>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "ui/main_window/panel_tab.h"
#include "ui/style/theme.h"
#include "ui/views/page.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/dock_title.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr int kLayoutVersion = 1;
constexpr const char *kScaleKey = "_scale", *kGaveRoomKey = "_gave_room";
constexpr int kLeftWidth = 248, kLeftNarrow = 216, kLeftWidest = 360;
constexpr int kRightWidth = 295, kRightNarrow = 264, kRightWidest = 400;
constexpr int kTries = 4, kBetweenTries_ms = 40;
constexpr int kNarrowWindow = 1400, kLeastForBothDocks = 1100;

QString nameOf(Step step) {
    static const std::map<Step, QString> names{{Step::kStart, "start"},         {Step::kConnect, "connect"},
                                               {Step::kCalibrate, "calibrate"}, {Step::kRecord, "record"},
                                               {Step::kReview, "review"},       {Step::kExport, "export"},
                                               {Step::kPerformer, "performer"}, {Step::kRobot, "robot"}};
    return names.at(step);
}

/// Shows one page's content at a time. As wide as the style guide says, or wider where the content needs it:
/// an explicit minimum would let a dock cut its content.
class DockStack : public QStackedWidget {
public:
    explicit DockStack(int least_width) : least_width_(least_width) {}

    QSize minimumSizeHint() const override {
        const QSize content = currentWidget() ? currentWidget()->minimumSizeHint() : QSize(0, 0);
        return {std::max(Theme::get().px(least_width_), content.width()), content.height()};
    }

private:
    int least_width_;
};

}  // namespace

SideDocks::SideDocks(QMainWindow& window, QSettings& settings)
    : QObject(&window),
      window_(window),
      settings_(settings),
      left_(makeSide(Qt::LeftDockWidgetArea, "left", tr("Left panel"))),
      right_(makeSide(Qt::RightDockWidgetArea, "right", tr("Right panel"))) {
    connect(&Theme::get(), &Theme::changed, this, [this, scale = Theme::get().scale()]() mutable {
        makeRoom();
        if (std::exchange(scale, Theme::get().scale()) != scale)
            resizeToUsual(kTries);
    });
    connect(left_.action, &QAction::triggered, this, [this] { preferTo(*right_.dock); });
    connect(right_.action, &QAction::triggered, this, [this] { preferTo(*left_.dock); });
    window.installEventFilter(this);
}

bool SideDocks::eventFilter(QObject* watched, QEvent* event) {
    // After the window has laid itself out.
    if (watched == &window_ && event->type() == QEvent::Resize)
        QTimer::singleShot(0, this, &SideDocks::makeRoom);
    return QObject::eventFilter(watched, event);
}

SideDocks::Side SideDocks::makeSide(Qt::DockWidgetArea area, const QString& name, const QString& words) {
    Side side{};
    const bool left = area == Qt::LeftDockWidgetArea;
    side.dock = new QDockWidget(words, &window_);
    side.dock->setObjectName(name);
    side.dock->setAccessibleName(words);
    side.dock->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    side.stack = new DockStack(left ? kLeftNarrow : kRightNarrow);
    keepMaximumWidth(*side.stack, left ? kLeftWidest : kRightWidest);
    side.dock->setWidget(side.stack);
    side.title = new DockTitle(words);
    auto* lift = new ToolButton("float", tr("Let this panel float, or put it back"));
    auto* hide = new ToolButton("close", tr("Close this panel; it comes back through View"));
    side.title->addAction(lift);
    side.title->addAction(hide);
    side.dock->setTitleBarWidget(side.title);
    connect(lift, &QToolButton::clicked, side.dock,
            [dock = side.dock] { dock->setFloating(!dock->isFloating()); });
    connect(hide, &QToolButton::clicked, side.dock, &QDockWidget::close);
    side.action = side.dock->toggleViewAction();
    side.action->setText(words);
    side.tab = new PanelTab(left ? PanelTab::Side::kLeft : PanelTab::Side::kRight, &window_);
    connect(side.tab, &QAbstractButton::clicked, this, [action = side.action, stack = side.stack] {
        action->trigger();
        stack->currentWidget()->setFocus(Qt::OtherFocusReason);
    });
    window_.addDockWidget(area, side.dock);
    side.dock->hide();
    return side;
}

QString SideDocks::key() const {
    return QStringLiteral("layout/%1").arg(nameOf(step_));
}

void SideDocks::keep() {
    if (!page_)
        return;
    settings_.setValue(key(), window_.saveState(kLayoutVersion));
    settings_.setValue(key() + kScaleKey, Theme::get().scale());
    settings_.setValue(key() + kGaveRoomKey, gave_room_ ? gave_room_->objectName() : QString());
}

void SideDocks::show(Step step, Page& page) {
    keep();
    if (page_)
        disconnect(page_, &Page::dockTitlesChanged, this, nullptr);
    step_ = step;
    page_ = &page;
    const auto fill_both = [this] {
        fill(left_, page_->leftDock(), page_->leftDockTitle());
        fill(right_, page_->rightDock(), page_->rightDockTitle());
    };
    connect(page_, &Page::dockTitlesChanged, this, fill_both);
    fill_both();
    restore();
}

void SideDocks::fill(const Side& side, QWidget* content, const QString& title) {
    side.action->setEnabled(content != nullptr);
    if (!content) {
        side.dock->hide();
        return;
    }
    if (side.stack->indexOf(content) < 0)
        side.stack->addWidget(content);
    side.stack->setCurrentWidget(content);
    side.stack->updateGeometry();
    content->show();
    side.title->setTitle(title);
    side.tab->setTitle(title);
    side.dock->setWindowTitle(title);
}

void SideDocks::restore() {
    const QByteArray state = settings_.value(key()).toByteArray();
    if (state.isEmpty() || !window_.restoreState(state, kLayoutVersion)) {
        reset();
        return;
    }
    // A layout cannot open what the page does not have.
    left_.dock->setVisible(!left_.dock->isHidden() && page_->leftDock());
    right_.dock->setVisible(!right_.dock->isHidden() && page_->rightDock());
    const QString gave_room = settings_.value(key() + kGaveRoomKey).toString();
    gave_room_ = gave_room.isEmpty() ? nullptr : gave_room == "left" ? left_.dock : right_.dock;
    makeRoom();
    const double scale = Theme::get().scale();
    if (settings_.value(key() + kScaleKey, scale).toDouble() != scale)
        resizeToUsual(kTries);
}

void SideDocks::reset() {
    for (const QString& written : {key(), key() + kScaleKey, key() + kGaveRoomKey})
        settings_.remove(written);
    const auto place = [&](const Side& side, Qt::DockWidgetArea area, bool used) {
        side.dock->setFloating(false);
        window_.addDockWidget(area, side.dock);
        side.dock->setVisible(used);
    };
    gave_room_ = page_->leftDock() && !hasRoomForBoth() ? left_.dock : nullptr;
    place(left_, Qt::LeftDockWidgetArea, page_->leftDock() && !gave_room_);
    place(right_, Qt::RightDockWidgetArea, page_->rightDock() != nullptr);
    showTabs();
    resizeToUsual(kTries);
}

bool SideDocks::hasRoomForBoth() const {
    return !page_->leftDock() || !page_->rightDock() ||
           window_.width() >= Theme::get().px(kLeastForBothDocks);
}

bool SideDocks::areBothSeen() const {
    const auto takes_room = [](const Side& side) {
        return !side.dock->isHidden() && !side.dock->isFloating();
    };
    return takes_room(left_) && takes_room(right_);
}

void SideDocks::makeRoom() {
    if (!page_)
        return;
    if (!hasRoomForBoth() && areBothSeen())
        giveRoom(*left_.dock);
    else if (hasRoomForBoth() && gave_room_)
        std::exchange(gave_room_, nullptr)->show();
    const QWidget* centre = window_.centralWidget();
    if (areBothSeen() && centre->width() < centre->minimumSizeHint().width())
        window_.resizeDocks({left_.dock, right_.dock},
                            {Theme::get().px(kLeftNarrow), Theme::get().px(kRightNarrow)}, Qt::Horizontal);
    showTabs();
}

void SideDocks::preferTo(QDockWidget& other) {
    if (gave_room_ != &other)
        gave_room_ = nullptr;  // the operator has decided about it
    if (page_ && !hasRoomForBoth() && areBothSeen())
        giveRoom(other);
    showTabs();
}

void SideDocks::giveRoom(QDockWidget& dock) {
    dock.hide();
    gave_room_ = &dock;
}

void SideDocks::showTabs() {
    for (const Side& side : {left_, right_})
        side.tab->setVisible(gave_room_ == side.dock && side.dock->isHidden());
}

/// What they hold may take a while to know its new size.
void SideDocks::resizeToUsual(int tries) {
    const auto resize = [this, tries, page = page_] {
        if (page != page_)
            return;  // another step has widths of its own
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const Theme& theme = Theme::get();
        const bool narrow = window_.width() < theme.px(kNarrowWindow);
        QList<QDockWidget*> docks;
        QList<int> widths;
        const auto add = [&](const Side& side, int width) {
            if (side.dock->isHidden() || side.dock->isFloating())
                return;
            docks += side.dock;
            widths += theme.px(width);
        };
        add(left_, narrow ? kLeftNarrow : kLeftWidth);
        add(right_, narrow ? kRightNarrow : kRightWidth);
        window_.resizeDocks(docks, widths, Qt::Horizontal);
        if (tries > 1)
            resizeToUsual(tries - 1);
    };
    QTimer::singleShot(tries == kTries ? 0 : kBetweenTries_ms, this, resize);
}

void SideDocks::release(Page& page) {
    for (QWidget* content : {page.leftDock(), page.rightDock()})
        if (content)
            content->setParent(&page);
    if (page_ == &page)
        page_ = nullptr;
}

}  // namespace noctule::ui
