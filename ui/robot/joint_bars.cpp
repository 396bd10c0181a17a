// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/joint_bars.h"

#include <QPainter>

#include "ui/robot/robot_words.h"
#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

constexpr double kNearLimit = 0.05;
constexpr int kSide = 12, kBar = 6, kLeastWidth = 220;

/// Continuous joints are drawn as a turn about 0.
std::pair<double, double> limitsShown(const robot::ChainJoint& joint) {
    const bool is_bounded = std::isfinite(joint.lower) && std::isfinite(joint.upper);
    return is_bounded ? std::pair{joint.lower, joint.upper} : std::pair{-std::numbers::pi, std::numbers::pi};
}

QString valueOf(const robot::ChainJoint& joint, double value) {
    return joint.is_prismatic ? millimetresText(value, 0) : degreesText(value, 1);
}

}  // namespace

JointBars::JointBars(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Table});
    setAccessibleName(tr("Joints of the robot"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void JointBars::setParts(std::shared_ptr<const RobotParts> parts) {
    parts_ = std::move(parts);
    achieved_.clear();
    wanted_.clear();
    updateGeometry();
    update();
}

void JointBars::show(const std::vector<double>& achieved, const std::vector<double>& wanted) {
    achieved_ = achieved;
    wanted_ = wanted;
    QStringList words;
    for (size_t i = 0; parts_ && i < std::min(achieved.size(), parts_->axes.size()); ++i)
        words << tr("%1: %2", "joint: value")
                     .arg(jointInWords(parts_->joints[i]), valueOf(parts_->axes[i], achieved[i]));
    setAccessibleDescription(words.join("; "));
    update();
}

bool JointBars::isAtLimit(size_t joint) const {
    const robot::ChainJoint& axis = parts_->axes[joint];
    if (joint >= achieved_.size() || !std::isfinite(axis.lower) || !std::isfinite(axis.upper))
        return false;
    const double margin = kNearLimit * (axis.upper - axis.lower);
    return achieved_[joint] < axis.lower + margin || achieved_[joint] > axis.upper - margin;
}

int JointBars::rowHeight() const {
    const Theme& theme = Theme::get();
    return QFontMetrics(theme.font(TextRole::kSecondary)).height() +
           QFontMetrics(theme.font(TextRole::kCaption)).height() + theme.px(kBar + 8);
}

QSize JointBars::sizeHint() const {
    return {Theme::get().px(kLeastWidth), parts_ ? rowHeight() * static_cast<int>(parts_->axes.size()) : 0};
}

QSize JointBars::minimumSizeHint() const {
    return sizeHint();
}

void JointBars::paintEvent(QPaintEvent*) {
    if (!parts_)
        return;
    QPainter painter(this);
    for (size_t i = 0; i < parts_->axes.size(); ++i)
        paintRow(painter, i, QRect(0, static_cast<int>(i) * rowHeight(), width(), rowHeight()));
}

void JointBars::paintRow(QPainter& painter, size_t joint, const QRect& row) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const robot::ChainJoint& axis = parts_->axes[joint];
    const bool at_limit = isAtLimit(joint);
    if (at_limit)
        painter.fillRect(row, tokens.warnbg);
    const QRect inside = row.adjusted(theme.px(kSide), theme.px(2), -theme.px(kSide), 0);
    const QFont font = theme.font(TextRole::kSecondary), strong = theme.font(TextRole::kSecondary, true);
    const QFontMetrics metrics(font);
    const int column = QFontMetrics(strong).horizontalAdvance(QStringLiteral("\u2212888.8°")) + theme.px(6);
    const QRect line(inside.left(), inside.top(), inside.width(), metrics.height());
    int name_left = line.left();
    if (at_limit) {
        const int icon = theme.px(12);
        paintIcon(painter, QRect(name_left, line.top(), icon, line.height()), "warn", icon, tokens.warn);
        name_left += icon + theme.px(4);
    }
    painter.setFont(font);
    painter.setPen(tokens.t1);
    const int room = line.right() - 2 * column - name_left;
    painter.drawText(QRect(name_left, line.top(), room, line.height()), Qt::AlignVCenter,
                     metrics.elidedText(jointInWords(parts_->joints[joint]), Qt::ElideMiddle, room));
    if (joint < wanted_.size()) {
        painter.setPen(tokens.t2);
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, valueOf(axis, wanted_[joint]));
    }
    if (joint < achieved_.size()) {
        painter.setFont(strong);
        painter.setPen(at_limit ? tokens.warn : tokens.t1);
        painter.drawText(line.adjusted(0, 0, -column, 0), Qt::AlignRight | Qt::AlignVCenter,
                         valueOf(axis, achieved_[joint]));
    }
    const QRect bar(inside.left(), line.bottom() + theme.px(2), inside.width(), theme.px(kBar));
    paintBar(painter, joint, bar);
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(tokens.t3);
    const auto [lower, upper] = limitsShown(axis);
    const QRect below(bar.left(), bar.bottom() + 1, bar.width(), row.bottom() - bar.bottom());
    const auto limitText = [&](double value) {
        return axis.is_prismatic ? millimetresText(value, 0) : degreesText(value, 0);
    };
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, limitText(lower));
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop, limitText(upper));
}

void JointBars::paintBar(QPainter& painter, size_t joint, const QRect& bar) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const robot::ChainJoint& axis = parts_->axes[joint];
    const auto [lower, upper] = limitsShown(axis);
    paintBox(painter, bar, 2, tokens.ctl);
    if (std::isfinite(axis.lower)) {
        const int tinted = std::max(2, static_cast<int>(kNearLimit * bar.width()));
        const QColor tint = mixed(tokens.ctl, tokens.warn, 0.4);
        painter.fillRect(bar.left(), bar.top(), tinted, bar.height(), tint);
        painter.fillRect(bar.right() - tinted + 1, bar.top(), tinted, bar.height(), tint);
    }
    const auto xOf = [&, lower = lower, upper = upper](double value) {
        return bar.left() + std::clamp((value - lower) / (upper - lower), 0.0, 1.0) * bar.width();
    };
    const double half = theme.px(3), above = theme.px(2);
    if (joint < achieved_.size()) {
        const double x = xOf(achieved_[joint]);
        painter.fillRect(QRectF(x - half / 2, bar.top() - above, half, bar.height() + 2 * above),
                         isAtLimit(joint) ? tokens.warn : tokens.acc);
    }
    if (joint < wanted_.size()) {
        painter.setPen(QPen(tokens.ref, 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        const double x = xOf(wanted_[joint]);
        painter.drawRect(QRectF(x - half, bar.top() - above, 2 * half, bar.height() + 2 * above));
    }
}

}  // namespace noctule::ui
