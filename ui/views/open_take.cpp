// SPDX-License-Identifier: Apache-2.0
#include "ui/views/open_take.h"

#include <QFileInfo>

namespace noctule::ui {

int openTakeIndex(ReviewContext& review) {
    return review.take().isOpen() ? review.shared().session().indexOf(review.take().path()) : -1;
}

QString openTakeName(ReviewContext& review) {
    return review.take().isOpen() ? QFileInfo(review.take().path()).completeBaseName() : QString();
}

}  // namespace noctule::ui
