// SPDX-License-Identifier: Apache-2.0
// What another system recorded, as it stands in a take: kept before it is replaced, and put back.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/processing/attach_reference.h"
#include "core/recording/rows.h"

namespace noctule {

/// Reference or external root of the first suit; without rows: the take has none.
struct AttachedMotion {
    AttachAs as = AttachAs::kReference;
    std::vector<TimedPose> reference{};
    std::vector<ExternalRootRow> external_root{};
    std::map<std::string, std::string> meta{};  ///< what the take says of its reference

    bool isThere() const { return !reference.empty() || !external_root.empty(); }
};

Result<AttachedMotion> attachedMotion(const std::string& take_path, AttachAs as, const JobContext& job);

/// All of it or nothing. What was attached before goes; rows come back to the bit.
Status putBackAttached(const std::string& take_path, const AttachedMotion& motion, const JobContext& job);

/// Attached by an operator.
struct AttachedChange {
    std::shared_ptr<const AttachedMotion> before{}, after{};

    AttachedChange reversed() const { return {after, before}; }
};

}  // namespace noctule
