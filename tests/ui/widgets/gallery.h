// SPDX-License-Identifier: Apache-2.0
// Every shared widget once, arranged as the screens arrange them; for tests and for looking at.
#pragma once

#include <QWidget>
#include <memory>

namespace noctule::ui {

std::unique_ptr<QWidget> makeGallery();

}  // namespace noctule::ui
