// SPDX-License-Identifier: Apache-2.0
#include <QFileInfo>
#include <QPdfWriter>
#include <QScrollBar>
#include <QTextDocument>
#include <QWheelEvent>

#include "ui/style/theme.h"
#include "ui/views/report/report_view.h"

namespace noctule::ui {

namespace {
constexpr int kMargin = 32, kNarrowMargin = 16, kNarrowPage = 640, kWidestPage = 1080, kResize_ms = 120;
}

ReportBrowser::ReportBrowser(QWidget* parent) : QTextBrowser(parent) {
    setFrameShape(NoFrame);
    setOpenLinks(false);
    setWordWrapMode(QTextOption::WordWrap);  // columns of tables are as wide as their longest word
    setAccessibleName(tr("Report"));
    resized_.setSingleShot(true);
    resized_.setInterval(kResize_ms);
    connect(&resized_, &QTimer::timeout, this, [this] {
        if (pageWidth() != laid_out_width_)
            layOut();
    });
    connect(&Theme::get(), &Theme::changed, this, &ReportBrowser::layOut);
}

void ReportBrowser::setParts(std::vector<ReportPart> parts) {
    parts_ = std::move(parts);
    layOut();
}

void ReportBrowser::setZoom(double zoom) {
    zoom_ = std::clamp(zoom, 0.5, 3.0);
    layOut();
    emit zoomChanged();
}

int ReportBrowser::margin() const {
    return Theme::get().px(width() < Theme::get().px(kNarrowPage) ? kNarrowMargin : kMargin);
}

int ReportBrowser::pageWidth() const {
    const Theme& theme = Theme::get();
    const int room = width() - verticalScrollBar()->sizeHint().width() - 2 * margin();
    return std::clamp(room, theme.px(400), theme.px(kWidestPage));
}

void ReportBrowser::layOut() {
    if (parts_.empty())
        return;
    const QScrollBar* bar = verticalScrollBar();
    const double place = bar->maximum() > 0 ? static_cast<double>(bar->value()) / bar->maximum() : 0;
    laid_out_width_ = pageWidth();
    QPalette colors = palette();
    colors.setColor(QPalette::Base, Theme::get().tokens().panel);
    setPalette(colors);
    const int text_width = static_cast<int>(laid_out_width_ * zoom_) + 2 * margin();
    setLineWrapMode(QTextEdit::FixedPixelWidth);
    setLineWrapColumnOrWidth(text_width);
    report_ = reportDocument(parts_, static_cast<int>(laid_out_width_ * zoom_));
    document()->clear();
    document()->setDefaultStyleSheet(reportStyle(zoom_));
    document()->setDocumentMargin(margin());
    QFont font = Theme::get().font(TextRole::kBody);
    font.setPixelSize(qRound(QFontInfo(font).pixelSize() * zoom_));
    document()->setDefaultFont(font);
    setHtml("<body>" + report_.html + "</body>");
    setHorizontalScrollBarPolicy(document()->size().width() > width() ? Qt::ScrollBarAsNeeded
                                                                      : Qt::ScrollBarAlwaysOff);
    verticalScrollBar()->setValue(qRound(place * verticalScrollBar()->maximum()));
}

QVariant ReportBrowser::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::ImageResource || name.scheme() != "figure")
        return QTextBrowser::loadResource(type, name);
    bool is_number = false;
    const size_t index = name.path().toUInt(&is_number);
    if (!is_number || index >= report_.figures.size())
        return {};
    const ReportFigure& figure = report_.figures[index];
    return figure.picture(figureSize(figure, static_cast<int>(laid_out_width_ * zoom_)), devicePixelRatioF());
}

void ReportBrowser::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    resized_.start();
}

void ReportBrowser::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier)
        setZoom(zoom_ * (event->angleDelta().y() > 0 ? 1.1 : 1 / 1.1));
    else
        QTextBrowser::wheelEvent(event);
}

bool ReportBrowser::savePdf(const QString& path) {
    QPdfWriter writer(path);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setResolution(96);
    writer.setTitle(documentTitle());
    print(&writer);
    return QFileInfo(path).size() > 0;
}

}  // namespace noctule::ui
