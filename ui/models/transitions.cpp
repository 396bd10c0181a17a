// SPDX-License-Identifier: Apache-2.0
#include "ui/models/transitions.h"

namespace noctule::ui {

Q_LOGGING_CATEGORY(phases, "noctule.phases")

}  // namespace noctule::ui
