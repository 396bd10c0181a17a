// SPDX-License-Identifier: Apache-2.0
// The OpenGL that 3D views are drawn with.
#pragma once

#include <QSurfaceFormat>

namespace noctule::ui {

inline QSurfaceFormat neededGlFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(3, 3);
    return format;
}

}  // namespace noctule::ui
