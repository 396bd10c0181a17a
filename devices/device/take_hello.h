// SPDX-License-Identifier: Apache-2.0
// What the driver box that recorded a take said of itself, as far as the take knows it.
#pragma once

#include "core/recording/take.h"
#include "devices/driver_box/hello.h"

namespace noctule {

/// `suit`: of the take, the one in view. The serial number is `otherwise` when the take names none.
link::Hello helloOf(const Take& take, const Suit& suit, const std::string& otherwise);

}  // namespace noctule
