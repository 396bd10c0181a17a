// SPDX-License-Identifier: Apache-2.0
// Opens a folder in the desktop's file manager, or a file in the desktop's program for its kind. Where there
// is none, or it does not start, the studio says so and names the path.
#pragma once

#include <QString>

namespace noctule::ui {

class SharedContext;

void showFolder(SharedContext& shared, const QString& folder);
void openFile(SharedContext& shared, const QString& path);

}  // namespace noctule::ui
