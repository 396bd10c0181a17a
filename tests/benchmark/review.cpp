// SPDX-License-Identifier: Apache-2.0
// What a screen waits for: opening a take and loading its parts, and reducing a long curve to the columns of
// a plot against handing every point to the painter. Loading needs a take, best a long one, processed:
// NOCTULE_BENCH_TAKE=take.noctule bench_review
#include <benchmark/benchmark.h>

#include <QImage>
#include <QPainter>
#include <cmath>
#include <cstdlib>

#include "core/motion/foot_contacts.h"
#include "core/processing/evaluate_take.h"
#include "core/report/take_verdict.h"
#include "core/review/joint_curves.h"
#include "core/review/plot_series.h"

namespace noctule {
namespace {

constexpr int kColumns = 1200, kHeight = 200;

std::string takePath() {
    const char* path = std::getenv("NOCTULE_BENCH_TAKE");
    return path ? path : "";
}

/// Overview of the take, or the benchmark skipped.
std::optional<TakeOverview> opened(benchmark::State& state) {
    auto overview = takePath().empty() ? Result<TakeOverview>(Error{ErrorKind::kUsage, "no take", ""})
                                       : overviewTake(takePath(), {});
    if (overview && !overview->runs.empty())
        return std::move(*overview);
    state.SkipWithError("set NOCTULE_BENCH_TAKE to a processed take");
    return std::nullopt;
}

void overview(benchmark::State& state) {
    if (!opened(state))
        return;
    for (auto _ : state)
        benchmark::DoNotOptimize(overviewTake(takePath(), {}));
}

void poses(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    for (auto _ : state)
        benchmark::DoNotOptimize(loadPoses(takePath(), take->runs.back().run.run, {}));
}

void ranges(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    for (auto _ : state)
        benchmark::DoNotOptimize(loadRanges(takePath(), *take->runs.back().settings.range_run, {}));
}

void readings(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    for (auto _ : state)
        benchmark::DoNotOptimize(loadReadings(takePath(), *take->runs.back().settings.inertial_run, {}));
}

void pairSummaries(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    const auto table = loadRanges(takePath(), *take->runs.back().settings.range_run, {});
    const PairSummaries summaries(*table);
    for (auto _ : state)
        for (int source = 0; source < summaries.sourceCount(); ++source)
            for (int board = 0; board < summaries.boardCount(); ++board)
                benchmark::DoNotOptimize(summaries.window(source, board, 1, take->duration_s - 1));
}

void jointCurve(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    const auto motion = loadPoses(takePath(), take->runs.back().run.run, {});
    for (auto _ : state)
        benchmark::DoNotOptimize(motionCurve(*motion, mainCurve(motion->skeleton, "LeftLeg")));
}

void contacts(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    const auto motion = loadPoses(takePath(), take->runs.back().run.run, {});
    for (auto _ : state)
        benchmark::DoNotOptimize(findFootContacts(*motion));
}

void judged(benchmark::State& state) {
    const auto take = opened(state);
    if (!take)
        return;
    EvaluateRequest request;
    request.take_path = takePath();
    for (auto _ : state) {
        const auto report = evaluateTake(request, {});
        benchmark::DoNotOptimize(judgeTake(*report));
    }
}

Series waves(size_t count) {
    Series series;
    for (size_t i = 0; i < count; ++i) {
        series.t_s.push_back(static_cast<double>(i) * 1e-3);
        series.value.push_back(static_cast<float>(std::sin(0.01 * static_cast<double>(i)) +
                                                  0.1 * std::sin(1.7 * static_cast<double>(i))));
    }
    return series;
}

double y(float value) {
    return kHeight * (0.5 - 0.4 * value);
}

void drawColumns(benchmark::State& state) {
    const SeriesPyramid pyramid(waves(static_cast<size_t>(state.range(0))));
    QImage image(kColumns, kHeight, QImage::Format_ARGB32_Premultiplied);
    for (auto _ : state) {
        image.fill(Qt::black);
        QPainter painter(&image);
        painter.setPen(QPen(Qt::white, 1));
        const auto columns = pyramid.columns(0, pyramid.series().t_s.back(), kColumns);
        for (int x = 0; x < kColumns; ++x) {
            const SeriesColumn& column = columns[static_cast<size_t>(x)];
            if (!column.empty)
                painter.drawLine(QPointF(x, y(column.min)), QPointF(x, y(column.max)));
        }
    }
}

void drawEveryPoint(benchmark::State& state) {
    const Series series = waves(static_cast<size_t>(state.range(0)));
    QImage image(kColumns, kHeight, QImage::Format_ARGB32_Premultiplied);
    const double scale = kColumns / series.t_s.back();
    for (auto _ : state) {
        image.fill(Qt::black);
        QPainter painter(&image);
        painter.setPen(QPen(Qt::white, 1));
        QPolygonF line;
        for (size_t i = 0; i < series.t_s.size(); ++i)
            line.append({series.t_s[i] * scale, y(series.value[i])});
        painter.drawPolyline(line);
    }
}

void buildPyramid(benchmark::State& state) {
    const Series series = waves(static_cast<size_t>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(SeriesPyramid(series));
}

BENCHMARK(overview)->Unit(benchmark::kMillisecond);
BENCHMARK(poses)->Unit(benchmark::kMillisecond);
BENCHMARK(ranges)->Unit(benchmark::kMillisecond);
BENCHMARK(readings)->Unit(benchmark::kMillisecond);
BENCHMARK(pairSummaries)->Unit(benchmark::kMicrosecond);
BENCHMARK(jointCurve)->Unit(benchmark::kMillisecond);
BENCHMARK(contacts)->Unit(benchmark::kMillisecond);
BENCHMARK(judged)->Unit(benchmark::kMillisecond);
BENCHMARK(buildPyramid)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(drawColumns)->Arg(84'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(drawEveryPoint)->Arg(84'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace noctule

BENCHMARK_MAIN();
