// SPDX-License-Identifier: Apache-2.0
// The feet's lanes of the timeline: a bar for each contact with the ground, as it was found or set by hand.
// Bars are dragged whole or by an end; a double click where nothing is adds one. Keys: Up and Down choose the
// contact of the left or right foot at the cursor, Ctrl with Left and Right the one before or after it, Ins
// adds one at the cursor, I and O let the chosen one begin or end there, Del deletes it, Esc lets go of it.
#pragma once

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <array>
#include <optional>

#include "ui/models/review_context.h"

namespace noctule::ui {

/// Where the lanes stand on the timeline: pixels, and times by pixels.
struct ContactLanes {
    std::array<QRect, 2> feet;  ///< the bars of the left and of the right foot
    int reach_px;               ///< above and below them that counts, and beside their ends
    double from_s, px_per_s;    ///< at the left of the lanes

    double xOf(double t_s) const { return feet[0].left() + (t_s - from_s) * px_per_s; }
    double timeAt(double x_px) const { return from_s + (x_px - feet[0].left()) / px_per_s; }
};

/// 0: the left foot's.
int laneOf(const std::string& foot);

class ContactBars {
    Q_DECLARE_TR_FUNCTIONS(ContactBars)
public:
    explicit ContactBars(ReviewContext& review) : review_(review) {}

    bool hasChosen() const { return chosenContact() != nullptr; }
    /// "Left foot stands from 0:17.20 to 0:17.94, set by hand"; empty when none is chosen.
    QString chosenWords() const { return wordsOf(chosen_); }
    /// Middle of the chosen bar, or where the cursor crosses the chosen lane.
    std::optional<QPoint> chosenPoint(const ContactLanes& lanes) const;
    void letGo();

    void paint(QPainter& painter, const ContactLanes& lanes) const;
    QString tooltipAt(const ContactLanes& lanes, const QPoint& position) const;
    bool isOnEnd(const ContactLanes& lanes, const QPoint& position) const;

    // True: it was for a bar or its lane.
    bool press(const ContactLanes& lanes, const QPoint& position);
    bool drag(const ContactLanes& lanes, const QPoint& position);
    bool release();
    bool doubleClick(const ContactLanes& lanes, const QPoint& position);
    bool key(const QKeyEvent& event);
    /// Of the bar or lane there, which it chooses.
    bool fillMenu(QMenu& menu, const ContactLanes& lanes, const QPoint& position);

    void addAtCursor();
    void removeChosen();
    void restoreFound();

private:
    enum class Part { kFrom, kTo, kAll };
    struct Hit {
        int lane;
        ContactPlace place;  ///< index -1: where nothing is
        Part part;
    };
    struct Drag {
        ContactPlace place;
        FootContact before, now;
        Part part;
        double grabbed_s;
    };
    const FootContact* contactAt(const ContactPlace& place) const;
    const FootContact* chosenContact() const { return contactAt(chosen_); }
    QString wordsOf(const ContactPlace& place) const;
    std::optional<Hit> hitAt(const ContactLanes& lanes, const QPoint& position) const;
    std::string footOf(int lane) const;
    void paintTitles(QPainter& painter, const ContactLanes& lanes) const;
    void paintBar(QPainter& painter, const ContactLanes& lanes, const QRect& row, const FootContact& contact,
                  bool is_chosen) const;
    void add(const std::string& foot, double t_s);
    void put(const ContactPlace& place, const FootContact& wanted);
    void fillEdits(QMenu& menu);
    void beginAtCursor();
    void endAtCursor();
    void chooseAt(int lane);
    void walk(int direction);
    bool edit(int key);
    void tellFirst(bool were_edited);

    ReviewContext& review_;
    ContactPlace chosen_{};  ///< a foot without an index: its lane
    std::optional<Drag> drag_{};
};

}  // namespace noctule::ui
