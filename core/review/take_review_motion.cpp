// SPDX-License-Identifier: Apache-2.0
#include "core/processing/contacts_in_force.h"
#include "core/review/review_file.h"
#include "core/review/take_review.h"

namespace noctule {

Result<TimedMotion> loadPoses(const TakeView& view, std::optional<int64_t> run, const JobContext& job) {
    const std::string& path = view.path;
    const auto viewed = ViewedTake::open(view);
    if (!viewed)
        return viewed.error();
    if (job.cancelled())
        return JobContext::cancelledError();
    auto motion = run ? viewed->take.poses(*run) : viewed->take.reference();
    if (!motion)
        return motion;
    if (motion->frames.empty())
        return Error{ErrorKind::kUnusable,
                     path + (run ? ": the result " + std::to_string(*run) + " holds no poses"
                                 : ": holds no reference"),
                     run ? "Process the take again" : "Attach a reference first"};
    if (const Status fits = checkMotion(*motion, path); !fits)
        return fits.error();
    return motion;
}

Result<std::vector<FootContacts>> loadContacts(const TakeView& view, const ReviewRun& run,
                                               const TimedMotion& motion) {
    const auto viewed = ViewedTake::open(view);
    if (!viewed)
        return viewed.error();
    auto contacts = contactsInForce(viewed->take, run.run, motion);
    if (!contacts)
        return contacts.error();
    return std::move(contacts->feet);
}

}  // namespace noctule
