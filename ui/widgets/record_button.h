// SPDX-License-Identifier: Apache-2.0
// The big record button: a ring of 84 px around a disc of 66. A disc records, a square stops, the digit
// counts down, the ring runs while the take is saved. Refused it stays enabled: pressing it tells why.
#pragma once

#include <QAbstractButton>
#include <QElapsedTimer>
#include <QTimer>

namespace noctule::ui {

class RecordButton : public QAbstractButton {
    Q_OBJECT
public:
    enum class State { kReady, kCountdown, kRecording, kSaving, kRefused };

    explicit RecordButton(QWidget* parent = nullptr);

    void setState(State state);
    State state() const { return state_; }
    /// In kCountdown: what is left of it.
    void setCountdown(double left_s, double of_s);
    /// What stands in the disc while it counts: 3, 2, 1; 0 in other states.
    int digit() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool hitButton(const QPoint& position) const override;

private:
    void paintRing(QPainter& painter, const QPointF& centre) const;
    void paintDisc(QPainter& painter, const QPointF& centre) const;
    void tellName();

    State state_ = State::kReady;
    double left_s_ = 0, of_s_ = 1;
    QTimer pulse_;
    QElapsedTimer since_;
};

}  // namespace noctule::ui
