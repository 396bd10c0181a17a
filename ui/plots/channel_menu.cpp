// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/channel_menu.h"

#include <QCoreApplication>

#include "ui/models/part_names.h"
#include "ui/plots/curve_names.h"

namespace noctule::ui {
namespace {

QString menuWords(const char* text) {
    return QCoreApplication::translate("ChannelMenu", text);
}

template <class Slot>
void addCheck(QMenu& menu, const QString& text, bool checked, Slot slot) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    QObject::connect(action, &QAction::toggled, &menu, slot);
}

void fillPairs(QMenu& menu, const Suit& suit, PlotChannels& channels) {
    for (int s = 0; s < static_cast<int>(suit.sources.size()); ++s) {
        QMenu* of_source = menu.addMenu(sourceTitle(suit, s));
        for (int b = 0; b < static_cast<int>(suit.boards.size()); ++b) {
            const PairChannel pair{s, b};
            addCheck(*of_source, boardTitle(suit, b), channels.hasPair(pair),
                     [&channels, pair](bool shown) { channels.setPair(pair, shown); });
        }
    }
}

void fillAngles(QMenu& menu, const Skeleton& skeleton, PlotChannels& channels) {
    QMenu* of_joint = nullptr;
    std::string joint;
    for (const CurveChoice& choice : curveChoices(skeleton)) {
        if (!of_joint || choice.joint != joint) {
            joint = choice.joint;
            of_joint = menu.addMenu(jointName(joint));
        }
        addCheck(*of_joint, freedomName(choice.freedom), channels.hasAngle(choice),
                 [&channels, choice](bool shown) { channels.setAngle(choice, shown); });
    }
}

void fillBoards(QMenu& menu, const Suit& suit, PlotChannels& channels) {
    for (int b = 0; b < static_cast<int>(suit.boards.size()); ++b)
        addCheck(menu, boardTitle(suit, b), channels.hasBoard(b),
                 [&channels, b](bool shown) { channels.setBoard(b, shown); });
}

}  // namespace

void fillChannelMenu(QMenu& menu, ReviewContext& review, PlotChannels& channels) {
    qDeleteAll(menu.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
    menu.clear();
    const auto overview = review.take().overview();
    if (!overview) {
        menu.addAction(menuWords(QT_TRANSLATE_NOOP("ChannelMenu", "Open a take first")))->setEnabled(false);
        return;
    }
    fillPairs(*menu.addMenu(menuWords(QT_TRANSLATE_NOOP("ChannelMenu", "Pairs"))), *review.take().pairSuit(),
              channels);
    if (const auto motion = review.take().shownMotion())
        fillAngles(*menu.addMenu(menuWords(QT_TRANSLATE_NOOP("ChannelMenu", "Joint angles"))),
                   motion->skeleton, channels);
    fillBoards(*menu.addMenu(menuWords(QT_TRANSLATE_NOOP("ChannelMenu", "Boards"))), overview->suit,
               channels);
    menu.addSeparator();
    QAction* remove = menu.addAction(menuWords(QT_TRANSLATE_NOOP("ChannelMenu", "Remove added channels")));
    remove->setEnabled(channels.hasAny());
    QObject::connect(remove, &QAction::triggered, &channels, &PlotChannels::removeAll);
}

}  // namespace noctule::ui
