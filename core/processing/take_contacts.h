// SPDX-License-Identifier: Apache-2.0
// Sets in a take that exists when the feet stand, as an operator says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/job/result.h"
#include "core/motion/foot_contacts.h"
#include "core/recording/rows.h"

namespace noctule {

/// All contacts of all feet before and after; nothing: those that each run has found.
struct ContactsChange {
    std::optional<std::vector<FootContacts>> before{}, after{};
    int suit = kSuitInView;  ///< of whom

    ContactsChange reversed() const { return {after, before, suit}; }
};

/// All of it or nothing. kUsage when a contact lies outside the take or ends before it begins.
Status changeContacts(const std::string& path, const ContactsChange& change, const JobContext& job);

}  // namespace noctule
