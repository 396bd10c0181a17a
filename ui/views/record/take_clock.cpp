// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/take_clock.h"

#include <QPainter>

#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/accessible.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {
namespace {

constexpr qint64 kLate_ms = 1000;

}  // namespace

/// Red while a take runs, hollow before.
class TakeClock::Dot : public QWidget {
public:
    Dot() { keepSize(*this, 12, 12); }
    void setRuns(bool runs) {
        runs_ = runs;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Tokens& tokens = Theme::get().tokens();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(runs_ ? tokens.rec : tokens.edge, 1.5));
        painter.setBrush(runs_ ? QBrush(tokens.rec) : QBrush(Qt::NoBrush));
        painter.drawEllipse(QRectF(rect()).adjusted(1, 1, -1, -1));
    }

private:
    bool runs_ = false;
};

/// 0:17 large, .4 small on the same line.
class TakeClock::Digits : public QWidget {
public:
    Digits() {
        describe(*this, {QAccessible::Clock});
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
        setSeconds(0);
    }
    void setSeconds(double seconds) {
        const QString text = timeText(seconds, 1);
        if (text == text_)
            return;
        text_ = text;
        setAccessibleName(text);
        updateGeometry();
        update();
    }
    void setRuns(bool runs) {
        runs_ = runs;
        update();
    }
    QSize sizeHint() const override {
        const QFontMetrics large(largeFont()), small(smallFont());
        return {large.horizontalAdvance(text_.chopped(2)) + small.horizontalAdvance(text_.right(2)) + 4,
                large.ascent() + large.descent()};
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Tokens& tokens = Theme::get().tokens();
        QPainter painter(this);
        const QFontMetrics large(largeFont());
        painter.setFont(largeFont());
        painter.setPen(runs_ ? tokens.t1 : tokens.t3);
        painter.drawText(0, large.ascent(), text_.chopped(2));
        painter.setFont(smallFont());
        painter.setPen(runs_ ? tokens.t2 : tokens.t3);
        painter.drawText(large.horizontalAdvance(text_.chopped(2)) + 1, large.ascent(), text_.right(2));
    }

private:
    static QFont largeFont() { return Theme::get().font(TextRole::kClock); }
    static QFont smallFont() { return Theme::get().font(TextRole::kVerdict); }

    QString text_;
    bool runs_ = false;
};

TakeClock::TakeClock(QWidget* parent)
    : QWidget(parent),
      dot_(new Dot),
      name_(new Label({}, TextRole::kSection, Ink::kValue, true)),
      shot_(new Label({}, TextRole::kBody, Ink::kLabel)),
      digits_(new Digits),
      safety_row_(new QWidget),
      safety_icon_(new IconLabel(
          "safe", [this] { return colorOf(tone_); }, 14)),
      safety_(new Label({}, TextRole::kBody, Ink::kOk)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* column = makeColumn(this, {16, 12, 0, 0}, 2);
    auto* head = addRow(column, 10);
    head->addWidget(dot_);
    head->addWidget(name_);
    head->addWidget(shot_, 1);
    column->addWidget(digits_);
    column->addWidget(safety_row_);
    auto* row = makeRow(safety_row_, {}, 6);
    row->addWidget(safety_icon_);
    row->addWidget(safety_, 1);
    safety_row_->hide();
    connect(&Theme::get(), &Theme::changed, this, &TakeClock::adjustSize, Qt::QueuedConnection);
}

void TakeClock::setTake(const QString& name, const QString& shot, bool runs) {
    name_->setText(name);
    shot_->setText(shot);
    dot_->setRuns(runs);
    digits_->setRuns(runs);
    adjustSize();
}

void TakeClock::setSeconds(double seconds) {
    digits_->setSeconds(seconds);
    adjustSize();
}

void TakeClock::setRecorder(const std::optional<RecorderState>& recorder, int sample_rate_hz) {
    safety_row_->setVisible(recorder.has_value());
    if (!recorder) {
        commits_ = -1;
        return adjustSize();
    }
    if (recorder->commits != commits_)
        since_commit_.start();
    commits_ = recorder->commits;
    const bool late = since_commit_.isValid() && since_commit_.elapsed() > kLate_ms && !recorder->ended;
    tone_ = late ? Tone::kError : Tone::kOk;
    safety_->setInk(late ? Ink::kError : Ink::kOk);
    safety_icon_->setIcon(late ? "error" : "safe", [this] { return colorOf(tone_); });
    const double safe_s = static_cast<double>(recorder->committed_samples) / std::max(1, sample_rate_hz);
    safety_->setText(tr("On disk up to %1").arg(timeText(safe_s)));
    adjustSize();
}

QString TakeClock::safety() const {
    return safety_row_->isHidden() ? QString() : safety_->text();
}

}  // namespace noctule::ui
