// SPDX-License-Identifier: Apache-2.0
#include "core/processing/run_subjects.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/processing/export_motion.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

constexpr double kHalfNanosecond_s = 0.5e-9;  // so that rounding leaves out no last frame

/// What neither a file's name nor a name in a file can hold becomes an underscore.
std::string fileWord(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\\' || c == ':' || c == ' '; }, '_');
    return name;
}

/// Of whoever is seen first.
Result<std::optional<double>> firstPose_s(const ExportRequest& request,
                                          const std::vector<TakeSubject>& subjects) {
    const auto take = Take::open(request.take_path);
    if (!take)
        return take.error();
    const auto run = choosePoseRun(*take, request.run);
    if (!run)
        return run.error();
    std::optional<double> first_s;
    for (const TakeSubject& subject : subjects) {
        const auto poses = take->poseSource(run->run, subject.suit());
        if (!poses)
            return poses.error();
        const auto begin_ns = poses->begin_ns();
        if (!begin_ns)
            return begin_ns.error();
        if (*begin_ns) {
            const double begin_s = static_cast<double>(**begin_ns) * 1e-9;
            first_s = std::min(begin_s, first_s.value_or(begin_s));
        }
    }
    return first_s;
}

}  // namespace

std::string pathOfSubject(const std::string& path, const std::string& subject) {
    const std::filesystem::path whole(path);
    return (whole.parent_path() /
            (whole.stem().string() + "_" + fileWord(subject) + whole.extension().string()))
        .string();
}

Result<std::vector<ExportRequest>> requestsOfSubjects(const ExportRequest& request) {
    const auto subjects = subjectsOfRun(request.take_path, request.run);
    if (!subjects)
        return subjects.error();
    std::optional<double> from_s = request.from_s;
    if (!from_s && subjects->size() > 1) {
        const auto begin_s = firstPose_s(request, *subjects);
        if (!begin_s)
            return begin_s.error();
        from_s = *begin_s;
    }
    std::vector<ExportRequest> requests;
    for (const TakeSubject& subject : *subjects) {
        ExportRequest own = request;
        own.suit = subject.suit();
        own.from_s = from_s;
        for (const ExportFormatEntry& format : exportFormats())
            if (std::string& path = own.*format.path; subjects->size() > 1 && !path.empty())
                path = pathOfSubject(path, subject.name);
        requests.push_back(std::move(own));
    }
    return requests;
}

Result<std::vector<ExportRequest>> requestsTogether(const ExportRequest& request) {
    const auto subjects = subjectsOfRun(request.take_path, request.run);
    if (!subjects)
        return subjects.error();
    if (subjects->size() == 1)
        return std::vector{request};
    std::vector<ExportRequest> requests;
    double from_s = 0, to_s = std::numeric_limits<double>::infinity();
    for (const TakeSubject& subject : *subjects) {
        ExportRequest own = request;
        own.suit = subject.suit();
        own.character = fileWord(subject.name.empty() ? std::to_string(subject.suit()) : subject.name);
        own.png_path = own.video_path = "";
        const auto exported = exportedMotion(own);
        if (!exported)
            return exported.error();
        const double steps = static_cast<double>(exported->clip.frames.size() - 1);
        from_s = std::max(from_s, exported->begin_s);
        to_s = std::min(to_s, exported->begin_s + steps * exported->clip.frame_time_s);
        requests.push_back(std::move(own));
    }
    if (to_s < from_s)
        return Error{ErrorKind::kUnusable,
                     request.take_path + ": its performers are never seen at the same time",
                     "Export a file for each of them"};
    for (ExportRequest& own : requests) {
        own.from_s = from_s;
        own.to_s = to_s + kHalfNanosecond_s;
    }
    return requests;
}

Result<std::vector<TakeSubject>> subjectsOfRun(const std::string& take_path, const std::string& run) {
    const auto take = Take::open(take_path);
    if (!take)
        return take.error();
    const auto chosen = choosePoseRun(*take, run);
    if (!chosen)
        return chosen.error();
    return subjectsOf(*chosen);
}

}  // namespace noctule
