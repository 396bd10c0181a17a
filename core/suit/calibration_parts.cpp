// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration_parts.h"

#include <algorithm>
#include <array>

namespace noctule {
namespace {

constexpr const char* kSources = "sources";
constexpr const char* kAccelerometers = "accelerometers";
constexpr const char* kGyroscopes = "gyroscopes";
constexpr std::array kOfWearing{"rest-pose", "motion"};

void forgetWearing(CalibrationHistory& made) {
    for (const char* task : kOfWearing)
        made.erase(task);
}

bool isOther(const std::string& serial, const std::string& other) {
    return !serial.empty() && !other.empty() && serial != other;
}

/// ISO 8601 in UTC sorts as text.
bool isNewer(const CalibrationHistory& made, const CalibrationHistory& than, const char* task) {
    const auto found = made.find(task), known = than.find(task);
    return found != made.end() &&
           (known == than.end() || found->second.created_utc > known->second.created_utc);
}

bool takeSource(SourceCalibration& known, const SourceCalibration& other) {
    if (isOther(known.serial, other.serial) || !isNewer(other.made, known.made, kSources))
        return false;
    known.offsets_s = other.offsets_s;
    known.sigma_s = other.sigma_s;
    known.resonance_hz = other.resonance_hz;
    known.q = other.q;
    known.made[kSources] = other.made.at(kSources);
    return true;
}

bool takeAxis(const char* task, AxisCalibration BoardCalibration::*axis, BoardCalibration& known,
              const BoardCalibration& other) {
    if (isOther(known.serial, other.serial) || !isNewer(other.made, known.made, task))
        return false;
    known.*axis = other.*axis;
    known.made[task] = other.made.at(task);
    return true;
}

struct KnownParts {
    int same = 0, others = 0;

    template <class Part, class Values>
    void add(const Part& part, const Values* values) {
        if (values && !values->serial.empty() && !part.serial.empty())
            ++(values->serial == part.serial ? same : others);
    }
};

}  // namespace

Calibration withoutWearing(const Calibration& calibration) {
    Calibration parts = calibration;
    for (BoardCalibration& board : parts.boards) {
        board.p_segment_board_m.reset();
        board.q_segment_board.reset();
        board.sigma_mounting_rad.reset();
        board.flesh.reset();
        forgetWearing(board.made);
    }
    for (SourceCalibration& source : parts.sources) {
        source.p_segment_source_m.reset();
        forgetWearing(source.made);
    }
    return parts;
}

bool takeNewerParts(Calibration& base, const Calibration& other) {
    bool taken = false;
    for (SourceCalibration& known : base.sources)
        if (const SourceCalibration* found = other.findSource(known.id))
            taken = takeSource(known, *found) || taken;
    for (BoardCalibration& known : base.boards)
        if (const BoardCalibration* found = other.findBoard(known.id)) {
            taken = takeAxis(kAccelerometers, &BoardCalibration::accel, known, *found) || taken;
            taken = takeAxis(kGyroscopes, &BoardCalibration::gyro, known, *found) || taken;
        }
    for (const SourceCalibration& found : other.sources)
        if (!base.findSource(found.id) && !found.offsets_s.empty()) {
            base.sources.push_back(found);
            taken = true;
        }
    if (taken)
        base.created_utc = std::max(base.created_utc, other.created_utc);
    return taken;
}

bool namesItsSuit(const Calibration& calibration) {
    const auto isNamed = [](const auto& part) { return !part.serial.empty(); };
    return !calibration.box_serial.empty() || std::ranges::any_of(calibration.boards, isNamed) ||
           std::ranges::any_of(calibration.sources, isNamed);
}

CalibrationOwner ownerOf(const Calibration& calibration, const Suit& suit, const std::string& box_serial) {
    KnownParts parts;
    for (const Board& board : suit.boards)
        parts.add(board, calibration.findBoard(board.id));
    for (const Source& source : suit.sources)
        parts.add(source, calibration.findSource(source.id));
    if (parts.same > 0)
        return CalibrationOwner::kThisSuit;
    if (parts.others > 0)
        return CalibrationOwner::kAnotherSuit;
    if (calibration.box_serial.empty() || box_serial.empty())
        return CalibrationOwner::kUnknown;
    return calibration.box_serial == box_serial ? CalibrationOwner::kThisSuit
                                                : CalibrationOwner::kAnotherSuit;
}

}  // namespace noctule
