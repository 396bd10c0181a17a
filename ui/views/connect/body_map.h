// SPDX-License-Identifier: Apache-2.0
// A suit on its performer, seen from the front: every board and source is a button on the drawing, boards
// have names in two columns with leaders. The performer's left is on the right, and it says so. Anchors that
// nobody wears hang in their room, seen from above. Arrow keys walk.
#pragma once

#include <QAbstractButton>
#include <QMouseEvent>
#include <QPixmap>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/style/ink.h"
#include "ui/views/body_figure.h"
#include "ui/views/connect/room_plan.h"

namespace noctule::ui {

class MapMarker;

class BodyMap : public QWidget {
    Q_OBJECT
public:
    BodyMap(const Actor& actor, const Suit& suit, const std::shared_ptr<const SkinnedMesh>& mesh,
            QWidget* parent = nullptr);

    /// Another figure below the marks.
    void setBody(const std::shared_ptr<const SkinnedMesh>& mesh);
    /// What stands below a board's name, and the tone of its mark and segment.
    void setBoardState(int board, Tone tone, const QString& detail);
    const Suit& suit() const { return suit_; }
    /// Of anchors; there is no body then.
    bool showsRoom() const { return room_.has_value(); }
    void setSourceTone(int source, Tone tone, const QString& detail);
    /// Marked as the one that is talked about; -1: none.
    void setChosen(int board);
    /// Whether boards can be dragged onto the places of others.
    void setBoardsMovable(bool movable) { movable_ = movable; }
    int boardCount() const { return static_cast<int>(suit_.boards.size()); }
    int sourceCount() const { return static_cast<int>(suit_.sources.size()); }
    QAbstractButton* boardButton(int board) const;
    QAbstractButton* sourceButton(int source) const;
    /// From a board to where its leader turns to the label; for tests.
    QLineF leaderOf(int board) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void boardClicked(int board);
    void sourceClicked(int source);
    /// Dragged onto the place of another.
    void boardDropped(int board, int onto);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static constexpr int kTop = 36, kBottom = 12;  ///< pixels above and below the drawing
    static constexpr int kLabelWidth = 136, kLabelGap = 20, kLeader = 28;

    struct Place {
        MapMarker* marker;
        QPointF at_m;
        bool is_board;
        int index;
        bool left_column = false;  ///< of the picture
        QPointF at_px{};
        double label_y = 0;  ///< centre of its label, in pixels
    };
    QPointF placeOf(const Place& place) const;
    double scale(int height_px) const;
    double half_width_m() const;
    void addMarkers();
    void chooseColumns();
    void arrange();
    void separateMarkers();
    void spreadLabels(bool left_column);
    void stack(const std::vector<Place*>& column) const;
    bool leaderHits(const Place& inner, const Place& outer) const;
    int labelEdge(bool left_column) const;
    QLineF leader(const Place& place) const;
    /// As high as there is room, and no wider than the labels leave.
    int drawingHeight() const;
    /// Where the figure stands, in pixels from the top; in the middle of what it does not fill.
    double floor() const;
    QPointF toPixels(const QPointF& p_m) const;
    double labelHeight() const;
    void paintGround(QPainter& painter);
    void paintLabel(QPainter& painter, const Place& place) const;
    void paintDragged(QPainter& painter) const;
    bool walk(const MapMarker* from, int key);
    bool drag(MapMarker* marker, const QMouseEvent& event);
    int boardNear(const QPointF& position) const;
    void renewFigure();

    Actor actor_;
    Suit suit_;
    std::shared_ptr<const BodyFigure> figure_;
    std::optional<RoomPlan> room_;  ///< instead of the figure
    std::vector<Place> places_;
    std::vector<QString> details_;
    bool movable_ = false;
    int chosen_ = -1, dragged_ = -1;  ///< boards
    QPoint pressed_at_, dragged_to_;
    QPixmap picture_;       ///< null: to be painted again
    bool painted_ = false;  ///< at least once
};

}  // namespace noctule::ui
