// SPDX-License-Identifier: Apache-2.0
#include "ui/style/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QLoggingCategory>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/style/resources.h"

namespace noctule::ui {

namespace {

Q_LOGGING_CATEGORY(missing_icon, "noctule.icons")

constexpr char kColorInDrawings[] = "#6F7B8D";
/// Stands for an icon that the program was built without: a missing picture must not end a recording.
constexpr char kMissingDrawing[] =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'>"
    "<path d='M3 3h10v10H3zM3 3l10 10M13 3L3 13' fill='none' stroke='#6F7B8D'/></svg>";

QByteArray drawingOf(const QString& name) {
    QFile file(resourcePath("icons/" + name + ".svg"));
    if (file.open(QIODevice::ReadOnly))
        return file.readAll();
    qCWarning(missing_icon).noquote() << "The program was built without the icon" << name;
    return kMissingDrawing;
}

class DrawnIcon : public QIconEngine {
public:
    DrawnIcon(QString name, const IconColors& colors) : name_(std::move(name)), colors_(colors) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const int side = std::min(rect.width(), rect.height());
        const double ratio = painter->device()->devicePixelRatioF();
        const QRect square(rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, side,
                           side);
        painter->drawPixmap(square.topLeft(), drawIcon(name_, side, color(mode, state), ratio));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return drawIcon(name_, std::min(size.width(), size.height()), color(mode, state), 1);
    }
    QIconEngine* clone() const override { return new DrawnIcon(*this); }
    QString key() const override { return "noctule"; }

private:
    QColor color(QIcon::Mode mode, QIcon::State state) const {
        if (mode == QIcon::Disabled)
            return colors_.disabled;
        if (state == QIcon::On)
            return colors_.checked;
        return mode == QIcon::Active || mode == QIcon::Selected ? colors_.active : colors_.normal;
    }

    QString name_;
    IconColors colors_;
};

}  // namespace

QPixmap drawIcon(const QString& name, int size_px, const QColor& color, double ratio) {
    const QString key =
        QString("noctule/%1/%2/%3/%4").arg(name).arg(size_px).arg(color.rgba(), 0, 16).arg(ratio);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap))
        return pixmap;
    QByteArray drawing = drawingOf(name);
    drawing.replace(kColorInDrawings, color.name().toLatin1());
    QSvgRenderer renderer(drawing);
    pixmap = QPixmap(QSize(size_px, size_px) * ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setOpacity(color.alphaF());
    renderer.render(&painter);
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

QIcon makeIcon(const QString& name, const IconColors& colors) {
    return QIcon(new DrawnIcon(name, colors));
}

}  // namespace noctule::ui
