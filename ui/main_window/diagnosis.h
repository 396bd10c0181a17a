// SPDX-License-Identifier: Apache-2.0
// What somebody who helps needs to know, as one text: versions, machine, settings, the suit's health, the
// newest of the log. Personal data is taken out: folders of the user, names of performers, sessions and
// takes.
#pragma once

#include <QStringList>

#include "ui/models/log_file.h"
#include "ui/models/studio.h"

namespace noctule::ui {

QString diagnosisText(Studio& studio, const LogFile& log);

/// Each of the words becomes "[name]", paths become "[path]/" and their last part's suffix, the user's name
/// "[user]".
QString withoutPersonalData(QString text, const QStringList& names);

}  // namespace noctule::ui
