// SPDX-License-Identifier: Apache-2.0
// The plots of the take under review: a row of tabs, of which several may be on, and below it their lanes,
// one under the other on one time axis (the timeline's). What is chosen in studio.selection() is shown, and
// what was added beside it with "add channel".
#pragma once

#include <QImage>
#include <QToolButton>
#include <QWidget>
#include <array>

#include "ui/models/review_context.h"
#include "ui/plots/lane_stack.h"
#include "ui/plots/plot_channels.h"
#include "ui/plots/repaint_limit.h"
#include "ui/plots/sound_source.h"
#include "ui/plots/time_window.h"

class QScrollArea;
class QStackedLayout;

namespace noctule::ui {

class ToolButton;

class PlotPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlotPanel(ReviewContext& review, QWidget* parent = nullptr);

    /// For the Timeline below: same left extent, same right edge when both are equally wide.
    TimeWindow& window() { return window_; }
    PlotChannels& channels() { return channels_; }
    const std::vector<PlotLane*>& lanes() const { return stack_->lanes(); }

    bool isOn(PlotTab tab) const { return channels_.isOn(tab); }
    void setOn(PlotTab tab, bool on) { channels_.setOn(tab, on); }

    /// The lanes as they are on screen, with a ruler below.
    QImage picture() const;
    /// All values of the curves that are shown, within the window.
    std::string csv() const;

    /// Left of every plot and of the timeline, and right of them; pixels at 100 percent.
    static constexpr int kLeftExtent = 56, kRightExtent = 16;

    QSize minimumSizeHint() const override;

public slots:
    void copyPicture();
    void savePicture();
    void copyCsv();
    void saveCsv();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildTabs(QLayout& row);
    /// Tabs that find no room are offered by a menu beside them.
    bool isOffered(const QToolButton* tab) const;
    void fitTabs();
    void fillMoreTabs(QMenu& menu);
    void buildActions(QLayout& row);
    void styleTabs();
    void rebuild();
    void chooseSomething();
    QString suggestedName(const QString& suffix) const;

    ReviewContext& review_;
    TimeWindow window_;
    PlotChannels channels_;
    SoundSource sound_;
    std::array<QToolButton*, kPlotTabs> tabs_{};
    ToolButton* more_tabs_ = nullptr;
    std::vector<ToolButton*> actions_;
    QStackedLayout* pages_ = nullptr;
    QScrollArea* scroll_ = nullptr;
    LaneStack* stack_ = nullptr;
    RepaintLimit rebuild_;
};

}  // namespace noctule::ui
