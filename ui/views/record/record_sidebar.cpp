// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_sidebar.h"

#include <QPainter>
#include <QVBoxLayout>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/record/mark_list.h"
#include "ui/views/record/record_run.h"
#include "ui/views/record/shot_list.h"
#include "ui/views/scaled_layout.h"
#include "ui/views/session/session_commands.h"
#include "ui/views/take_list.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

constexpr int kRunningRow = 28, kRunningInset = 12, kRunningDot = 8, kRunningGap = 8;

}  // namespace

/// As a row of the list above it, in red.
class RecordSidebar::RunningTake : public QWidget {
public:
    RunningTake() { keepSize(*this, 0, kRunningRow); }
    void setTake(const QString& name, const QString& state) {
        name_ = name;
        state_ = state;
        setAccessibleName(name.isEmpty() ? QString()
                                         : RecordSidebar::tr("%1, %2", "take, state").arg(name, state));
        setVisible(!name.isEmpty());
        update();
    }
    const QString& name() const { return name_; }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.fillRect(rect(), tokens.sel);
        const double dot = theme.px(kRunningDot);
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.rec);
        painter.drawEllipse(QRectF(theme.px(kRunningInset), (height() - dot) / 2, dot, dot));
        QRect text = rect().adjusted(theme.px(kRunningInset + kRunningDot + kRunningGap), 0,
                                     -theme.px(kRunningInset), 0);
        painter.setFont(theme.font(TextRole::kSecondary));
        painter.setPen(tokens.t1);
        painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, state_);
        text.setRight(text.right() - painter.fontMetrics().horizontalAdvance(state_) - theme.px(kRunningGap));
        painter.setFont(theme.font(TextRole::kBody, true));
        painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(name_, Qt::ElideMiddle, text.width()));
    }

private:
    QString name_, state_;
};

RecordSidebar::RecordSidebar(Studio& studio, RecordRun& run, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      run_(run),
      header_(new SectionHeader(tr("Takes"))),
      takes_(new TakeList(studio)),
      running_(new RunningTake),
      shots_(new ShotList(studio, run)),
      marks_(new MarkList(run)) {
    auto* column = makeColumn(this);
    addRow(column, 0, {12, 6, 12, 2})->addWidget(header_);
    takes_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    column->addWidget(takes_);
    column->addWidget(running_);
    auto* below = new QWidget;
    auto* below_column = makeColumn(below);
    below_column->addWidget(new Divider);
    below_column->addWidget(shots_);
    below_column->addWidget(new Divider);
    below_column->addWidget(marks_);
    below_column->addStretch();
    column->addWidget(new ScrollArea(below), 1);
    connect(takes_, &QListView::activated, this, [this] {
        if (studio_.take().isOpen())
            studio_.goTo(Step::kReview);
    });
    connect(takes_, &TakeList::transferWanted, this, [this](int take, SessionModel::Transfer how) {
        SessionCommands::askForTransfer(window(), studio_, take, how);
    });
    connect(&run, &RecordRun::changed, this, &RecordSidebar::refresh);
    refresh();
}

void RecordSidebar::refresh() {
    const bool runs = run_.state() == RecordRun::State::kRecording;
    const bool saves = run_.state() == RecordRun::State::kSaving;
    // The running take follows the last one, and it alone is highlighted.
    takes_->setVisible(!(runs || saves) || takes_->model()->rowCount() > 0);
    takes_->setHighlights(!(runs || saves));
    running_->setTake(runs || saves ? run_.takeName() : QString(),
                      saves ? tr("being saved", "a take") : tr("recording", "a take"));
    if (!studio_.session().isOpen())
        return header_->setHint({});
    int kept = 0;
    double seconds = 0;
    for (const SessionTake& take : studio_.session().session().takes) {
        kept += take.state != TakeState::kDamaged;
        seconds += take.duration_s;
    }
    header_->setHint(
        kept > 0 ? tr("%1 kept, %2", "number of takes, their time").arg(kept).arg(timeText(seconds, 0))
                 : QString());
}

QString RecordSidebar::runningTake() const {
    return running_->name();
}

}  // namespace noctule::ui
