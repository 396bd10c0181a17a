// SPDX-License-Identifier: Apache-2.0
// Which contacts of the feet hold for a run of a take: for exports, pictures and screens alike.
#pragma once

#include <vector>

#include "core/motion/foot_contacts.h"
#include "core/recording/take.h"

namespace noctule {

/// Whose word it is.
enum class ContactsFrom {
    kOperator,  ///< set by hand, for all runs
    kRun,       ///< the run found them in the readings
    kMotion,    ///< found here in the run's poses (findFootContacts), for it did not look itself
};

struct ContactsInForce {
    std::vector<FootContacts> feet;  ///< seconds of the take's clock, with slides; may lack a foot
    ContactsFrom from = ContactsFrom::kMotion;
};

/// Of the pose run whose motion that is: the operator's if they were set (also when there are none), else the
/// run's own if it looked for any, else as the motion shows it. Errors of reading the take are passed on.
Result<ContactsInForce> contactsInForce(const Take& take, const DerivedRun& run, const TimedMotion& motion);

}  // namespace noctule
