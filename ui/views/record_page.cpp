// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record_page.h"

#include <QPainter>
#include <QVBoxLayout>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

/// The record button as it will be, in grey: nothing can be recorded, so nothing is red.
class RestingRing : public QWidget {
public:
    RestingRing() {
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        QObject::connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
    }
    QSize sizeHint() const override { return {Theme::get().px(90), Theme::get().px(90)}; }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF centre = QRectF(rect()).center();
        painter.setPen(QPen(tokens.edge, theme.px(3)));
        painter.drawEllipse(centre, theme.px(42) - 2, theme.px(42) - 2);
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.ctl);
        painter.drawEllipse(centre, theme.px(33), theme.px(33));
    }
};

}  // namespace

RecordPage::RecordPage(Studio& studio, QWidget* parent)
    : ComingPage(
          studio,
          {tr("Record"),
           tr("Nothing to record from"),
           tr("The studio does not record from a suit yet; noctule --batch record does."),
           {tr("The body live in three dimensions, with every ray between source and board."),
            tr("A clock and how much of the take is on disk, a countdown, markers and notes while it runs."),
            tr("Levels of each board, and a word when something slips or falls silent.")},
           tr("Import takes that were recorded elsewhere, or let the virtual suit make one.")},
          parent) {
    addVirtualSuitWay();
    addImportWay();
    auto* middle = new QWidget;
    auto* column = makeColumn(middle, {16, 16, 16, 16}, 12);
    column->addStretch();
    column->addWidget(new RestingRing, 0, Qt::AlignHCenter);
    column->addWidget(
        new Label(tr("0:00.0", "the clock of a take before it begins"), TextRole::kClock, Ink::kHint), 0,
        Qt::AlignHCenter);
    auto* sentence =
        new Label(tr("A take starts here once a suit is connected."), TextRole::kSection, Ink::kLabel);
    sentence->setAlignment(Qt::AlignHCenter);
    sentence->wrapped();
    column->addWidget(sentence);
    column->addStretch();
    setDrawing(middle, {});
}

}  // namespace noctule::ui
