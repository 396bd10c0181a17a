// SPDX-License-Identifier: Apache-2.0
#include "ui/style/resources.h"

#include <QFile>
#include <stdexcept>

// A static library's resources reach the program only when they are named; the macro wants the global
// namespace.
static void nameResources() {
    Q_INIT_RESOURCE(studio);
}

namespace noctule::ui {

QString resourcePath(const QString& name) {
    nameResources();
    return ":/noctule/" + name;
}

QByteArray resourceBytes(const QString& name) {
    QFile file(resourcePath(name));
    if (!file.open(QIODevice::ReadOnly))
        throw std::logic_error("the program was built without the resource " + name.toStdString());
    return file.readAll();
}

}  // namespace noctule::ui
