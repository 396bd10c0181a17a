// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/state_strip.h"

#include <QPainter>

#include "ui/robot/robot_words.h"
#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

constexpr RobotWord kWords[] = {RobotWord::kNotSynchronised, RobotWord::kReady, RobotWord::kFollowing,
                                RobotWord::kHolding};
constexpr int kGap = 16;

}  // namespace

StateStrip::StateStrip(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::StatusBar});
    setAccessibleName(tr("State of the robot"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void StateStrip::show(RobotWord word, const QString& reason, double accept_within_rad, bool is_error) {
    const bool changes = word != word_ || reason != reason_;
    word_ = word;
    reason_ = reason;
    accept_within_rad_ = accept_within_rad;
    is_error_ = is_error;
    setAccessibleDescription(reason.isEmpty()
                                 ? nameOf(word)
                                 : tr("%1: %2", "state of the robot: reason").arg(nameOf(word), reason));
    if (changes)
        announce(*this);
    update();
}

QString StateStrip::meaningOf(RobotWord word) const {
    switch (word) {
        case RobotWord::kNotSynchronised:
            return tr("a joint is more than %1 away").arg(degreesText(accept_within_rad_, 0));
        case RobotWord::kReady:
            return tr("every joint within %1").arg(degreesText(accept_within_rad_, 0));
        case RobotWord::kFollowing:
            return tr("moves as you do");
        case RobotWord::kHolding:
            return word_ == RobotWord::kHolding && !reason_.isEmpty() ? reason_ : tr("stands still");
    }
    return {};
}

QSize StateStrip::sizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(640), QFontMetrics(theme.font(TextRole::kBody)).height() +
                               QFontMetrics(theme.font(TextRole::kCaption)).height() + theme.px(12)};
}

QSize StateStrip::minimumSizeHint() const {
    return {Theme::get().px(320), sizeHint().height()};
}

void StateStrip::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    const int gap = theme.px(kGap), each = (width() - 3 * gap) / 4;
    const QFontMetrics title(theme.font(TextRole::kBody, true)), small(theme.font(TextRole::kCaption));
    for (int i = 0; i < 4; ++i) {
        const RobotWord word = kWords[i];
        const bool is_now = word == word_;
        const QRect frame(i * (each + gap), 0, each, height() - 1);
        const Tone tone = is_now && is_error_ ? Tone::kError : toneOf(word);
        const QColor color = !is_now ? tokens.t2 : tone == Tone::kNeutral ? tokens.t1 : colorOf(tone);
        paintBox(painter, frame, 4,
                 !is_now                  ? QColor()
                 : tone == Tone::kNeutral ? tokens.ctl
                                          : backgroundOf(tone),
                 is_now ? color : tokens.line);
        const QRect inside = frame.adjusted(theme.px(8), theme.px(5), -theme.px(6), -theme.px(5));
        const int icon = theme.px(14);
        paintIcon(painter, QRect(inside.left(), inside.top(), icon, title.height()), iconOf(word), icon,
                  color);
        const QRect words = inside.adjusted(icon + theme.px(6), 0, 0, 0);
        painter.setFont(theme.font(TextRole::kBody, true));
        painter.setPen(color);
        painter.drawText(words, Qt::AlignTop, title.elidedText(nameOf(word), Qt::ElideRight, words.width()));
        painter.setFont(theme.font(TextRole::kCaption));
        painter.setPen(is_now ? tokens.t1 : tokens.t3);
        painter.drawText(words.adjusted(0, title.height(), 0, 0), Qt::AlignTop,
                         small.elidedText(meaningOf(word), Qt::ElideRight, words.width()));
        if (i < 3)
            paintIcon(painter, QRect(frame.right() + 1, 0, gap, height()), "chevron", theme.px(12),
                      tokens.t3);
    }
}

}  // namespace noctule::ui
