// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heard_switch.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QToolButton>
#include <algorithm>

#include "ui/style/performer_disc.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kHeardDisc = 16, kHeardPadding = 20, kHeardHeight = 26;  // pixels at 100 percent

QString translated(const char* text) {
    return QCoreApplication::translate("HeardSwitch", text);
}

bool isPerson(const TakeDocument& take, int party) {
    return party < static_cast<int>(take.subjects().size());
}

}  // namespace

QString heardWords(const TakeDocument& take, int party) {
    if (party == take.subject())
        return translated(QT_TRANSLATE_NOOP("HeardSwitch", "Own"));
    const QString to = performerLetter(take.subject());
    return isPerson(take, party)
               ? translated(QT_TRANSLATE_NOOP("HeardSwitch", "%1 to %2")).arg(performerLetter(party), to)
               : translated(QT_TRANSLATE_NOOP("HeardSwitch", "Room to %1")).arg(to);
}

QString heardWords(const TakeDocument& take) {
    return heardWords(take, take.sourcesOf());
}

HeardSwitch::HeardSwitch(ReviewContext& review, QWidget* parent)
    : QWidget(parent), review_(review), row_(new QHBoxLayout(this)) {
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(4);
    row_->addStretch();
    connect(&review.take(), &TakeDocument::opened, this, &HeardSwitch::refresh);
    connect(&review.take(), &TakeDocument::rangesChanged, this, &HeardSwitch::refresh);
    connect(&Theme::get(), &Theme::changed, this, &HeardSwitch::decorate);
    refresh();
}

void HeardSwitch::refresh() {
    const TakeDocument& take = review_.take();
    const size_t parties = take.isOpen() ? take.overview()->parties.size() : 0;
    const size_t count = parties > 1 ? parties : 0;
    while (buttons_.size() > count) {
        delete buttons_.back();
        buttons_.pop_back();
    }
    while (buttons_.size() < count) {
        const int party = static_cast<int>(buttons_.size());
        auto* button = new QToolButton;
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        connect(button, &QToolButton::clicked, this, [this, party] {
            review_.take().setSourcesOf(party);
            refresh();  // a click on the chosen one does not switch it off
        });
        row_->insertWidget(row_->count() - 1, button);
        buttons_.push_back(button);
    }
    for (size_t i = 0; i < count; ++i) {
        buttons_[i]->setText(heardWords(take, static_cast<int>(i)));
        buttons_[i]->setChecked(static_cast<int>(i) == take.sourcesOf());
    }
    decorate();
    setVisible(count > 0);
}

void HeardSwitch::decorate() {
    const Theme& theme = Theme::get();
    const int size_px = theme.px(kHeardDisc);
    for (size_t i = 0; i < buttons_.size(); ++i) {
        QToolButton& button = *buttons_[i];
        const bool person = isPerson(review_.take(), static_cast<int>(i));
        button.setFont(theme.font(TextRole::kSecondary, button.isChecked()));
        button.setIconSize({size_px, size_px});
        button.setIcon(person ? QIcon(performerPixmap(static_cast<int>(i), size_px, devicePixelRatioF()))
                              : QIcon());
        const QFontMetrics metrics(theme.font(TextRole::kSecondary, true));
        button.setFixedSize(
            metrics.horizontalAdvance(button.text()) + (person ? size_px : 0) + theme.px(kHeardPadding),
            std::max(theme.px(kHeardHeight), metrics.height()));
    }
}

}  // namespace noctule::ui
