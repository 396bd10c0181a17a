// SPDX-License-Identifier: Apache-2.0
// F6: the keyboard goes from panel to panel, to where it was last in each.
#pragma once

#include <QList>
#include <QWidget>

namespace noctule::ui {

/// From the panel that has the focus to the next visible one, around the end.
void walkPanels(const QList<QWidget*>& panels, bool forward);

}  // namespace noctule::ui
