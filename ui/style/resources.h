// SPDX-License-Identifier: Apache-2.0
// What is compiled into the program: tokens, icons, fonts, bodies, motions. Everything of resources/ that the
// studio needs lies in the binary, so there is no search path and nothing to install beside it.
#pragma once

#include <QByteArray>
#include <QString>

namespace noctule::ui {

/// "bodies/mannequin.glb" -> ":/noctule/bodies/mannequin.glb", readable with QFile.
QString resourcePath(const QString& name);
/// All bytes of a resource; throws std::logic_error when the program was built without it.
QByteArray resourceBytes(const QString& name);

}  // namespace noctule::ui
