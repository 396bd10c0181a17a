// SPDX-License-Identifier: Apache-2.0
#include "core/processing/contacts_in_force.h"

#include "core/processing/pose_runs.h"

namespace noctule {

Result<ContactsInForce> contactsInForce(const Take& take, const DerivedRun& run, const TimedMotion& motion) {
    auto edited = take.editedContacts();
    if (!edited)
        return edited.error();
    ContactsInForce contacts;
    if (*edited) {
        contacts = {std::move(**edited), ContactsFrom::kOperator};
    } else if (const RunSettings settings = runSettings(run, {}, take.level());
               !settings.ground.empty() && settings.ground != "none" && !settings.contacts_edited) {
        auto found = take.contacts(run.run);
        if (!found)
            return found.error();
        contacts = {std::move(*found), ContactsFrom::kRun};
    } else {
        return ContactsInForce{findFootContacts(motion), ContactsFrom::kMotion};
    }
    measureSlides(motion, contacts.feet);
    return contacts;
}

}  // namespace noctule
