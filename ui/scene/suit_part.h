// SPDX-License-Identifier: Apache-2.0
// A board or a source of a suit.
#pragma once

#include <QMetaType>

namespace noctule::ui {

struct SuitPart {
    enum class Kind { kNone, kBoard, kSource } kind = Kind::kNone;
    int index = -1;
    bool operator==(const SuitPart&) const = default;
};

}  // namespace noctule::ui

Q_DECLARE_METATYPE(noctule::ui::SuitPart)
