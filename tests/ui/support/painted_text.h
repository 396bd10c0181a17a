// SPDX-License-Identifier: Apache-2.0
// The texts that a widget paints by itself, wherever they come from: labels, delegates, headers, legends and
// marks of plots. It is painted once onto a device that keeps texts and nothing else.
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QWidget>
#include <vector>

namespace noctule::ui::test {

struct PaintedText {
    QString text;
    QRectF place;  ///< in the widget, as wide as the text
    QRectF room;   ///< what of the widget could show it: less than the place, it is cut
};

class TextRecorder : public QPaintDevice {
public:
    static std::vector<PaintedText> textsOf(const QWidget& widget) {
        TextRecorder recorder(widget);
        const_cast<QWidget&>(widget).render(&recorder, QPoint(), QRegion(), QWidget::RenderFlags());
        return recorder.engine_.texts;
    }

    QPaintEngine* paintEngine() const override { return &engine_; }

protected:
    int metric(PaintDeviceMetric which) const override {
        switch (which) {
            case PdmWidth:
                return widget_.width();
            case PdmHeight:
                return widget_.height();
            case PdmDpiX:
            case PdmPhysicalDpiX:
                return widget_.logicalDpiX();
            case PdmDpiY:
            case PdmPhysicalDpiY:
                return widget_.logicalDpiY();
            case PdmDevicePixelRatioScaled:
                return static_cast<int>(devicePixelRatioFScale());
            default:
                return 1;
        }
    }

private:
    struct Engine : QPaintEngine {
        explicit Engine(const QRectF& whole) : QPaintEngine(AllFeatures), whole_(whole) {}
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        Type type() const override { return User; }
        void updateState(const QPaintEngineState&) override {}
        void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
        void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
        void drawTiledPixmap(const QRectF&, const QPixmap&, const QPointF&) override {}
        void drawPath(const QPainterPath& path) override { paintOver(path.boundingRect()); }
        void drawPolygon(const QPointF* points, int count, PolygonDrawMode) override {
            paintOver(QPolygonF(QVector<QPointF>(points, points + count)).boundingRect());
        }
        void drawTextItem(const QPointF& at, const QTextItem& item) override {
            const QTransform to_widget = painter()->deviceTransform();
            const QRectF place(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
            QRectF room = whole_;
            if (painter()->hasClipping())
                room &= to_widget.mapRect(painter()->clipBoundingRect());
            if (painter()->opacity() > 0 && painter()->pen().color().alpha() > 0)
                texts.push_back({item.text(), to_widget.mapRect(place), room});
        }

        std::vector<PaintedText> texts;

    private:
        /// A mark may hide what was painted before, such as the time at a cursor a tick's label.
        void paintOver(const QRectF& filled) {
            const QBrush brush = painter()->brush();
            const QRectF place = painter()->deviceTransform().mapRect(filled);
            if (brush.style() == Qt::SolidPattern && brush.color().alpha() == 255)
                std::erase_if(texts, [&](const PaintedText& text) { return text.place.intersects(place); });
        }

        QRectF whole_;
    };

    explicit TextRecorder(const QWidget& widget) : widget_(widget), engine_(QRectF(widget.rect())) {}

    const QWidget& widget_;
    mutable Engine engine_;
};

}  // namespace noctule::ui::test
