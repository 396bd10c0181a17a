// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration_steps.h"

#include <algorithm>

#include "core/job/grade.h"
#include "core/suit/calibration_lack.h"

namespace noctule {
namespace {

/// A verdict that nobody knows is worse than "usable".
int severityOf(const std::string& verdict) {
    if (verdict == gradeWord(Grade::kGood))
        return 0;
    if (verdict == gradeWord(Grade::kUsable))
        return 1;
    return verdict == gradeWord(Grade::kNotUsable) ? 3 : 2;
}

/// Of the parts whose values count as calibrated or not; null: of other steps.
const std::vector<int>* lackingParts(CalibrationStep step, const CalibrationLack& lack) {
    switch (step) {
        case CalibrationStep::kSources:
            return &lack.sources;
        case CalibrationStep::kAccelerometers:
            return &lack.accelerometers;
        case CalibrationStep::kGyroscopes:
            return &lack.gyroscopes;
        case CalibrationStep::kRestPose:
            return &lack.rest_pose;
        case CalibrationStep::kMagnetometers:
        case CalibrationStep::kMovement:
            break;
    }
    return nullptr;
}

template <class Part>
void countPart(const Part* part, bool lacks, CalibrationStepState& state) {
    ++state.parts;
    const auto made = part ? part->made.find(keyOf(state.step)) : CalibrationHistory::const_iterator();
    if (!part || made == part->made.end()) {
        state.unstated += part && !lacks;
        return;
    }
    ++state.made;
    const auto& [created_utc, verdict] = made->second;
    if (state.oldest_utc.empty() || created_utc < state.oldest_utc)
        state.oldest_utc = created_utc;
    if (state.worst.empty() || severityOf(verdict) > severityOf(state.worst))
        state.worst = verdict;
}

}  // namespace

const char* keyOf(CalibrationStep step) {
    constexpr const char* kKeys[] = {"sources",       "accelerometers", "gyroscopes",
                                     "magnetometers", "rest-pose",      "motion"};
    return kKeys[static_cast<int>(step)];
}

double lastsFor_h(CalibrationStep step) {
    constexpr double kDay_h = 24;
    if (step == CalibrationStep::kSources)
        return 365 * kDay_h;
    return isOfWearing(step) ? 12 : 92 * kDay_h;
}

bool isOfWearing(CalibrationStep step) {
    return step == CalibrationStep::kRestPose || step == CalibrationStep::kMovement;
}

bool CalibrationStepState::isNotUsable() const {
    return worst == gradeWord(Grade::kNotUsable);
}

CalibrationStepState stateOfStep(CalibrationStep step, const Suit& suit, const Calibration& calibration) {
    CalibrationStepState state;
    state.step = step;
    const CalibrationLack lack = lackOf(suit, calibration);
    const std::vector<int>* lacking = lackingParts(step, lack);
    const auto lacks = [lacking](size_t part) {
        return !lacking || std::ranges::count(*lacking, static_cast<int>(part)) > 0;
    };
    if (step == CalibrationStep::kSources) {
        for (size_t s = 0; s < suit.sources.size(); ++s)
            countPart(calibration.findSource(suit.sources[s].id), lacks(s), state);
        if (suit.sources.empty())
            for (const SourceCalibration& source : calibration.sources)
                countPart(&source, true, state);
        return state;
    }
    for (size_t b = 0; b < suit.boards.size(); ++b)
        if (step != CalibrationStep::kMagnetometers || suit.boards[b].has_magnetometer)
            countPart(calibration.findBoard(suit.boards[b].id), lacks(b), state);
    if (suit.boards.empty())
        for (const BoardCalibration& board : calibration.boards)
            countPart(&board, true, state);
    return state;
}

}  // namespace noctule
