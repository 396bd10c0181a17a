// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/plot_lane.h"

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_engine.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plots/plot_panel.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

// Pixels at 100 percent.
constexpr double kAboveArea = 6, kBelowArea = 8, kPixelsPerTick = 22;
constexpr int kMostTicks = 4;
/// A band may take this share of the values' height on either side; uncertainty without end would else
/// flatten the curve.
constexpr double kBandShare = 0.5;
/// Free above and below what is seen.
constexpr double kMargin = 0.06;

class LaneCanvas : public QwtPlotCanvas {
public:
    explicit LaneCanvas(QwtPlot* plot) : QwtPlotCanvas(plot) {
        setFrameStyle(QFrame::NoFrame);
        setPaintAttribute(BackingStore, true);
        setPaintAttribute(Opaque, true);
        setFocusIndicator(NoFocusIndicator);
        setFocusPolicy(Qt::NoFocus);
        setCursor(Qt::ArrowCursor);
        setAutoFillBackground(true);
    }
};

}  // namespace

PlotLane::PlotLane(QWidget* parent) : QWidget(parent), plot_(new QwtPlot(this)) {
    plot_->setCanvas(new LaneCanvas(plot_));
    plot_->setAutoReplot(false);
    plot_->setFocusPolicy(Qt::NoFocus);
    for (const int axis : {QwtPlot::yLeft, QwtPlot::xBottom})
        plot_->enableAxis(axis, false);
    plot_->plotLayout()->setCanvasMargin(0);
    plot_->plotLayout()->setSpacing(0);
    plot_->setContentsMargins(0, 0, 0, 0);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    right_px_ = Theme::get().px(PlotPanel::kRightExtent);
    connect(&Theme::get(), &Theme::changed, this, &PlotLane::style);
    style();
}

void PlotLane::style() {
    plot_->canvas()->setPalette(Theme::get().tokens().panel);
    setContent(content_);
    placeCanvas();
    updateGeometry();
}

void PlotLane::setContent(LaneContent content) {
    content_ = std::move(content);
    plot_->detachItems(QwtPlotItem::Rtti_PlotItem, true);
    curves_.clear();
    points_.clear();
    auto* grid = new QwtPlotGrid;
    grid->enableX(false);
    grid->setMajorPen(Theme::get().tokens().line, 1);
    grid->attach(plot_);
    for (const LaneMarks& marks : content_.marks)
        (new MarksItem(marks))->attach(plot_);
    // The first curve is drawn last: on top.
    for (auto curve = content_.curves.rbegin(); curve != content_.curves.rend(); ++curve)
        if (curve->fate) {
            points_.push_back(new PointsItem(*curve));
            points_.back()->attach(plot_);
        } else {
            curves_.push_back(new CurveItem(*curve));
            curves_.back()->attach(plot_);
        }
    plot_->setVisible(!content_.curves.empty());
    draw(from_s_, to_s_, emphasis_);
}

void PlotLane::draw(double from_s, double to_s, const LaneEmphasis& emphasis) {
    from_s_ = from_s, to_s_ = to_s, emphasis_ = emphasis;
    for (CurveItem* item : curves_)
        item->setEmphasis(emphasis);
    for (PointsItem* item : points_)
        item->setEmphasis(emphasis);
    fitValues();
    plot_->setAxisScale(QwtPlot::xBottom, from_s, to_s);
    if (plot_->isVisibleTo(this))
        plot_->replot();
    setCursor(cursor_s_);
    update();
}

std::pair<double, double> PlotLane::seenValues() const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto widen = [&](const std::shared_ptr<const SeriesPyramid>& curve) {
        if (!curve)
            return;
        const auto [least, most] = curve->bounds(from_s_, to_s_);
        if (least <= most) {
            low = std::min(low, double{least});
            high = std::max(high, double{most});
        }
    };
    for (const LaneCurve& curve : content_.curves)
        widen(curve.value);
    if (low > high)
        return {0, 1};
    const double values_low = low, values_high = high;
    const double share = kBandShare * std::max(high - low, content_.least_span);
    for (const LaneCurve& curve : content_.curves) {
        widen(curve.low);
        widen(curve.high);
    }
    low = std::max(low, values_low - share);
    high = std::min(high, values_high + share);
    const double missing = content_.least_span - (high - low);
    if (missing > 0)
        low -= missing / 2, high += missing / 2;
    const double margin = kMargin * (high - low);
    return {low - margin, high + margin};
}

