// SPDX-License-Identifier: Apache-2.0
// What the plots show: which tabs are on, and for each kind of curve what is chosen in the studio's selection
// and what the operator added beside it.
#pragma once

#include <QObject>
#include <set>
#include <vector>

#include "ui/models/review_context.h"

namespace noctule::ui {

enum class PlotTab { kConfidence, kRanges, kRawSound, kInertial, kJointAngles, kRoot, kBetween };
inline constexpr int kPlotTabs = 7;

struct PairChannel {
    int source = 0, board = 0;
    auto operator<=>(const PairChannel&) const = default;
};

class PlotChannels : public QObject {
    Q_OBJECT
public:
    PlotChannels(ReviewContext& review, QObject* parent = nullptr);

    bool isOn(PlotTab tab) const { return tabs_.contains(tab); }
    void setOn(PlotTab tab, bool on);

    // The chosen one first, then what was added.
    std::vector<PairChannel> pairs() const;
    std::vector<int> boards() const;
    /// Angles of the chosen joint, then the added ones, as far as the skeleton has them.
    std::vector<CurveChoice> angles(const Skeleton& skeleton) const;

    bool hasPair(PairChannel pair) const { return pairs_.contains(pair); }
    bool hasBoard(int board) const { return boards_.contains(board); }
    bool hasAngle(const CurveChoice& angle) const { return angles_.contains(angle); }
    static constexpr size_t kMostAdded = 8;
    bool hasAny() const { return !pairs_.empty() || !boards_.empty() || !angles_.empty(); }
    /// Switches on a tab that shows it when none does. At most kMostAdded of a kind; more are not taken.
    void setPair(PairChannel pair, bool shown);
    void setBoard(int board, bool shown);
    void setAngle(const CurveChoice& angle, bool shown);
    void removeAll();

signals:
    void changed();

private:
    void switchOnOneOf(std::initializer_list<PlotTab> tabs);
    void saveTabs() const;

    ReviewContext& review_;
    std::set<PlotTab> tabs_;
    std::set<PairChannel> pairs_;
    std::set<int> boards_;
    std::set<CurveChoice> angles_;
};

}  // namespace noctule::ui
