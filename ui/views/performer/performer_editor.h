// SPDX-License-Identifier: Apache-2.0
// What the performer page works on: one performer of the session, and one board or source of the suit on that
// body. Every change is a step on the session's undo stack; everything shown is read from the session again.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "core/session/body_measures.h"
#include "core/session/placement.h"
#include "ui/models/session_model.h"
#include "ui/scene/suit_part.h"

namespace noctule::ui {

class PerformerEditor : public QObject {
    Q_OBJECT
public:
    explicit PerformerEditor(SessionModel& session, QObject* parent = nullptr);

    SessionModel& session() { return session_; }
    bool hasPerformer() const { return index_ >= 0; }
    int index() const { return index_; }
    /// Only while there is one.
    const Performer& performer() const;
    /// In the performer's measures.
    const Actor& actor() const { return actor_; }
    /// The suit as it comes, placed on this body.
    const Suit& suitsPlaces() const { return suits_places_; }

    SuitPart part() const { return part_; }
    const Board* board() const;    ///< null: none is chosen
    const Source* source() const;  ///< null: none is chosen
    QString partTitle() const;

    /// How far a part is from where the suit has it; absent when the suit does not know it.
    struct Offset {
        double distance_m = 0, angle_rad = 0;
    };
    std::optional<Offset> offsetOf(SuitPart part) const;
    /// Whether the suit that comes with Noctule has the chosen part.
    bool isKnownToSuit() const;
    bool hasOtherSide() const;

    void choose(int performer);
    void choosePart(SuitPart part);

    void add();
    void duplicate();
    void remove();
    void rename(const QString& name);
    void wearSuit();  ///< becomes the performer of the next takes

    void setHeight(double height_m);
    void setLength(double BodyMeasures::*length, double length_m);  ///< 0: in proportion

    // Of the chosen part.
    void setSegment(const std::string& segment);
    void setPosition(const Vector3d& p_segment_m);
    void setRotation(const Quaterniond& q_segment_board);
    void setDirection(const SourceDirection& direction);
    void mirror();
    void backToSuit();

    /// By the gizmo; all until endDrag() is one step.
    void drag(SuitPart part, const Vector3d& p_segment_m, const Quaterniond& q_segment);
    void endDrag() { ++drag_; }

signals:
    void performerChanged();  ///< another one, or what it holds
    void partChanged();       ///< another one is chosen

private:
    void follow();
    void followOpened();
    const Board* standardOf(const Board& board) const;
    const Source* standardOf(const Source& source) const;
    /// `wanted`, with a number when another performer than `own` has it.
    QString freeName(const QString& wanted, const std::string& own) const;
    void changeMeasures(const BodyMeasures& measures, const QString& what, const QString& key);
    void changePart(const QString& what, const QString& key, const std::function<void(Board&)>& change_board,
                    const std::function<void(Source&)>& change_source);

    SessionModel& session_;
    int index_ = -1;
    Actor actor_;
    Suit suits_places_;
    SuitPart part_;
    int drag_ = 0;
};

}  // namespace noctule::ui
