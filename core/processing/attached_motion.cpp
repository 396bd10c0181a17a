// SPDX-License-Identifier: Apache-2.0
#include "core/processing/attached_motion.h"

#include "core/recording/take_edit.h"

namespace noctule {
namespace {

/// Those of further suits ("reference_actor_2") are theirs: only the first one's reference is attached.
bool tellsOfReference(const std::string& key) {
    return key.starts_with("reference_") && !key.starts_with("reference_actor_");
}

Status putBackReference(TakeEdit& edit, const Take& take, const AttachedMotion& motion) {
    if (Status removed = edit.removeReference(); !removed)
        return removed;
    for (const auto& [key, value] : take.meta())
        if (tellsOfReference(key) && !motion.meta.contains(key))
            if (Status removed = edit.removeMeta(key); !removed)
                return removed;
    for (const auto& [key, value] : motion.meta)
        if (Status set = edit.setMeta(key, value); !set)
            return set;
    for (const TimedPose& frame : motion.reference)
        if (Status added = edit.addReference(frame); !added)
            return added;
    return Done{};
}

Status putBackRoot(TakeEdit& edit, const AttachedMotion& motion) {
    if (Status removed = edit.removeExternalRoot(); !removed)
        return removed;
    for (const ExternalRootRow& row : motion.external_root)
        if (Status added = edit.addExternalRoot(row); !added)
            return added;
    return Done{};
}

}  // namespace

Result<AttachedMotion> attachedMotion(const std::string& take_path, AttachAs as, const JobContext& job) {
    const auto take = Take::open(take_path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    AttachedMotion motion{.as = as};
    if (as == AttachAs::kExternalRoot) {
        auto rows = take->externalRoot();
        if (!rows)
            return rows.error();
        motion.external_root = std::move(*rows);
        return motion;
    }
    auto stored = take->reference();
    if (!stored)
        return stored.error();
    motion.reference = std::move(stored->frames);
    for (const auto& [key, value] : take->meta())
        if (tellsOfReference(key))
            motion.meta.emplace(key, value);
    return motion;
}

Status putBackAttached(const std::string& take_path, const AttachedMotion& motion, const JobContext& job) {
    auto take = Take::open(take_path, Access::kReadWrite, {job.cancel});
    if (!take)
        return take.error();
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (Status put = motion.as == AttachAs::kReference ? putBackReference(*edit, *take, motion)
                                                       : putBackRoot(*edit, motion);
        !put)
        return put;
    if (job.cancelled())
        return JobContext::cancelledError();
    return edit->commit();
}

}  // namespace noctule
