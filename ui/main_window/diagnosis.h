// SPDX-License-Identifier: Apache-2.0
// What somebody who helps needs to know, as one text: versions, machine, settings, the suit's health, the
// newest of the log. Personal data is taken out: folders of the user, names of performers, sessions and
// takes, also of sessions that were open before.
#pragma once

#include <QString>

#include "ui/models/log_file.h"
#include "ui/models/studio.h"

namespace noctule::ui {

QString diagnosisText(Studio& studio, const LogFile& log);

}  // namespace noctule::ui
