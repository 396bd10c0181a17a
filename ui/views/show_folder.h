// SPDX-License-Identifier: Apache-2.0
// Opens a folder in the desktop's file manager. Where there is none, or it does not start, the studio says so
// and names the folder.
#pragma once

#include <QString>

namespace noctule::ui {

class SharedContext;

void showFolder(SharedContext& shared, const QString& folder);

}  // namespace noctule::ui
