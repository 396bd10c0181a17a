// SPDX-License-Identifier: Apache-2.0
#include "ui/views/open_take.h"

#include <QFileInfo>

namespace noctule::ui {

int openTakeIndex(ReviewContext& review) {
    if (!review.take().isOpen() || !review.shared().session().isOpen())
        return -1;
    const QString open = QFileInfo(review.take().path()).canonicalFilePath();
    const Session& session = review.shared().session().session();
    for (size_t i = 0; i < session.takes.size(); ++i) {
        const QFileInfo take(review.shared().session().takePath(static_cast<int>(i)));
        if (take.fileName() == QFileInfo(open).fileName() && take.canonicalFilePath() == open)
            return static_cast<int>(i);
    }
    return -1;
}

QString openTakeName(ReviewContext& review) {
    return review.take().isOpen() ? QFileInfo(review.take().path()).completeBaseName() : QString();
}

}  // namespace noctule::ui
