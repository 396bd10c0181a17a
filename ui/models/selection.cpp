// SPDX-License-Identifier: Apache-2.0
#include "ui/models/selection.h"

namespace noctule::ui {

void Selection::setPair(int source, int board) {
    if (source == source_ && board == board_)
        return;
    source_ = source, board_ = board;
    emit pairChanged(source_, board_);
}

void Selection::setJoint(const QString& joint) {
    if (joint == joint_)
        return;
    joint_ = joint;
    emit jointChanged(joint_);
}

}  // namespace noctule::ui
