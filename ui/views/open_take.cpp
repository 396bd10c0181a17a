// SPDX-License-Identifier: Apache-2.0
#include "ui/views/open_take.h"

#include <QFileInfo>

namespace noctule::ui {

int openTakeIndex(Studio& studio) {
    if (!studio.take().isOpen() || !studio.session().isOpen())
        return -1;
    const QString open = QFileInfo(studio.take().path()).canonicalFilePath();
    const Session& session = studio.session().session();
    for (size_t i = 0; i < session.takes.size(); ++i) {
        const QFileInfo take(studio.session().takePath(static_cast<int>(i)));
        if (take.fileName() == QFileInfo(open).fileName() && take.canonicalFilePath() == open)
            return static_cast<int>(i);
    }
    return -1;
}

QString openTakeName(Studio& studio) {
    return studio.take().isOpen() ? QFileInfo(studio.take().path()).completeBaseName() : QString();
}

}  // namespace noctule::ui
