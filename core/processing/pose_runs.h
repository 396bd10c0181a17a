// SPDX-License-Identifier: Apache-2.0
// The pose runs of a take, found by name, and what their settings say about how they were made. Takes of
// other programs may say less; what they leave out is guessed from the runs that stand in the take.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/recording/take.h"

namespace noctule {

struct RunSettings {
    std::string sensors = "AGD";  ///< subset, in this order
    std::string estimator, smoother = "none", detector;
    std::string ground;            ///< empty: a run that knew of no contacts
    bool contacts_edited = false;  ///< those of an operator were used, none were looked for
    bool root_given = false;
    bool uses_room = false;     ///< anchors held the world
    bool between = false;       ///< made with ranges between the people
    bool people_apart = false;  ///< several people, whose places to each other are neither measured nor given
    std::vector<int> unjoined;  ///< suits that could not be placed against the others
    std::optional<int64_t> inertial_run, range_run;  ///< what it was made from; kPrimaryRun: primary rows
    std::optional<double> process_sigma_rad_per_s2;  ///< estimator "paper"

    /// The places of the two wearers to each other were measured or given.
    bool joins(int suit, int other_suit) const;
};

/// `runs` are all of the take, in its order.
RunSettings runSettings(const DerivedRun& pose_run, const std::vector<DerivedRun>& runs, TakeLevel level);

/// Whom the run shows: suit 1 where its settings name nobody.
std::vector<TakeSubject> subjectsOf(const DerivedRun& pose_run);

/// Of an estimator that keeps the gyroscopes' zeros of the rest pose, where `after_rest_s` of the take follow
/// it and no other system gives the root: what that makes of the poses. Empty: nothing.
std::string driftWarning(const std::string& estimator, const std::string& sensors, bool root_given,
                         double after_rest_s);

/// In the order in which they were made.
std::vector<DerivedRun> poseRuns(const std::vector<DerivedRun>& runs);

/// The number by which a result is called, 1 for the first that the take ever had: it stays with the result
/// when an earlier one is dropped. `runs` are all of the take.
int resultNumber(const Take& take, const std::vector<DerivedRun>& runs, const DerivedRun& pose_run);

/// The pose run of that name, the last of several; empty: the last one. kUnusable names what there is.
Result<DerivedRun> choosePoseRun(const Take& take, const std::string& name);
/// The pose run of that number; kUnusable when there is none.
Result<DerivedRun> poseRun(const Take& take, int64_t number);

}  // namespace noctule
