// SPDX-License-Identifier: Apache-2.0
// A small picture of a take, the body in the middle of its motion, made once by a quiet job and then kept in
// the desktop's cache of this program.
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

namespace noctule::ui {

class SharedContext;

/// `done` runs on the interface's thread, and not at all when there is no picture. It must not outlive what
/// it touches.
void takePicture(SharedContext& shared, const QString& take_path, const QSize& size_px,
                 std::function<void(const QImage&)> done);

}  // namespace noctule::ui
