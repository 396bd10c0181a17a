// SPDX-License-Identifier: Apache-2.0
#include "app/batch/cast_request.h"

#include <filesystem>

#include "app/batch/files.h"
#include "app/batch/motion_file.h"
#include "core/simulation/cast_file.h"
#include "core/suit/default_suit.h"

namespace noctule::batch {
namespace {

using namespace simulation;

std::string besideCast(const std::string& cast, const std::string& path) {
    const std::filesystem::path given(path);
    return given.is_absolute() ? path : (std::filesystem::path(cast).parent_path() / given).string();
}

/// Who in the cast wanted the file.
Error wantedBy(Error error, const std::string& who) {
    error.message = who + ": " + error.message;
    return error;
}

template <class Value, class Into>
Status readBeside(const std::string& cast, const std::string& path, Result<Value> (*read)(const std::string&),
                  Into& into) {
    if (path.empty())
        return Done{};
    auto value = read(besideCast(cast, path));
    if (!value)
        return value.error();
    into = std::move(*value);
    return Done{};
}

Result<CastSubject> readSubject(const std::string& cast, const CastFileSubject& described,
                                const Arguments& arguments, Console& console) {
    auto motion = readUnderstood(besideCast(cast, described.motion), arguments, console);
    if (!motion)
        return motion.error();
    auto clip = adjustedMotion(std::move(motion->clip), described);
    if (!clip)
        return clip.error();
    CastSubject subject;
    subject.name = described.name;
    subject.stage.clip = std::move(*clip);
    subject.stage.joints = std::move(motion->joints);
    subject.stage.suit = defaultSuit();
    if (Status read = readBeside(cast, described.suit, readSuit, subject.stage.suit); !read)
        return read.error();
    if (Status read = readBeside(cast, described.actor, readActor, subject.stage.actor); !read)
        return read.error();
    subject.place = described.place;
    subject.start_s = described.start_s;
    subject.carrier_hz = described.carrier_hz;
    subject.pulse_interval_samples = described.pulse_interval_samples;
    return subject;
}

}  // namespace

Result<CastRequest> castRequest(const std::string& path, const Arguments& arguments, Console& console,
                                double duration_s) {
    const auto json = readJson(path);
    if (!json)
        return json.error();
    const auto described = castFromJson(*json, path);
    if (!described)
        return described.error();
    for (const std::string& warning : described->warnings)
        console.warn(warning);
    CastRequest request;
    for (const CastFileSubject& one : described->subjects) {
        auto subject = readSubject(path, one, arguments, console);
        if (!subject)
            return wantedBy(subject.error(), path + ": subject " + one.name);
        request.subjects.push_back(std::move(*subject));
    }
    if (Status read = readBeside(path, described->room, readSuit, request.room); !read)
        return wantedBy(read.error(), path + ": room");
    request.shared_clock = described->shared_clock;
    auto scenario = Scenario::named(arguments.text("scenario"));
    if (!scenario)
        return scenario.error();
    request.scenario = *scenario;
    request.rest_seconds = arguments.number("rest-seconds");
    request.duration_s = duration_s;
    request.seed = static_cast<uint64_t>(*arguments.whole("seed"));
    return request;
}

}  // namespace noctule::batch
