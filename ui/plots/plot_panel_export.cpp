// SPDX-License-Identifier: Apache-2.0
// The plots as a picture and as values.
#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QFileInfo>
#include <QPainter>

#include "core/job/atomic_file.h"
#include "core/review/series_csv.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/time_ruler.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

QString exportsOf(const SessionModel& session) {
    return session.isOpen() ? QString::fromStdString(session.session().exportsFolder().string()) : QString();
}

/// The file dialog has asked before it replaces a file.
void write(ReviewContext& review, const QString& path, std::string_view content) {
    const Status written = writeFileAtomically(path.toStdString(), content, true);
    if (!written) {
        emit review.shared().failed(coreWords(written.error().message), coreWords(written.error().remedy),
                                    About::kFile);
        return;
    }
    review.shared().sayOfFile(QCoreApplication::translate("PlotPanel", "%1 is written").arg(path));
}

}  // namespace

QImage PlotPanel::picture() const {
    const Theme& theme = Theme::get();
    const double ratio = devicePixelRatioF();
    const QSize lanes = stack_->size();
    const int ruler = theme.px(kRulerHeight);
    QImage image(QSize(lanes.width(), lanes.height() + ruler) * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(theme.tokens().panel);
    QPainter painter(&image);
    stack_->render(&painter, QPoint(), QRegion(), QWidget::DrawChildren);
    const auto [left, right] = stack_->timeExtent();
    paintTimeRuler(painter, QRect(left, lanes.height(), right - left, ruler), window_);
    return image;
}

std::string PlotPanel::csv() const {
    std::vector<NamedSeries> curves;
    for (const PlotLane* lane : stack_->lanes())
        for (const LaneCurve& curve : lane->content().curves) {
            const std::string name = curve.column.toStdString();
            curves.push_back({name, curve.value});
            if (curve.low)
                curves.push_back({tr("%1, lower 2 sigma").arg(curve.column).toStdString(), curve.low});
            if (curve.high)
                curves.push_back({tr("%1, upper 2 sigma").arg(curve.column).toStdString(), curve.high});
        }
    return seriesCsv(curves, window_.from(), window_.to());
}

QString PlotPanel::suggestedName(const QString& suffix) const {
    const QString take = QFileInfo(review_.take().path()).completeBaseName();
    return tr("%1_plots", "file name").arg(take) + suffix;
}

void PlotPanel::copyPicture() {
    QApplication::clipboard()->setImage(picture());
    emit review_.shared().said(tr("The plots are on the clipboard"));
}

void PlotPanel::savePicture() {
    const QString path =
        FileChoice{"plots", tr("Save the plots as a picture"), tr("Picture (*.png)"),
                   suggestedName(QStringLiteral(".png")), exportsOf(review_.shared().session())}
            .toSave(this);
    if (path.isEmpty())
        return;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture().save(&buffer, "PNG");
    write(review_, path, {bytes.constData(), static_cast<size_t>(bytes.size())});
}

void PlotPanel::copyCsv() {
    QApplication::clipboard()->setText(QString::fromStdString(csv()));
    emit review_.shared().said(tr("The values are on the clipboard"));
}

void PlotPanel::saveCsv() {
    const QString path =
        FileChoice{"plots", tr("Save the values that are shown"), tr("Table (*.csv)"),
                   suggestedName(QStringLiteral(".csv")), exportsOf(review_.shared().session())}
            .toSave(this);
    if (!path.isEmpty())
        write(review_, path, csv());
}

}  // namespace noctule::ui
