// SPDX-License-Identifier: Apache-2.0
#include "devices/machine/random_uuid.h"

#include <QUuid>

namespace noctule {

std::string randomUuid() {
    return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

}  // namespace noctule
