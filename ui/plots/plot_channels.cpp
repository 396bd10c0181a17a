// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/plot_channels.h"

#include <QVariant>
#include <algorithm>

namespace noctule::ui {
namespace {

const QString kTabsKey = QStringLiteral("review/plot_tabs");

template <class Set, class Item>
bool put(Set& set, const Item& item, bool in) {
    if (in && set.size() >= PlotChannels::kMostAdded)
        return false;
    return in ? set.insert(item).second : set.erase(item) > 0;
}

}  // namespace

PlotChannels::PlotChannels(ReviewContext& review, QObject* parent) : QObject(parent), review_(review) {
    const QVariant stored = review.shared().settings().value(kTabsKey);
    if (stored.isValid())
        for (const QVariant& tab : stored.toList())
            if (tab.toInt() >= 0 && tab.toInt() < kPlotTabs)
                tabs_.insert(static_cast<PlotTab>(tab.toInt()));
    if (tabs_.empty())
        tabs_ = {PlotTab::kConfidence, PlotTab::kJointAngles};
    connect(&review.selection(), &Selection::pairChanged, this, &PlotChannels::changed);
    connect(&review.selection(), &Selection::jointChanged, this, &PlotChannels::changed);
}

void PlotChannels::saveTabs() const {
    QVariantList list;
    for (const PlotTab tab : tabs_)
        list.append(static_cast<int>(tab));
    review_.shared().settings().setValue(kTabsKey, list);
}

void PlotChannels::setOn(PlotTab tab, bool on) {
    if (!put(tabs_, tab, on))
        return;
    saveTabs();
    emit changed();
}

std::vector<PairChannel> PlotChannels::pairs() const {
    const Selection& selection = review_.selection();
    const PairChannel chosen{selection.source(), selection.board()};
    std::vector<PairChannel> all;
    if (chosen.source >= 0 && chosen.board >= 0)
        all.push_back(chosen);
    std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(all),
                 [&](const PairChannel& pair) { return pair != chosen; });
    return all;
}

std::vector<int> PlotChannels::boards() const {
    const int chosen = review_.selection().board();
    std::vector<int> all;
    if (chosen >= 0)
        all.push_back(chosen);
    std::copy_if(boards_.begin(), boards_.end(), std::back_inserter(all),
                 [&](int board) { return board != chosen; });
    return all;
}

std::vector<CurveChoice> PlotChannels::angles(const Skeleton& skeleton) const {
    const std::string joint = review_.selection().joint().toStdString();
    const bool is_root = skeleton.size() > 0 && skeleton.joint(0).name == joint;
    std::vector<CurveChoice> all;
    const std::vector<CurveChoice> choices = curveChoices(skeleton);
    for (const CurveChoice& choice : choices)
        if (choice.joint == joint && !is_root)
            all.push_back(choice);
    for (const CurveChoice& choice : choices)
        if (angles_.contains(choice) && (choice.joint != joint || is_root))
            all.push_back(choice);
    return all;
}

void PlotChannels::switchOnOneOf(std::initializer_list<PlotTab> tabs) {
    if (std::none_of(tabs.begin(), tabs.end(), [this](PlotTab tab) { return isOn(tab); }))
        tabs_.insert(*tabs.begin());
}

void PlotChannels::setPair(PairChannel pair, bool shown) {
    if (!put(pairs_, pair, shown))
        return;
    switchOnOneOf({PlotTab::kConfidence, PlotTab::kRanges});
    emit changed();
}

void PlotChannels::setBoard(int board, bool shown) {
    if (!put(boards_, board, shown))
        return;
    switchOnOneOf({PlotTab::kInertial, PlotTab::kRawSound});
    emit changed();
}

void PlotChannels::setAngle(const CurveChoice& angle, bool shown) {
    if (!put(angles_, angle, shown))
        return;
    switchOnOneOf({PlotTab::kJointAngles});
    emit changed();
}

void PlotChannels::removeAll() {
    pairs_.clear();
    boards_.clear();
    angles_.clear();
    emit changed();
}

}  // namespace noctule::ui
