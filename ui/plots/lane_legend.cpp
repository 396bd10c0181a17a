// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/lane_legend.h"

#include <QCoreApplication>
#include <functional>
#include <vector>

#include "ui/plots/lane_items.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr double kSwatch = 16, kBeforeWords = 6, kBetween = 16, kBandHeight = 8;  // pixels at 100 percent

struct Entry {
    QString words;
    std::function<void(QPainter&, const QRect& swatch)> draw;
};

Entry lineEntry(const LaneCurve& curve) {
    return {curve.legend, [&curve](QPainter& painter, const QRect& swatch) {
                if (curve.low) {
                    QColor band = penColor(curve.pen);
                    band.setAlphaF(0.2);
                    const int height = Theme::get().px(kBandHeight);
                    painter.fillRect(
                        QRect(swatch.left(), swatch.center().y() - height / 2 + 1, swatch.width(), height),
                        band);
                }
                painter.setPen(penOf(curve.pen));
                const int y = swatch.center().y() + 1;
                painter.drawLine(swatch.left(), y, swatch.right(), y);
            }};
}

QString fateWords(RangeFate fate) {
    switch (fate) {
        case RangeFate::kUsed:
            return QCoreApplication::translate("LaneLegend", "used");
        case RangeFate::kWeighted:
            return QCoreApplication::translate("LaneLegend", "less weight");
        case RangeFate::kGated:
            return QCoreApplication::translate("LaneLegend", "left out");
        case RangeFate::kBehindSource:
            return QCoreApplication::translate("LaneLegend", "behind");
        case RangeFate::kNoConfidence:
            return QCoreApplication::translate("LaneLegend", "unsure");
        case RangeFate::kNotTried:
            return QCoreApplication::translate("LaneLegend", "not tried");
    }
    return {};
}

void appendFates(std::vector<Entry>& entries, const std::vector<RangeFate>& fates) {
    for (const RangeFate fate : {RangeFate::kUsed, RangeFate::kWeighted, RangeFate::kGated,
                                 RangeFate::kBehindSource, RangeFate::kNoConfidence, RangeFate::kNotTried})
        if (std::find(fates.begin(), fates.end(), fate) != fates.end())
            entries.push_back({fateWords(fate), [fate](QPainter& painter, const QRect& swatch) {
                                   painter.setRenderHint(QPainter::Antialiasing);
                                   drawFate(painter, QRectF(swatch).center(), fate);
                                   painter.setRenderHint(QPainter::Antialiasing, false);
                               }});
}

Entry markEntry(const LaneMarks& marks) {
    return {marks.legend, [&marks](QPainter& painter, const QRect& swatch) {
                const Tokens& tokens = Theme::get().tokens();
                const QPoint centre = swatch.center();
                const int r = Theme::get().px(4);
                switch (marks.kind) {
                    case LaneMarks::Kind::kSent:
                        painter.fillRect(QRect(centre.x(), centre.y() - r + 1, 1, 2 * r), tokens.t2);
                        break;
                    case LaneMarks::Kind::kArrival:
                        painter.fillRect(QRect(centre.x(), centre.y() - r + 1, 1, 2 * r), tokens.ok);
                        break;
                    case LaneMarks::Kind::kLost:
                        painter.fillRect(QRect(centre.x() - r, centre.y(), 2 * r, 3), tokens.t3);
                        break;
                    case LaneMarks::Kind::kClipped:
                        painter.fillRect(QRect(centre.x() - r, centre.y(), 2 * r, 3), tokens.warn);
                        break;
                }
            }};
}

std::vector<Entry> entriesOf(const LaneContent& content) {
    std::vector<Entry> entries;
    for (const LaneCurve& curve : content.curves)
        if (curve.fate)
            appendFates(entries, *curve.fate);
        else if (!curve.legend.isEmpty())
            entries.push_back(lineEntry(curve));
    for (const LaneMarks& marks : content.marks)
        if (!marks.t_s.empty() && !marks.legend.isEmpty())
            entries.push_back(markEntry(marks));
    return entries;
}

}  // namespace

int paintLaneLegend(QPainter& painter, const QRect& row, const LaneContent& content) {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    const QFontMetrics metrics = painter.fontMetrics();
    const int swatch = theme.px(kSwatch), before = theme.px(kBeforeWords), between = theme.px(kBetween);
    const std::vector<Entry> entries = entriesOf(content);
    const auto widthOf = [&](const Entry& entry) {
        return swatch + before + metrics.horizontalAdvance(entry.words);
    };
    int width = 0;
    size_t fitting = 0;
    for (; fitting < entries.size(); ++fitting) {
        const int more = widthOf(entries[fitting]) + (fitting ? between : 0);
        if (width + more > row.width())
            break;
        width += more;
    }
    int x = row.right() + 1 - width;
    const int begin = x;
    for (size_t i = 0; i < fitting; ++i) {
        entries[i].draw(painter, QRect(x, row.top(), swatch, row.height()));
        painter.setPen(theme.tokens().t2);
        painter.drawText(QRect(x + swatch + before, row.top(), widthOf(entries[i]), row.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, entries[i].words);
        x += widthOf(entries[i]) + between;
    }
    return begin;
}

}  // namespace noctule::ui
