// SPDX-License-Identifier: Apache-2.0
#include "core/motion/contact_edit.h"

#include <algorithm>

namespace noctule {

const FootContact* findContact(const std::vector<FootContacts>& feet, const ContactPlace& place) {
    const auto foot = std::ranges::find(feet, place.foot, &FootContacts::foot);
    if (foot == feet.end() || place.index < 0 || place.index >= std::ssize(foot->contacts))
        return nullptr;
    return &foot->contacts[static_cast<size_t>(place.index)];
}

ContactPlace contactNear(const std::vector<FootContacts>& feet, const std::string& foot, double t_s) {
    const auto found = std::ranges::find(feet, foot, &FootContacts::foot);
    if (found == feet.end() || found->contacts.empty())
        return {foot};
    const auto next = std::ranges::find_if(found->contacts, [&](const auto& c) { return c.to_s >= t_s; });
    const auto last = found->contacts.end() - 1;
    return {foot, static_cast<int>(std::min(next, last) - found->contacts.begin())};
}

std::vector<FootContacts> withContact(std::vector<FootContacts> feet, ContactPlace& place,
                                      const FootContact& wanted) {
    feet = withoutContact(std::move(feet), place);
    auto foot = std::ranges::find(feet, place.foot, &FootContacts::foot);
    if (foot == feet.end())
        foot = feet.insert(std::ranges::lower_bound(feet, place.foot, {}, &FootContacts::foot),
                           {place.foot, {}});
    FootContact joined{wanted.from_s, wanted.to_s, 0, true};
    std::vector<FootContact>& contacts = foot->contacts;
    std::erase_if(contacts, [&](const FootContact& other) {
        const bool touches = other.from_s <= joined.to_s && other.to_s >= joined.from_s;
        if (touches) {
            joined.from_s = std::min(joined.from_s, other.from_s);
            joined.to_s = std::max(joined.to_s, other.to_s);
        }
        return touches;
    });
    const auto at = std::ranges::lower_bound(contacts, joined.from_s, {}, &FootContact::from_s);
    place.index = static_cast<int>(at - contacts.begin());
    contacts.insert(at, joined);
    return feet;
}

std::vector<FootContacts> withoutContact(std::vector<FootContacts> feet, const ContactPlace& place) {
    const auto foot = std::ranges::find(feet, place.foot, &FootContacts::foot);
    if (foot != feet.end() && place.index >= 0 && place.index < std::ssize(foot->contacts))
        foot->contacts.erase(foot->contacts.begin() + place.index);
    return feet;
}

}  // namespace noctule
