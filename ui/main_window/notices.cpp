// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/notices.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

constexpr size_t kMost = 2;  // in a window of 1280 x 800 more would push the page out

}  // namespace

Notices::Notices(QWidget* parent) : QWidget(parent), cards_(new QWidget) {
    auto* column = makeColumn(this, {16, 12, 16, 4}, 8);
    makeColumn(cards_, {}, 8);
    more_ = makeButton(ButtonKind::kText, {});
    column->addWidget(cards_);
    addRow(column)->addWidget(more_, 0, Qt::AlignLeft);
    connect(more_, &QPushButton::clicked, this, &Notices::step);
    hide();
}

/// Those that are shown go behind all others.
void Notices::step() {
    std::rotate(shown_.begin(), shown_.begin() + static_cast<int>(std::min(kMost, shown_.size())),
                shown_.end());
    for (const Shown& shown : shown_)
        cards_->layout()->addWidget(shown.card);  // at the end, from where it was
    arrange();
}

void Notices::add(const Notice& notice) {
    const QString topic = notice.topic.isEmpty() ? notice.title : notice.topic;
    remove(topic);
    auto* card = new ProblemCard(notice.tone, notice.title, notice.text);
    card->setClosable(true);
    connect(card, &ProblemCard::closed, this, [this, topic, closed = notice.closed] {
        remove(topic);
        if (closed)
            closed();
    });
    if (!notice.action.isEmpty())
        connect(card->addAction(notice.action), &QPushButton::clicked, this, [this, topic, act = notice.act] {
            remove(topic);
            act();
        });
    shown_.insert(shown_.begin(), {topic, card});
    static_cast<QVBoxLayout*>(cards_->layout())->insertWidget(0, card);
    arrange();
}

void Notices::remove(const QString& topic) {
    const auto found =
        std::find_if(shown_.begin(), shown_.end(), [&](const Shown& shown) { return shown.topic == topic; });
    if (found == shown_.end())
        return;
    found->card->hide();
    found->card->deleteLater();
    shown_.erase(found);
    arrange();
}

QStringList Notices::titles() const {
    QStringList titles;
    for (const Shown& shown : shown_)
        titles.append(shown.card->title());
    return titles;
}

void Notices::arrange() {
    for (size_t i = 0; i < shown_.size(); ++i)
        shown_[i].card->setVisible(i < kMost);
    const int hidden = static_cast<int>(shown_.size()) - static_cast<int>(kMost);
    more_->setText(tr("and %n more", "notices that are not shown", std::max(0, hidden)));
    more_->parentWidget()->setVisible(hidden > 0);
    setVisible(!shown_.empty());
}

}  // namespace noctule::ui
