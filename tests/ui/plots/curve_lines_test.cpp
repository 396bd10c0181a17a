// SPDX-License-Identifier: Apache-2.0
// Drawing from columns looks as drawing all samples does.
#include "ui/plots/curve_lines.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>
#include <limits>
#include <random>

namespace noctule::ui {
namespace {

constexpr int kWidth = 300, kHeight = 120;
constexpr uint kSeed = 6;

CurveFrame frameOf(double from_s, double to_s) {
    CurveFrame frame;
    frame.time.setScaleInterval(from_s, to_s);
    frame.time.setPaintInterval(0, kWidth);
    frame.value.setScaleInterval(-1, 1);
    frame.value.setPaintInterval(kHeight, 0);
    return frame;
}

Series noise(size_t count, double duration_s) {
    std::mt19937 random(kSeed);
    std::normal_distribution<float> step(0, 0.02f);
    Series series;
    float value = 0;
    for (size_t i = 0; i < count; ++i) {
        value = std::clamp(value * 0.999f + step(random), -0.95f, 0.95f);
        series.t_s.push_back(duration_s * (static_cast<double>(i) + 0.37) / static_cast<double>(count));
        series.value.push_back(value);
    }
    return series;
}

template <class Draw>
QImage drawn(Draw draw) {
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setPen(QPen(Qt::black, 1));
    draw(painter);
    return image;
}

/// Every sample, each in the middle of its column of pixels.
QImage drawnInFull(const Series& series, const CurveFrame& frame) {
    return drawn([&](QPainter& painter) {
        QPolygonF line;
        const auto flush = [&] {
            painter.drawPolyline(line);
            line.clear();
        };
        for (size_t i = 0; i < series.t_s.size(); ++i) {
            if (std::isnan(series.value[i])) {
                flush();
                continue;
            }
            line.append({std::floor(frame.time.transform(series.t_s[i])) + 0.5,
                         frame.value.transform(double{series.value[i]})});
        }
        flush();
    });
}

QImage drawnReduced(const Series& series, const CurveFrame& frame) {
    const SeriesPyramid pyramid(series);
    return drawn([&](QPainter& painter) {
        for (const QPolygonF& line : curveLines(pyramid, frame, 0, kWidth))
            painter.drawPolyline(line);
    });
}

/// First and last row with ink of every column; (height, -1) without.
std::vector<std::pair<int, int>> inkedRows(const QImage& image) {
    std::vector<std::pair<int, int>> rows;
    for (int x = 0; x < image.width(); ++x) {
        std::pair<int, int> extent(image.height(), -1);
        for (int y = 0; y < image.height(); ++y)
            if (image.pixelColor(x, y) != Qt::white)
                extent = {std::min(extent.first, y), y};
        rows.push_back(extent);
    }
    return rows;
}

int inkedPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y) != Qt::white;
    return count;
}

TEST(CurveLines, ColumnsReachFromTheLowestToTheHighestSample) {
    const Series series = noise(100'000, 10);
    for (const auto& [from_s, to_s] : {std::pair(0.0, 10.0), std::pair(2.5, 7.1), std::pair(9.0, 10.0)}) {
        const CurveFrame frame = frameOf(from_s, to_s);
        const QImage full = drawnInFull(series, frame);
        EXPECT_GT(inkedPixels(full), kWidth);
        const auto expected = inkedRows(full), rows = inkedRows(drawnReduced(series, frame));
        // Where a line turns Qt's rasteriser may leave out its last pixel.
        for (int x = 0; x < kWidth; ++x) {
            const auto i = static_cast<size_t>(x);
            EXPECT_LE(std::abs(rows[i].first - expected[i].first), 1) << "seed " << kSeed << ", column " << x;
            EXPECT_LE(std::abs(rows[i].second - expected[i].second), 1)
                << "seed " << kSeed << ", column " << x;
        }
    }
}

TEST(CurveLines, FewSamplesAreDrawnAsTheyAre) {
    const Series series = noise(100, 10);
    const SeriesPyramid pyramid(series);
    const CurveFrame frame = frameOf(0, 10);
    const auto lines = curveLines(pyramid, frame, 0, kWidth);
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].size(), 100);
    EXPECT_NEAR(lines[0][40].x(), frame.time.transform(series.t_s[40]), 1e-9);
    EXPECT_NEAR(lines[0][40].y(), frame.value.transform(double{series.value[40]}), 1e-9);
}

TEST(CurveLines, BreakWhereValuesAreMissing) {
    for (const size_t count : {size_t{100}, size_t{50'000}}) {
        Series series = noise(count, 10);
        for (size_t i = count / 2; i < count * 6 / 10; ++i)
            series.value[i] = std::numeric_limits<float>::quiet_NaN();
        const CurveFrame frame = frameOf(0, 10);
        const QImage image = drawnReduced(series, frame);
        for (int x = kWidth / 2 + 3; x < kWidth * 6 / 10 - 3; ++x)
            for (int y = 0; y < kHeight; ++y)
                ASSERT_EQ(image.pixelColor(x, y), QColor(Qt::white)) << count << " samples at " << x;
        EXPECT_EQ(curveLines(SeriesPyramid(series), frame, 0, kWidth).size(), 2u);
    }
}

TEST(CurveLines, ALoneValueIsSeen) {
    const Series series{{1, 5, 9}, {NAN, 0.f, NAN}};
    EXPECT_GE(inkedPixels(drawnReduced(series, frameOf(0, 10))), 1);
}

TEST(CurveLines, NothingComesOfNothing) {
    EXPECT_TRUE(curveLines(SeriesPyramid(), frameOf(0, 1), 0, kWidth).empty());
    EXPECT_TRUE(curveLines(SeriesPyramid(noise(10, 1)), frameOf(-5, -2), 0, kWidth).empty());
}

TEST(CurveLines, WorkDoesNotGrowWithTheSamples) {
    const SeriesPyramid pyramid(noise(1'000'000, 10));
    qsizetype points = 0;
    for (const QPolygonF& line : curveLines(pyramid, frameOf(0, 10), 0, kWidth))
        points += line.size();
    EXPECT_LE(points, 4 * (kWidth + 2));
}

TEST(BandPolygons, EncloseBothCurves) {
    const Series middle = noise(20'000, 10);
    Series low = middle, high = middle;
    for (size_t i = 0; i < middle.value.size(); ++i)
        low.value[i] -= 0.05f, high.value[i] += 0.05f;
    const CurveFrame frame = frameOf(0, 10);
    const auto polygons = bandPolygons(SeriesPyramid(low), SeriesPyramid(high), frame, 0, kWidth);
    ASSERT_EQ(polygons.size(), 1u);
    for (size_t i = 100; i < middle.t_s.size(); i += 997) {
        const double x = std::floor(frame.time.transform(middle.t_s[i])) + 0.5;
        const QPointF point(x, frame.value.transform(double{middle.value[i]}));
        EXPECT_TRUE(polygons[0].containsPoint(point, Qt::OddEvenFill)) << i;
    }
}

}  // namespace
}  // namespace noctule::ui
