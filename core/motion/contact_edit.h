// SPDX-License-Identifier: Apache-2.0
// An operator's changes to the contacts of the feet. A foot's contacts stay in order and apart: one that
// comes to touch others becomes one with them.
#pragma once

#include "core/motion/foot_contacts.h"

namespace noctule {

/// Which contact of which foot; index -1: one that is not there yet.
struct ContactPlace {
    std::string foot;  ///< "LeftFoot"
    int index = -1;

    bool operator==(const ContactPlace&) const = default;
};

/// Null: there is no such contact.
const FootContact* findContact(const std::vector<FootContacts>& feet, const ContactPlace& place);

/// The contact of that foot at a time, or the one that begins next (else the last); index -1 without any.
ContactPlace contactNear(const std::vector<FootContacts>& feet, const std::string& foot, double t_s);

/// `wanted` instead of the contact that stands there, or as a new one; counts as set by hand. `place` is then
/// where it ended up.
std::vector<FootContacts> withContact(std::vector<FootContacts> feet, ContactPlace& place,
                                      const FootContact& wanted);

/// Without the contact that stands there.
std::vector<FootContacts> withoutContact(std::vector<FootContacts> feet, const ContactPlace& place);

}  // namespace noctule
