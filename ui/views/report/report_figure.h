// SPDX-License-Identifier: Apache-2.0
// A drawing of the report (inline SVG with the classes of core/report/style.h) as a picture in the colours of
// the theme. Qt's SVG knows no style sheets worth the name: the classes are turned into attributes.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSizeF>

class QXmlStreamReader;

namespace noctule::ui {

class ReportFigure {
public:
    /// `reader` stands on <svg>; afterwards on </svg>.
    static ReportFigure read(QXmlStreamReader& reader);

    enum class Kind {
        kPlot,    ///< as wide as the page
        kBar,     ///< of a table cell
        kSwatch,  ///< of a legend
        kIcon,
    };
    Kind kind() const { return kind_; }
    const QString& title() const { return title_; }
    QSizeF viewBox() const { return view_box_; }

    QImage picture(const QSize& size, double device_pixel_ratio) const;

private:
    Kind kind_ = Kind::kPlot;
    QString title_;
    QSizeF view_box_;
    QByteArray svg_;
};

}  // namespace noctule::ui
