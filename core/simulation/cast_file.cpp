// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/cast_file.h"

#include <cmath>

#include "core/job/outside_text.h"
#include "core/math/conventions.h"
#include "core/math/json.h"

namespace noctule::simulation {
namespace {

using Json = nlohmann::json;

/// What the members of a subject may be; what lies beyond is a mistake in the file.
struct MemberLimit {
    const char* member;
    double low, high;
    bool whole = false;
};
constexpr MemberLimit kX{"x_m", -100, 100}, kZ{"z_m", -100, 100}, kYaw{"yaw_deg", -3600, 3600};
constexpr MemberLimit kStart{"start_s", 0, 3600}, kScale{"motion_scale", 0.01, 100};
constexpr MemberLimit kRate{"motion_rate_hz", 1, 1000}, kSkip{"motion_skip", 0, 1e7, true};
constexpr MemberLimit kCarrier{"carrier_hz", 24000, 68000};
constexpr MemberLimit kInterval{"pulse_interval_samples", 450, 150000, true};

/// Reads members of one object and keeps the first mistake.
class MemberReader {
public:
    MemberReader(const Json& object, std::string what, std::optional<Error>& error)
        : object_(object), what_(std::move(what)), error_(error) {
        if (!object.is_object())
            fail("is not an object");
    }

    std::string text(const char* member) {
        const Json* value = find(member);
        if (!value)
            return "";
        if (!value->is_string()) {
            fail(std::string(member) + " is not a text");
            return "";
        }
        return value->get<std::string>();
    }

    std::optional<double> number(const MemberLimit& limit) {
        const Json* value = find(limit.member);
        if (!value)
            return std::nullopt;
        const auto number = json::number(*value);
        if (!number || *number < limit.low || *number > limit.high ||
            (limit.whole && *number != std::floor(*number))) {
            char must[120];
            std::snprintf(must, sizeof must, " must be a %snumber from %g to %g", limit.whole ? "whole " : "",
                          limit.low, limit.high);
            fail(limit.member + std::string(must));
            return std::nullopt;
        }
        return number;
    }

    bool truth(const char* member) {
        const Json* value = find(member);
        if (value && !value->is_boolean())
            fail(std::string(member) + " must be true or false");
        return value && value->is_boolean() && value->get<bool>();
    }

    const Json* find(const char* member) const {
        const auto found = object_.is_object() ? object_.find(member) : object_.end();
        return found == object_.end() || found->is_null() ? nullptr : &*found;
    }

    void fail(const std::string& why) {
        if (!error_)
            error_ = Error{ErrorKind::kUnreadable, what_ + ": " + why, "Correct it in the cast"};
    }

private:
    const Json& object_;
    std::string what_;
    std::optional<Error>& error_;
};

/// A to Z, then 27 and so on.
std::string usualName(size_t index) {
    return index < 26 ? std::string(1, static_cast<char>('A' + index)) : std::to_string(index + 1);
}

CastFileSubject readSubject(const Json& entry, size_t index, const std::string& where,
                            std::optional<Error>& error) {
    MemberReader unnamed(entry, where + ": subject " + std::to_string(index + 1), error);
    CastFileSubject subject;
    subject.name = shortText(unnamed.text("name"), limits::kName);
    if (subject.name.empty())
        subject.name = usualName(index);
    const std::string what = where + ": subject " + subject.name;
    MemberReader json(entry, what, error);
    subject.motion = json.text("motion");
    if (subject.motion.empty())
        json.fail("has no motion");
    subject.suit = json.text("suit");
    subject.actor = json.text("actor");
    if (const Json* place = json.find("place")) {
        MemberReader at(*place, what + ": place", error);
        subject.place = StandingPlace{at.number(kX).value_or(0), at.number(kZ).value_or(0),
                                      radians(at.number(kYaw).value_or(0))};
    }
    subject.start_s = json.number(kStart).value_or(0);
    subject.motion_scale = json.number(kScale).value_or(1);
    subject.motion_rate_hz = json.number(kRate);
    subject.motion_skip = static_cast<int>(json.number(kSkip).value_or(0));
    subject.carrier_hz = json.number(kCarrier);
    if (const auto interval = json.number(kInterval))
        subject.pulse_interval_samples = static_cast<int>(*interval);
    return subject;
}

}  // namespace

Result<CastFile> castFromJson(const nlohmann::json& json, const std::string& where) {
    std::optional<Error> error;
    MemberReader cast(json, where, error);
    CastFile file;
    file.room = cast.text("room");
    file.shared_clock = cast.truth("shared_clock");
    const Json* list = cast.find("subjects");
    if (!list || !list->is_array() || list->empty())
        cast.fail("subjects is no list of performers");
    else if (list->size() > limits::kSuitsOfTake)
        cast.fail("has more than " + std::to_string(limits::kSuitsOfTake) + " subjects");
    else
        for (const Json& entry : *list) {
            file.subjects.push_back(readSubject(entry, file.subjects.size(), where, error));
            if (entry.is_object() && entry.contains("mag"))
                file.warnings.push_back(where + ": subject " + file.subjects.back().name +
                                        ": mag: magnetometers of a cast are not simulated; it is left out");
        }
    for (size_t i = 0; i < file.subjects.size(); ++i)
        for (size_t other = 0; other < i; ++other)
            if (file.subjects[i].name == file.subjects[other].name)
                cast.fail("two subjects are called \"" + file.subjects[i].name + "\"");
    return error ? Result<CastFile>(*error) : Result<CastFile>(std::move(file));
}

Result<MotionClip> adjustedMotion(MotionClip clip, const CastFileSubject& subject) {
    const auto skipped = static_cast<std::ptrdiff_t>(subject.motion_skip);
    if (skipped >= std::ssize(clip.frames))
        return Error{
            ErrorKind::kUnusable,
            "motion_skip leaves out all " + std::to_string(clip.frames.size()) + " frames of " + clip.name,
            "Give a smaller motion_skip"};
    clip.frames.erase(clip.frames.begin(), clip.frames.begin() + skipped);
    if (!clip.p_parent_joint_m.empty())
        clip.p_parent_joint_m.erase(clip.p_parent_joint_m.begin(), clip.p_parent_joint_m.begin() + skipped);
    if (subject.motion_rate_hz)
        clip.frame_time_s = 1 / *subject.motion_rate_hz;
    if (subject.motion_scale == 1)
        return clip;
    std::vector<Joint> joints = clip.skeleton.joints();
    for (Joint& joint : joints) {
        joint.offset_m *= subject.motion_scale;
        if (joint.end_m)
            *joint.end_m *= subject.motion_scale;
    }
    clip.skeleton = Skeleton::make(std::move(joints)).value();
    for (Pose& pose : clip.frames)
        pose.p_world_root *= subject.motion_scale;
    for (std::vector<Vector3d>& offsets : clip.p_parent_joint_m)
        for (Vector3d& offset_m : offsets)
            offset_m *= subject.motion_scale;
    return clip;
}

}  // namespace noctule::simulation
