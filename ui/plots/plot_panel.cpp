// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/plot_panel.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QScrollBar>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/plots/channel_menu.h"
#include "ui/plots/lanes.h"
#include "ui/style/theme.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kTabHeight = 28, kTabPadding = 20, kHeadInset = 12, kHeadGap = 4, kLeastWidth = 320;

}  // namespace

PlotPanel::PlotPanel(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      window_(review.time()),
      channels_(review),
      sound_(review),
      rebuild_([this] { rebuild(); }) {
    stack_ = new LaneStack(review, window_);
    scroll_ = new ScrollArea(stack_);
    scroll_->setWidgetResizable(true);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFrameShape(QFrame::NoFrame);
    const auto keepALane = [this] { scroll_->setMinimumHeight(Theme::get().px(PlotLane::kLeastHeight)); };
    keepALane();
    connect(&Theme::get(), &Theme::changed, this, keepALane);
    connect(scroll_->verticalScrollBar(), &QScrollBar::rangeChanged, this, [this](int least, int most) {
        stack_->setScrollBarWidth(most > least ? scroll_->verticalScrollBar()->sizeHint().width() : 0);
    });

    auto* head = new QHBoxLayout;
    const Theme& theme = Theme::get();
    head->setSpacing(theme.px(kHeadGap));
    head->setContentsMargins(theme.px(kHeadInset), theme.px(kHeadGap), theme.px(kHeadInset),
                             theme.px(kHeadGap));
    buildTabs(*head);
    head->addStretch(1);
    buildActions(*head);
    styleTabs();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(new Divider);
    pages_ = new QStackedLayout;
    pages_->addWidget(scroll_);
    pages_->addWidget(new EmptyState(tr("Open a take to see its curves.")));
    column->addLayout(pages_, 1);

    TakeDocument& take = review.take();
    connect(&take, &TakeDocument::opened, this, &PlotPanel::chooseSomething);
    connect(&take, &TakeDocument::opened, this, &PlotPanel::fitTabs);
    for (const auto signal :
         {&TakeDocument::opened, &TakeDocument::runsChanged, &TakeDocument::processingChanged,
          &TakeDocument::motionChanged, &TakeDocument::rangesChanged, &TakeDocument::readingsChanged,
          &TakeDocument::curvesChanged})
        connect(&take, signal, this, [this] { rebuild_.ask(); });
    connect(&channels_, &PlotChannels::changed, this, [this] {
        styleTabs();
        rebuild_.ask();
    });
    connect(&sound_, &SoundSource::changed, this, [this] { rebuild_.ask(); });
    connect(&window_, &TimeWindow::changed, this, [this] {
        if (isOn(PlotTab::kRawSound))
            rebuild_.ask();
    });
    connect(&Theme::get(), &Theme::changed, this, &PlotPanel::styleTabs);
    chooseSomething();
    rebuild();
}

void PlotPanel::buildTabs(QLayout& row) {
    const std::array<QString, kPlotTabs> names{tr("Confidence"), tr("Ranges"),       tr("Raw sound"),
                                               tr("Inertial"),   tr("Joint angles"), tr("Root"),
                                               tr("Between")};
    for (int i = 0; i < kPlotTabs; ++i) {
        auto* tab = new QToolButton;
        tab->setText(names[static_cast<size_t>(i)]);
        tab->setCheckable(true);
        tab->setAutoRaise(true);
        tab->setFocusPolicy(Qt::TabFocus);
        tab->setAccessibleName(tr("Show %1", "a plot").arg(tab->text()));
        connect(tab, &QToolButton::clicked, this, [this, i](bool on) { setOn(static_cast<PlotTab>(i), on); });
        row.addWidget(tab);
        tabs_[static_cast<size_t>(i)] = tab;
    }
    more_tabs_ = new ToolButton(QStringLiteral("more"), tr("More plots"));
    more_tabs_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(more_tabs_);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMoreTabs(*menu); });
    more_tabs_->setMenu(menu);
    row.addWidget(more_tabs_);
}

bool PlotPanel::isOffered(const QToolButton* tab) const {
    const auto index = static_cast<int>(std::ranges::find(tabs_, tab) - tabs_.begin());
    return isPlotOf(review_.take(), static_cast<PlotTab>(index));
}

