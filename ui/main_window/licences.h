// SPDX-License-Identifier: Apache-2.0
// What the program is made of, and under which terms.
#pragma once

#include <QList>
#include <QString>

namespace noctule::ui {

struct LinkedWork {
    QString name, version, licence, what_for, address;
};

/// Everything that is linked or compiled in, versions as at run time where the library tells.
QList<LinkedWork> linkedWorks();
/// As plain text, for the clipboard.
QString licencesAsText(const QString& software);

}  // namespace noctule::ui
