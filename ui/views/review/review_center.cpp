// SPDX-License-Identifier: Apache-2.0
#include "ui/views/review/review_center.h"

#include <QScrollBar>
#include <QSplitter>

#include "ui/plots/heat_map.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/timeline.h"
#include "ui/plots/transport_bar.h"
#include "ui/style/theme.h"
#include "ui/views/review/performer_switch.h"
#include "ui/views/review/scene_area.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {

namespace {
constexpr const char *kAbove = "review/above", *kWhole = "review/whole";
constexpr int kRoomForBoth = 700, kLeastBody = 120;  // pixels at 100 percent

/// Body and pairs; never lower than either of those that are seen can be.
class BodyAndPairs : public QSplitter {
public:
    BodyAndPairs() : QSplitter(Qt::Horizontal) {}
    QSize minimumSizeHint() const override {
        return QSplitter::minimumSizeHint().expandedTo({0, Theme::get().px(kLeastBody)});
    }
};

}  // namespace

ReviewCenter::ReviewCenter(ReviewContext& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      performers_(new PerformerSwitch(review)),
      scenes_(new SceneArea(review)),
      heat_map_(new HeatMap(review)),
      plots_(new PlotPanel(review)),
      timeline_(new Timeline(review, plots_->window())),
      transport_(new TransportBar(review, *timeline_)),
      above_(new BodyAndPairs),
      whole_(new QSplitter(Qt::Vertical)),
      tabs_(makeTabs()) {
    above_->addWidget(scenes_);
    above_->addWidget(heat_map_);
    above_->setStretchFactor(0, 1);
    above_->setCollapsible(0, false);
    auto* top = new QWidget;
    auto* top_column = makeColumn(top);
    top_column->addWidget(performers_);
    top_column->addWidget(tabs_);
    top_column->addWidget(above_, 1);
    whole_->addWidget(top);
    whole_->addWidget(plots_);
    for (QSplitter* splitter : {above_, whole_}) {
        splitter->setHandleWidth(1);
        connect(splitter, &QSplitter::splitterMoved, this, &ReviewCenter::keepSplitters);
    }
    whole_->setCollapsible(1, false);
    auto* scroll = new ScrollArea(whole_);
    auto* column = makeColumn(this);
    column->addWidget(scroll, 1);
    auto* timeline = addRow(column, 0);
    timeline->addWidget(timeline_);
    column->addWidget(new Divider);
    column->addWidget(transport_);
    const auto align = [scroll, timeline] {  // one axis of time with the plots
        const QScrollBar& bar = *scroll->verticalScrollBar();
        timeline->setContentsMargins(0, 0, bar.maximum() > bar.minimum() ? bar.sizeHint().width() : 0, 0);
    };
    connect(scroll->verticalScrollBar(), &QScrollBar::rangeChanged, this, align);
    connect(&Theme::get(), &Theme::changed, this, align);
    restoreSplitters();
    connect(&Theme::get(), &Theme::changed, this, &ReviewCenter::fold);
    connect(&review.take(), &TakeDocument::opened, this, &ReviewCenter::fold);
    fold();
}

QWidget* ReviewCenter::makeTabs() {
    auto* tabs = new QWidget;
    auto* row = makeRow(tabs, {12, 4, 12, 4}, 4);
    body_tab_ = makeButton(ButtonKind::kText, tr("Body"));
    pairs_tab_ = makeButton(ButtonKind::kText, tr("Confidence per pair"));
    for (Button* tab : {body_tab_, pairs_tab_}) {
        tab->setCheckable(true);
        row->addWidget(tab);
        connect(tab, &QPushButton::clicked, this, [this, tab] { showPairs(tab == pairs_tab_); });
    }
    row->addStretch();
    tabs->hide();
    return tabs;
}

void ReviewCenter::showPairs(bool pairs) {
    shows_pairs_ = pairs;
    fold();
}

void ReviewCenter::fold() {
    const bool folded = width() < Theme::get().px(kRoomForBoth), has_pairs = review_.take().hasSources();
    tabs_->setVisible(folded && has_pairs);
    body_tab_->setChecked(!shows_pairs_);
    pairs_tab_->setChecked(shows_pairs_);
    scenes_->setVisible(!folded || !shows_pairs_ || !has_pairs);
    heat_map_->setVisible(has_pairs && (!folded || shows_pairs_));
    above_->updateGeometry();
}

void ReviewCenter::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fold();
}

ReviewCenter::~ReviewCenter() = default;

void ReviewCenter::restoreSplitters() {
    const Theme& theme = Theme::get();
    if (!above_->restoreState(review_.shared().settings().value(kAbove).toByteArray()))
        above_->setSizes({theme.px(456), theme.px(412)});
    if (!whole_->restoreState(review_.shared().settings().value(kWhole).toByteArray()))
        whole_->setSizes({theme.px(346), theme.px(310)});
}

void ReviewCenter::keepSplitters() const {
    review_.shared().settings().setValue(kAbove, above_->saveState());
    review_.shared().settings().setValue(kWhole, whole_->saveState());
}

}  // namespace noctule::ui
