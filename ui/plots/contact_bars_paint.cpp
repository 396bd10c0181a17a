// SPDX-License-Identifier: Apache-2.0
// How the feet's lanes look: what was found is filled, what was set by hand has a line under it as well, the
// chosen one has the colour of a selection.
#include <algorithm>

#include "ui/plots/contact_bars.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr double kOutsideRange = 0.45;
constexpr double kLaneTitleLeft = 16, kByHandLine = 2;  // pixels at 100 percent

}  // namespace

void ContactBars::paintTitles(QPainter& painter, const ContactLanes& lanes) const {
    const Theme& theme = Theme::get();
    const std::array names{tr("L foot", "left foot, short"), tr("R foot", "right foot, short")};
    for (size_t foot = 0; foot < 2; ++foot) {
        const QRect& row = lanes.feet[foot];
        const bool is_chosen = !chosen_.foot.empty() && chosen_.foot == footOf(static_cast<int>(foot));
        painter.setFont(theme.font(TextRole::kCaption, is_chosen));
        painter.setPen(is_chosen ? theme.tokens().t1 : theme.tokens().t2);
        painter.drawText(QRect(theme.px(kLaneTitleLeft), row.top() - theme.px(4),
                               row.left() - theme.px(kLaneTitleLeft), row.height() + theme.px(8)),
                         Qt::AlignLeft | Qt::AlignVCenter, names[foot]);
    }
}

void ContactBars::paint(QPainter& painter, const ContactLanes& lanes) const {
    paintTitles(painter, lanes);
    const auto known = review_.contacts().contacts();
    if (!known)
        return;
    ContactPlace chosen = chosen_;
    std::vector<FootContacts> feet = *known;
    if (drag_ && (drag_->now.from_s != drag_->before.from_s || drag_->now.to_s != drag_->before.to_s))
        feet = withContact(std::move(feet), chosen, drag_->now);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    for (const FootContacts& foot : feet) {
        const QRect& row = lanes.feet[static_cast<size_t>(laneOf(foot.foot))];
        for (int i = 0; const FootContact& contact : foot.contacts)
            paintBar(painter, lanes, row, contact, ContactPlace{foot.foot, i++} == chosen);
    }
    painter.setOpacity(1);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

/// Paler where it lies before in or after out.
void ContactBars::paintBar(QPainter& painter, const ContactLanes& lanes, const QRect& row,
                           const FootContact& contact, bool is_chosen) const {
    const Theme& theme = Theme::get();
    const double left = std::max<double>(lanes.xOf(contact.from_s), row.left());
    const double right = std::min<double>(lanes.xOf(contact.to_s), row.right() + 1);
    const double in_x = lanes.xOf(review_.time().in()), out_x = lanes.xOf(review_.time().out());
    const QRectF bar(left, row.top(), right - left, row.height());
    const double line = theme.px(kByHandLine);
    const auto part = [&](double from, double to, double opacity) {
        if (to <= from)
            return;
        painter.save();
        painter.setClipRect(QRectF(from, row.top(), to - from, row.height() + 2 * line));
        painter.setOpacity(opacity);
        painter.setBrush(is_chosen ? theme.tokens().acc : theme.tokens().edge);
        painter.drawRoundedRect(bar, theme.px(2), theme.px(2));
        if (contact.by_hand)
            painter.fillRect(QRectF(left, row.bottom() + 1 + line / 2, right - left, line / 2 + 0.5),
                             is_chosen ? theme.tokens().acc : theme.tokens().t1);
        painter.restore();
    };
    part(left, std::min(right, in_x), kOutsideRange);
    part(std::max(left, in_x), std::min(right, out_x), 1);
    part(std::max(left, out_x), right, kOutsideRange);
}

}  // namespace noctule::ui
