// SPDX-License-Identifier: Apache-2.0
#include "ui/views/page.h"

namespace noctule::ui {

void Page::setDockTitles(const QString& left, const QString& right) {
    left_title_ = left;
    right_title_ = right;
    emit dockTitlesChanged();
}

}  // namespace noctule::ui
