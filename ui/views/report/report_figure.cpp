// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_figure.h"

#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>
#include <map>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Attributes of SVG that stand for the rules of core/report/style.cpp.
using Style = std::map<QString, QString>;

Style strokeOf(const QColor& color, const QString& width = "1") {
    return {{"stroke", color.name()}, {"stroke-width", width}};
}

Style fillOf(const QColor& color) {
    return {{"fill", color.name()}};
}

/// What one class adds, in a plot or (fills only) in bars and legends.
Style styleOfClass(const QString& name) {
    const Tokens& t = Theme::get().tokens();
    static const QRegularExpression kConfidence("^c(\\d+)$");
    if (const auto match = kConfidence.match(name); match.hasMatch())
        return fillOf(Theme::get().confidence(match.captured(1).toInt() / 20.0));
    const QColor violet = QColor::fromHsl(280, 130, Theme::get().isDark() ? 195 : 110);
    const std::map<QString, Style> styles = {
        {"head", {{"fill", t.t1.name()}, {"font-size", "13"}, {"font-weight", "500"}}},
        {"legend", fillOf(t.t2)},
        {"end", {{"text-anchor", "end"}}},
        {"mid", {{"text-anchor", "middle"}}},
        {"grid", strokeOf(t.line)},
        {"zero", strokeOf(t.edge)},
        {"group", strokeOf(t.edge)},
        {"estimate", strokeOf(t.acc)},
        {"run0", strokeOf(t.acc)},
        {"reference", {{"stroke", t.ref.name()}, {"stroke-width", "1"}, {"stroke-dasharray", "4,3"}}},
        {"error", strokeOf(t.x)},
        {"run1", strokeOf(t.x)},
        {"x", strokeOf(t.x)},
        {"y", strokeOf(t.y)},
        {"run2", strokeOf(t.y)},
        {"z", strokeOf(t.z)},
        {"run3", strokeOf(violet)},
        {"run4", strokeOf(t.warn)},
        {"run5", strokeOf(t.ok)},
        {"run6", strokeOf(t.t3)},
        {"band", {{"fill", t.acc.name()}, {"fill-opacity", "0.2"}, {"stroke", "none"}}},
        {"dot", {{"stroke", t.acc.name()}, {"stroke-width", "2.5"}, {"stroke-linecap", "round"}}},
        {"dot rejected", strokeOf(t.err, "4")},
        {"dot unused", strokeOf(t.edge, "2.5")},
        {"dot faint", {{"stroke", t.edge.name()}, {"stroke-width", "1.5"}, {"stroke-opacity", "0.45"}}},
        {"none", {{"fill", "none"}, {"stroke", t.edge.name()}, {"stroke-dasharray", "3,2"}}},
        {"used", fillOf(t.acc)},
        {"rejected", fillOf(t.err)},
        {"unused", fillOf(t.edge)},
        {"occluded", fillOf(t.line)},
        {"missing", fillOf(t.warn)},
        {"good", fillOf(t.ok)},
        {"inertia", fillOf(t.warn)},
        {"alone", fillOf(t.err)},
        {"track", fillOf(t.ctl)}};
    const auto found = styles.find(name);
    return found == styles.end() ? Style() : found->second;
}

Style styleOf(const QString& element, const QString& classes) {
    Style style;
    if (element == "path")
        style = {{"fill", "none"}, {"stroke-linejoin", "round"}};
    else if (element == "text")
        style = {{"fill", Theme::get().tokens().t3.name()}, {"font-size", "11"}, {"font-family", "Roboto"}};
    const QStringList names = classes.split(' ', Qt::SkipEmptyParts);
    if (names.isEmpty())
        return style;
    const bool is_dot = names.front() == "dot" && names.size() > 1;
    for (const QString& name : names)
        if (!is_dot || name == "dot")
            for (const auto& [key, value] : styleOfClass(name))
                style[key] = value;
    if (is_dot)
        for (const auto& [key, value] : styleOfClass(classes))
            style[key] = value;
    return style;
}

/// Qt drops lines of no length, with which dots are drawn.
QString withDots(QString path) {
    return path.replace("h0", "h0.02");
}

void copyElement(const QXmlStreamReader& reader, QXmlStreamWriter& writer) {
    const QXmlStreamAttributes attributes = reader.attributes();
    writer.writeStartElement(reader.name().toString());
    Style style = styleOf(reader.name().toString(), attributes.value("class").toString());
    for (const QXmlStreamAttribute& attribute : attributes) {
        const QString name = attribute.name().toString();
        if (name == "d")
            writer.writeAttribute(name, withDots(attribute.value().toString()));
        else if (name != "class" && name != "style" && !name.startsWith("aria"))
            writer.writeAttribute(name, attribute.value().toString());
    }
    for (const auto& [key, value] : style)
        writer.writeAttribute(key, value);
}

ReportFigure::Kind kindOf(const QString& css_class) {
    return css_class == "plot"   ? ReportFigure::Kind::kPlot
           : css_class == "bar"  ? ReportFigure::Kind::kBar
           : css_class == "icon" ? ReportFigure::Kind::kIcon
                                 : ReportFigure::Kind::kSwatch;
}

}  // namespace

ReportFigure ReportFigure::read(QXmlStreamReader& reader) {
    ReportFigure figure;
    figure.kind_ = kindOf(reader.attributes().value("class").toString());
    const QStringList box = reader.attributes().value("viewBox").toString().split(' ');
    if (box.size() == 4)
        figure.view_box_ = QSizeF(box[2].toDouble(), box[3].toDouble());
    QXmlStreamWriter writer(&figure.svg_);
    writer.writeStartElement("svg");
    writer.writeDefaultNamespace("http://www.w3.org/2000/svg");
    writer.writeAttribute("viewBox", box.join(' '));
    writer.writeAttribute("preserveAspectRatio", "none");
    for (int depth = 1; depth > 0 && !reader.atEnd();) {
        switch (reader.readNext()) {
            case QXmlStreamReader::StartElement:
                if (reader.name() == QLatin1String("title") || reader.name() == QLatin1String("desc")) {
                    const bool is_title = reader.name() == QLatin1String("title");
                    const QString words = reader.readElementText();
                    if (is_title && depth == 1)
                        figure.title_ = words;
                    break;
                }
                ++depth;
                copyElement(reader, writer);
                break;
            case QXmlStreamReader::EndElement:
                --depth;
                writer.writeEndElement();
                break;
            case QXmlStreamReader::Characters:
                writer.writeCharacters(reader.text().toString());
                break;
            default:
                break;
        }
    }
    return figure;
}

QImage ReportFigure::picture(const QSize& size, double device_pixel_ratio) const {
    QImage image(size * device_pixel_ratio, QImage::Format_ARGB32_Premultiplied);
    if (image.isNull())
        return image;
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QSvgRenderer(svg_).render(&painter);
    return image;
}

}  // namespace noctule::ui