void PlotLane::fitValues() {
    auto [low, high] = content_.range ? *content_.range : seenValues();
    const double factor = content_.unit.factor;
    low *= factor, high *= factor;
    if (!(high > low))
        low -= 0.5, high += 0.5;
    const int fitting = canvas().height() / std::max(1, Theme::get().px(kPixelsPerTick));
    QwtLinearScaleEngine engine;
    int steps = std::clamp(fitting, 1, kMostTicks);
    do  // one tick alone tells no scale
        ticks_ = engine.divideScale(low, high, steps, 0);
    while (ticks_.ticks(QwtScaleDiv::MajorTick).size() < 2 && ++steps <= 2 * kMostTicks);
    value_low_ = low / factor, value_high_ = high / factor;
    QList<double> major;
    for (const double tick : ticks_.ticks(QwtScaleDiv::MajorTick))
        major.append(tick / factor);
    plot_->setAxisScaleDiv(QwtPlot::yLeft, QwtScaleDiv(value_low_, value_high_, {}, {}, major));
}

void PlotLane::setRightExtent(int right_px) {
    if (right_px == right_px_)
        return;
    right_px_ = right_px;
    placeCanvas();
}

QRect PlotLane::canvas() const {
    const Theme& theme = Theme::get();
    const int left = theme.px(PlotPanel::kLeftExtent), top = theme.px(kTitleRow + kAboveArea);
    return {left, top, std::max(1, width() - left - right_px_),
            std::max(1, height() - top - theme.px(kBelowArea))};
}

void PlotLane::placeCanvas() {
    plot_->setGeometry(canvas());
    fitValues();
    plot_->replot();
}

void PlotLane::resizeEvent(QResizeEvent*) {
    placeCanvas();
}

QSize PlotLane::minimumSizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(PlotPanel::kLeftExtent + 160), theme.px(kLeastHeight)};
}

std::optional<QString> PlotLane::readoutOf(const LaneCurve& curve, double t_s) const {
    if (curve.readout.isEmpty())
        return std::nullopt;
    const size_t i = curve.value->indexAt(t_s);
    if (i >= curve.value->size() || t_s - curve.value->series().t_s[i] > curve.hold_s)
        return std::nullopt;
    const LaneUnit& unit = content_.unit;
    const double value = double{curve.value->series().value[i]};
    if (!std::isfinite(value))
        return std::nullopt;
    QString text = numberText(value * unit.factor, unit.decimals) + unit.suffix;
    if (curve.low && curve.high) {
        const size_t j = curve.high->indexAt(t_s);
        const double two_sigma = j < curve.high->size() ? double{curve.high->series().value[j]} - value : NAN;
        if (std::isfinite(two_sigma))
            text = tr("%1 ±%2", "value and two standard deviations")
                       .arg(text, numberText(two_sigma * unit.factor, unit.decimals));
    }
    return curve.readout.arg(text);
}

void PlotLane::setCursor(double t_s) {
    cursor_s_ = t_s;
    std::vector<Part> parts;
    for (const LaneCurve& curve : content_.curves)
        if (const auto text = readoutOf(curve, t_s))
            parts.push_back({*text, curve.pen});
    if (parts == readout_)
        return;
    readout_ = std::move(parts);
    setAccessibleName(content_.title);
    setAccessibleDescription(readout());
    update(0, 0, width(), Theme::get().px(kTitleRow));
}

QString PlotLane::readout() const {
    QStringList texts;
    for (const Part& part : readout_)
        texts.append(part.text);
    return texts.join(QStringLiteral(", "));
}

std::vector<PlotLane::Dot> PlotLane::dotsAt(double t_s) const {
    std::vector<Dot> dots;
    const QRect area = canvas();
    for (const LaneCurve& curve : content_.curves) {
        if (curve.fate || curve.pen == LanePen::kReference || !readoutOf(curve, t_s))
            continue;
        const double value = double{curve.value->series().value[curve.value->indexAt(t_s)]};
        const double fraction = (value_high_ - value) / (value_high_ - value_low_);
        if (fraction < 0 || fraction > 1)
            continue;
        const double x = area.left() + (t_s - from_s_) / (to_s_ - from_s_) * area.width();
        dots.push_back({{x, area.top() + fraction * area.height()}, penColor(curve.pen)});
    }
    return dots;
}

}  // namespace noctule::ui
