// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_html.h"

#include <QXmlStreamReader>
#include <utility>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Tables of ten columns fit pages narrower than this, in pixels, if their bars are short.
constexpr int kShortBarsBelow = 600;
/// Width in units of its own view box. Plots narrower than this may stand side by side.
constexpr double kLeastWidthOfWholeRow = 600;

/// They stand two in a row where their words stay readable so.
bool isNarrow(const ReportFigure& plot) {
    return plot.viewBox().width() < kLeastWidthOfWholeRow;
}

/// Walks the markup of one part and writes what QTextDocument understands.
class Translator {
public:
    Translator(ReportDocument& document, int page_width) : document_(document), page_width_(page_width) {}

    void translate(const ReportPart& part) {
        out() += QString("<a name=\"%1\"></a>").arg(QString::fromStdString(part.id));
        QXmlStreamReader reader(QString::fromStdString(part.html));
        while (!reader.atEnd()) {
            reader.readNext();
            if (reader.isStartElement())
                open(reader);
            else if (reader.isEndElement())
                close();
            else if (reader.isCharacters())
                out() += reader.text().toString().toHtmlEscaped();
        }
    }

private:
    QString& out() { return document_.html; }

    void open(QXmlStreamReader& reader) {
        const QString name = reader.name().toString();
        const QString css_class = reader.attributes().value("class").toString();
        if (name == "svg") {
            addFigure(ReportFigure::read(reader));
            return;
        }
        if (name == "caption") {
            reader.skipCurrentElement();
            return;
        }
        if (name == "dl" || name == "table") {
            out() += "<table class=\"data\" width=\"100%\" cellspacing=\"0\" cellpadding=\"0\">";
            push("</table><p class=\"gap\"></p>");
        } else if (name == "div" && css_class == "cards") {
            out() += "<table class=\"cards\" width=\"100%\" cellspacing=\"8\" cellpadding=\"12\"><tr>";
            push("</tr></table>");
        } else if (name == "div" && css_class == "pair") {
            out() += "<p class=\"figure\">";  // they flow in it like words
            push("</p>");
        } else if (name == "div" && css_class == "card") {
            out() += "<td class=\"card\" width=\"25%\">";
            push("</td>");
        } else if (name == "div" && !opened_.isEmpty() && opened_.last().startsWith("</table>")) {
            out() += "<tr>";  // name and value of a definition list
            push("</tr>");
        } else if (name == "dt" || name == "dd") {
            out() += QString("<td class=\"%1\">").arg(name);
            push("</td>");
        } else if (name == "th" || name == "td") {
            openCell(reader.attributes(), name);
        } else if (name == "section") {
            push("<hr class=\"line\">");
        } else if (name == "b") {
            out() += "<span class=\"value\">";
            push("</span><br>");
        } else if (name == "summary") {
            out() += "<h2>";  // nothing is folded here: it heads what follows
            push("</h2>");
        } else if (name == "div" || name == "details") {
            push("");
        } else {
            row_begins_ = name == "tr";
            out() += QString("<%1 class=\"%2\">").arg(name, css_class);
            push(QString("</%1>").arg(name));
        }
    }

    void openCell(const QXmlStreamAttributes& attributes, const QString& name) {
        const QString css_class = attributes.value("class").toString();
        const bool is_first = std::exchange(row_begins_, false);
        const bool is_word = css_class == "word" || is_first;
        const bool is_head = name == "th" && attributes.value("scope") == QLatin1String("col");
        QString tag = QString("<td class=\"%1\" align=\"%2\"")
                          .arg(is_head                   ? "columnhead"
                               : is_word || name == "th" ? "cell"
                                                         : "number",
                               css_class == "group" ? "center"
                               : is_word            ? "left"
                                                    : "right");
        if (attributes.hasAttribute("colspan"))
            tag += QString(" colspan=\"%1\"").arg(attributes.value("colspan").toString());
        out() += tag + ">";
        push("</td>");
    }

    void addFigure(ReportFigure figure) {
        const QSize size = figureSize(figure, page_width_);
        const QString image = QString("<img src=\"figure:%1\" width=\"%2\" height=\"%3\">")
                                  .arg(document_.figures.size())
                                  .arg(size.width())
                                  .arg(size.height());
        const bool is_alone = figure.kind() == ReportFigure::Kind::kPlot && !isNarrow(figure);
        out() += is_alone ? "<p class=\"figure\">" + image + "</p>" : image + " ";
        document_.figures.push_back(std::move(figure));
    }

    void push(const QString& closing) { opened_.append(closing); }
    void close() { out() += opened_.takeLast(); }

    ReportDocument& document_;
    int page_width_;
    bool row_begins_ = false;
    QStringList opened_;  ///< how each open element ends
};

}  // namespace

ReportDocument reportDocument(const std::vector<ReportPart>& parts, int page_width) {
    ReportDocument document;
    Translator translator(document, page_width);
    for (const ReportPart& part : parts)
        translator.translate(part);
    return document;
}

QSize figureSize(const ReportFigure& figure, int page_width) {
    const QSizeF box = figure.viewBox();
    switch (figure.kind()) {
        case ReportFigure::Kind::kPlot: {
            const bool is_half = isNarrow(figure) && page_width > 1.7 * box.width();
            const double width = is_half ? 0.5 * page_width - 12 : page_width;
            return QSizeF(width, width * box.height() / std::max(1.0, box.width())).toSize();
        }
        case ReportFigure::Kind::kBar:
            return Theme::get().scale() * QSize(page_width < Theme::get().px(kShortBarsBelow) ? 40 : 120, 8);
        case ReportFigure::Kind::kIcon:
            return Theme::get().scale() * QSize(16, 16);
        case ReportFigure::Kind::kSwatch:
            break;
    }
    return (Theme::get().scale() * box).toSize();
}

QString reportStyle(double zoom) {
    const Tokens& t = Theme::get().tokens();
    const auto px = [zoom](double size) { return QString::number(qRound(Theme::get().px(size) * zoom)); };
    return QString(
               "body{color:%1;font-size:%2px}"
               "h1{font-size:%3px;font-weight:500;margin-top:0;margin-bottom:8px}"
               "h2{font-size:%4px;font-weight:500;margin-top:16px;margin-bottom:4px}"
               "h3{font-size:%5px;font-weight:500;margin-top:16px;margin-bottom:4px}"
               ".lead{color:%6}.note,.key,.nothing,small{color:%7;font-size:%8px}"
               "p{margin-top:4px;margin-bottom:8px}.figure{margin-top:8px}.gap{font-size:4px;margin:0}"
               "td{padding:4px 3px}.number{white-space:nowrap}.columnhead{color:%7;font-size:%8px}"
               ".dt{color:%6}.dd{color:%1}.look{color:%9}.value{font-size:%3px}"
               ".card{background-color:%10}")
        .arg(t.t1.name(), px(13), px(26), px(20), px(15), t.t2.name(), t.t3.name(), px(12), t.warn.name(),
             t.raised.name());
}

}  // namespace noctule::ui
