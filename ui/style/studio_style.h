// SPDX-License-Identifier: Apache-2.0
// The studio's look of Qt's own controls: flat surfaces, thin edges, sizes from the theme. Qt's Fusion lays
// out and behaves, this draws. One style instead of a style sheet: sheets set fonts wrongly (weights are
// divided by 8), slow down every polish, and cannot be mixed with widgets that paint themselves.
#pragma once

#include <QProxyStyle>

namespace noctule::ui {

class Theme;

class StudioStyle : public QProxyStyle {
    Q_OBJECT
public:
    explicit StudioStyle(const Theme& theme);

    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* returned) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override;
    QRect subElementRect(SubElement element, const QStyleOption* option,
                         const QWidget* widget) const override;
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                         const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;

private:
    const Theme& theme_;
};

}  // namespace noctule::ui
