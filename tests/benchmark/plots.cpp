// SPDX-License-Identifier: Apache-2.0
// Repainting one lane of 800 by 120 pixels: our columns against Qwt's own drawing of all points, which is
// what QwtPlotCurve does inside (its header is no C++20).
#include <benchmark/benchmark.h>
#include <qwt_painter.h>
#include <qwt_point_mapper.h>
#include <qwt_scale_map.h>
#include <qwt_series_data.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <cmath>
#include <memory>
#include <random>

#include "ui/plots/lane_items.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kWidth = 800, kHeight = 120;
constexpr double kDuration_s = 600;

Series randomWalk(size_t count) {
    std::mt19937 random(1);
    std::normal_distribution<float> step(0, 0.02f);
    Series series;
    float value = 0;
    for (size_t i = 0; i < count; ++i) {
        value = value * 0.999f + step(random);
        series.t_s.push_back(kDuration_s * static_cast<double>(i) / static_cast<double>(count));
        series.value.push_back(value);
    }
    return series;
}

/// A smooth angle, as motions have.
Series swing(size_t count) {
    Series series;
    for (size_t i = 0; i < count; ++i) {
        series.t_s.push_back(kDuration_s * static_cast<double>(i) / static_cast<double>(count));
        series.value.push_back(static_cast<float>(0.8 * std::sin(series.t_s.back() * 0.2)));
    }
    return series;
}

template <class Draw>
void repaint(benchmark::State& state, Draw draw) {
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    QwtScaleMap time, value;
    time.setScaleInterval(0, kDuration_s);
    time.setPaintInterval(0, kWidth);
    value.setScaleInterval(-1, 1);
    value.setPaintInterval(kHeight, 0);
    for (auto _ : state) {
        image.fill(Qt::white);
        QPainter painter(&image);
        draw(painter, time, value);
    }
}

void ours(benchmark::State& state, Series series) {
    LaneCurve curve;
    curve.value = std::make_shared<SeriesPyramid>(std::move(series));
    CurveItem item(curve);
    item.setEmphasis({0, kDuration_s});
    repaint(state, [&](QPainter& painter, const QwtScaleMap& time, const QwtScaleMap& value) {
        painter.setRenderHint(QPainter::Antialiasing);
        item.draw(&painter, time, value, QRectF(0, 0, kWidth, kHeight));
    });
}

void columnsOfNoise(benchmark::State& state) {
    ours(state, randomWalk(static_cast<size_t>(state.range(0))));
}

void columnsOfSmoothCurve(benchmark::State& state) {
    ours(state, swing(static_cast<size_t>(state.range(0))));
}

void qwtAllPoints(benchmark::State& state) {
    const Series series = randomWalk(static_cast<size_t>(state.range(0)));
    QVector<QPointF> points;
    for (size_t i = 0; i < series.t_s.size(); ++i)
        points.append({series.t_s[i], double{series.value[i]}});
    const QwtPointSeriesData data(points);
    repaint(state, [&](QPainter& painter, const QwtScaleMap& time, const QwtScaleMap& value) {
        painter.setPen(QPen(Qt::blue, 1));
        const QwtPointMapper mapper;
        QwtPainter::drawPolyline(&painter, mapper.toPolygon(time, value, &data, 0, points.size() - 1));
    });
}

BENCHMARK(columnsOfNoise)->Arg(100'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(columnsOfSmoothCurve)->Arg(100'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(qwtAllPoints)->Arg(100'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace noctule::ui

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    noctule::ui::Theme::install(application);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
