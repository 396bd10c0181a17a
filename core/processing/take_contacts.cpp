// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_contacts.h"

#include <sstream>

#include "core/recording/take_edit.h"

namespace noctule {
namespace {

Status checkContacts(const std::string& path, const std::vector<FootContacts>& feet, double duration_s) {
    for (const FootContacts& foot : feet)
        for (const FootContact& contact : foot.contacts)
            if (!(contact.from_s >= 0 && contact.from_s < contact.to_s && contact.to_s <= duration_s)) {
                std::ostringstream message;
                message << path << ": a contact of " << foot.foot << " from " << contact.from_s << " to "
                        << contact.to_s << " s does not lie in the take of " << duration_s << " s";
                return Error{ErrorKind::kUsage, message.str(), "Set it between the take's start and end"};
            }
    return Done{};
}

}  // namespace

Status changeContacts(const std::string& path, const ContactsChange& change, const JobContext& job) {
    auto take = Take::open(path, Access::kReadWrite, {job.cancel});
    if (!take)
        return take.error();
    if (change.suit != kSuitInView)
        take->view(change.suit);
    const auto duration_s = take->duration_s();
    if (!duration_s)
        return duration_s.error();
    if (change.after)
        if (Status fits = checkContacts(path, *change.after, *duration_s); !fits)
            return fits;
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (Status set = edit->setContacts(change.after); !set)
        return set;
    if (job.cancelled())
        return JobContext::cancelledError();
    return edit->commit();
}

}  // namespace noctule
