// SPDX-License-Identifier: Apache-2.0
// Time of the take: contacts of both feet (ContactBars), ruler, in and out as grips, markers as flags, gaps
// hatched, and the time cursor with its label. A click or drag moves the cursor, grips move in and out; a
// click on a flag chooses its marker, a double click or F2 names it, Del deletes it. To a screen reader and
// to the keyboard it is a slider.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"
#include "ui/plots/contact_bars.h"
#include "ui/plots/repaint_limit.h"
#include "ui/plots/time_window.h"

namespace noctule::ui {

class Timeline : public QWidget {
    Q_OBJECT
public:
    /// `window`: the plots' (PlotPanel::window()).
    Timeline(ReviewContext& review, TimeWindow& window, QWidget* parent = nullptr);

    int chosenMarker() const { return chosen_marker_; }  ///< index into overview()->markers, -1: none
    bool canEditMarker() const;                          ///< the chosen one
    /// "0:17.40 of 0:36", and the contact that is chosen: value for screen readers.
    QString valueText() const;
    TimeCursor& time() const { return review_.time(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// Middle of a grip, of the ruler or of a flag at a time; for tests and help.
    QPoint inGrip() const;
    QPoint outGrip() const;
    QPoint rulerPoint(double t_s) const;
    QPoint flagPoint(double t_s) const;
    QPoint footPoint(int foot, double t_s) const;
    ContactBars& contactBars() { return bars_; }

public slots:
    /// Moves the cursor to the next marker after it (1) or the last before it (-1).
    void goToMarker(int direction);
    /// Opens a field for the chosen marker's name.
    void nameMarker();
    void deleteMarker();
    /// The contact that is chosen, else the marker.
    void deleteChosen();
    /// At the cursor; one that is there already is chosen.
    void addContact();
    /// All contacts as they were found.
    void restoreFoundContacts();

signals:
    /// Or the chosen contact.
    void chosenMarkerChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Grip { kNone, kTime, kIn, kOut, kWindow };
    /// Where things stand, top to bottom.
    struct Rows {
        int left, right;
        std::array<QRect, 2> feet;
        QRect ruler, labels, overview;
    };
    Rows rows() const;
    double xOf(double t_s) const;
    double timeAt(double x_px) const;
    Grip gripAt(const QPoint& position) const;
    int markerAt(const QPoint& position) const;
    void chooseMarker(int marker);
    void chooseWritten(const MarkerChange& change);
    /// -1: the take has no such marker now.
    int indexOf(const UserMarker& marker) const;
    void followChosenMarker();
    QString tooltipAt(const QPoint& position) const;
    ContactLanes contactLanes() const;
    void contactChosen();
    bool editMarker(const QKeyEvent& event);
    bool markerMenu(QMenu& menu, int marker);
    void dragTo(double x_px);
    void readTake();
    void showTime();
    QRect labelRect(const Rows& rows) const;

    void paintRuler(QPainter& painter, const Rows& rows) const;
    void paintGaps(QPainter& painter, const Rows& rows) const;
    void paintMarkers(QPainter& painter, const Rows& rows) const;
    void paintMarkerName(QPainter& painter, const Rows& rows, size_t marker) const;
    void paintOverview(QPainter& painter, const Rows& rows) const;
    void paintCursor(QPainter& painter, const Rows& rows) const;

    ReviewContext& review_;
    TimeWindow& window_;
    std::shared_ptr<const TakeOverview> overview_;
    ContactBars bars_;
    RepaintLimit repaint_;
    Grip grip_ = Grip::kNone;
    double grip_offset_px_ = 0;
    int chosen_marker_ = -1;
    std::optional<UserMarker> chosen_{};  ///< time and name: finds it again when the take has been read anew
};

}  // namespace noctule::ui
