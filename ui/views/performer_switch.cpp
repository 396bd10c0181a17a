// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer_switch.h"

#include <QCoreApplication>
#include <QToolButton>

#include "ui/style/performer_disc.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

namespace {
constexpr int kSwitchDisc = 18, kSwitchPadding = 24, kSwitchHeight = 28;  // pixels at 100 percent
}

QString performerName(const TakeDocument& take, int index) {
    const std::string& name = take.subjects()[static_cast<size_t>(index)].name;
    return name.empty()
               ? QCoreApplication::translate("PerformerSwitch", "Performer %1").arg(performerLetter(index))
               : QString::fromStdString(name);
}

PerformerSwitch::PerformerSwitch(Studio& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), row_(makeRow(this, {12, 4, 12, 4}, 4)) {
    row_->addWidget(new Label(tr("Shown"), TextRole::kSecondary, Ink::kHint));
    row_->addStretch();
    connect(&studio.take(), &TakeDocument::opened, this, &PerformerSwitch::refresh);
    connect(&Theme::get(), &Theme::changed, this, &PerformerSwitch::decorate);
    refresh();
}

void PerformerSwitch::showNext(TakeDocument& take) {
    const int count = static_cast<int>(take.subjects().size());
    if (count > 1)
        take.setSubject((take.subject() + 1) % count);
}

void PerformerSwitch::refresh() {
    TakeDocument& take = studio_.take();
    const size_t count = take.isOfSeveral() ? take.subjects().size() : 0;
    while (buttons_.size() > count) {
        delete buttons_.back();
        buttons_.pop_back();
    }
    while (buttons_.size() < count) {
        const int index = static_cast<int>(buttons_.size());
        auto* button = new QToolButton;
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        connect(button, &QToolButton::clicked, this, [this, index] {
            studio_.take().setSubject(index);
            refresh();  // a click on the shown one does not switch it off
        });
        row_->insertWidget(row_->count() - 1, button);
        buttons_.push_back(button);
    }
    for (size_t i = 0; i < count; ++i) {
        const QString name = performerName(take, static_cast<int>(i));
        buttons_[i]->setText(name);
        buttons_[i]->setAccessibleName(tr("Show %1", "a performer").arg(name));
        buttons_[i]->setChecked(static_cast<int>(i) == take.subject());
    }
    decorate();
    setVisible(count > 0);
}

void PerformerSwitch::decorate() {
    const Theme& theme = Theme::get();
    const int size_px = theme.px(kSwitchDisc);
    for (size_t i = 0; i < buttons_.size(); ++i) {
        QToolButton& button = *buttons_[i];
        button.setFont(theme.font(TextRole::kBody, button.isChecked()));
        button.setIconSize({size_px, size_px});
        button.setIcon(performerPixmap(static_cast<int>(i), size_px, devicePixelRatioF()));
        const QFontMetrics metrics(theme.font(TextRole::kBody, true));
        button.setFixedSize(metrics.horizontalAdvance(button.text()) + size_px + theme.px(kSwitchPadding),
                            std::max(theme.px(kSwitchHeight), metrics.height()));
    }
}

}  // namespace noctule::ui