void PlotPanel::fitTabs() {
    const Theme& theme = Theme::get();
    const int gap = theme.px(kHeadGap);
    int room = width() - 2 * theme.px(kHeadInset);
    for (const ToolButton* action : actions_)
        room -= action->sizeHint().width() + gap;
    int all = 0;
    for (const QToolButton* tab : tabs_)
        all += isOffered(tab) ? tab->width() + gap : 0;
    const bool all_fit = all <= room;
    if (!all_fit)
        room -= more_tabs_->sizeHint().width() + gap;
    for (QToolButton* tab : tabs_) {
        room -= isOffered(tab) ? tab->width() + gap : 0;
        tab->setVisible(isOffered(tab) && (all_fit || room >= 0));
    }
    more_tabs_->setVisible(!all_fit);
}

void PlotPanel::fillMoreTabs(QMenu& menu) {
    menu.clear();
    for (QToolButton* tab : tabs_) {
        if (!tab->isHidden() || !isOffered(tab))
            continue;
        QAction* action = menu.addAction(tab->text(), tab, &QToolButton::click);
        action->setCheckable(true);
        action->setChecked(tab->isChecked());
    }
}

void PlotPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitTabs();
}

QSize PlotPanel::minimumSizeHint() const {
    return {Theme::get().px(kLeastWidth), QWidget::minimumSizeHint().height()};
}

void PlotPanel::styleTabs() {
    const Theme& theme = Theme::get();
    for (int i = 0; i < kPlotTabs; ++i) {
        QToolButton& tab = *tabs_[static_cast<size_t>(i)];
        const bool on = isOn(static_cast<PlotTab>(i));
        tab.setChecked(on);
        tab.setFont(theme.font(TextRole::kBody, on));
        QPalette palette = tab.palette();
        palette.setColor(QPalette::ButtonText, on ? theme.tokens().acc : theme.tokens().t2);
        tab.setPalette(palette);
        const int words = QFontMetrics(theme.font(TextRole::kBody, true)).horizontalAdvance(tab.text());
        tab.setFixedSize(words + theme.px(kTabPadding), theme.px(kTabHeight));
    }
    fitTabs();
}

void PlotPanel::buildActions(QLayout& row) {
    const auto add = [&](const char* icon, const QString& name) {
        auto* button = new ToolButton(QLatin1String(icon), name);
        button->setPopupMode(QToolButton::InstantPopup);
        button->setMenu(new QMenu(button));
        row.addWidget(button);
        actions_.push_back(button);
        return button->menu();
    };
    QMenu* channels = add("new", tr("Add a channel"));
    connect(channels, &QMenu::aboutToShow, this,
            [this, channels] { fillChannelMenu(*channels, review_, channels_); });
    QMenu* picture = add("camera", tr("Picture of the plots"));
    picture->addAction(tr("Copy as picture"), this, &PlotPanel::copyPicture);
    picture->addAction(tr("Save as PNG…"), this, &PlotPanel::savePicture);
    QMenu* values = add("export", tr("Values of the plots"));
    values->addAction(tr("Copy as CSV"), this, &PlotPanel::copyCsv);
    values->addAction(tr("Save as CSV…"), this, &PlotPanel::saveCsv);
}

void PlotPanel::chooseSomething() {
    if (!review_.take().isOpen())
        return;
    Selection& selection = review_.selection();
    const Suit& suit = review_.take().overview()->suit;
    const auto sources = static_cast<int>(suit.sources.size()), boards = static_cast<int>(suit.boards.size());
    const bool exists = selection.source() >= 0 && selection.source() < sources && selection.board() >= 0 &&
                        selection.board() < boards;
    if (!exists && sources > 0 && boards > 0) {
        // The shin to the source that hears most of the body: the last one, the hat, in our suits.
        const auto shin = std::find_if(suit.boards.begin(), suit.boards.end(),
                                       [](const Board& board) { return board.segment == "LeftLeg"; });
        selection.setPair(sources - 1,
                          shin == suit.boards.end() ? 0 : static_cast<int>(shin - suit.boards.begin()));
    }
    if (selection.joint().isEmpty())
        selection.setJoint(QStringLiteral("LeftLeg"));
}

void PlotPanel::rebuild() {
    const bool open = review_.take().isOpen();
    pages_->setCurrentIndex(open ? 0 : 1);
    stack_->setLanes(open ? allLanes({review_.take(), channels_, sound_, window_})
                          : std::vector<LaneContent>{});
}

}  // namespace noctule::ui
