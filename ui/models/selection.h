// SPDX-License-Identifier: Apache-2.0
// What the operator points at: a source-board pair and a joint. Choosing a cell of the heat map chooses the
// curve, the ray and the board everywhere. -1 and empty: none.
#pragma once

#include <QObject>
#include <QString>

namespace noctule::ui {

class Selection : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    int source() const { return source_; }
    int board() const { return board_; }
    const QString& joint() const { return joint_; }

public slots:
    void setPair(int source, int board);
    void setBoard(int board) { setPair(source_, board); }
    void setJoint(const QString& joint);

signals:
    void pairChanged(int source, int board);
    void jointChanged(const QString& joint);

private:
    int source_ = -1, board_ = -1;
    QString joint_;
};

}  // namespace noctule::ui
