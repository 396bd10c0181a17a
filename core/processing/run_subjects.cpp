// SPDX-License-Identifier: Apache-2.0
#include "core/processing/run_subjects.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

/// What neither a file's name nor a name in a file can hold becomes an underscore.
std::string fileWord(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\\' || c == ':' || c == ' '; }, '_');
    return name;
}

int64_t roundedNs(double s) {
    return std::llround(s * 1e9);
}

std::string subjectInWords(const TakeSubject& subject) {
    return subject.name.empty() ? "Suit " + std::to_string(subject.suit()) : subject.name;
}

/// From whoever is seen first to whoever is seen last; none: nobody is seen. `all`: an error when one of them
/// is never seen.
Result<std::optional<PoseSpan>> seenOf(const ExportRequest& request, const std::vector<TakeSubject>& subjects,
                                       bool all) {
    const auto take = Take::open(request.take_path);
    if (!take)
        return take.error();
    const auto run = choosePoseRun(*take, request.run);
    if (!run)
        return run.error();
    std::optional<PoseSpan> whole;
    for (const TakeSubject& subject : subjects) {
        const auto poses = take->poseSource(run->run, subject.suit());
        if (!poses)
            return poses.error();
        const auto seen = poses->seen();
        if (!seen)
            return seen.error();
        if (!*seen && all)
            return Error{ErrorKind::kUnusable,
                         request.take_path + ": " + subjectInWords(subject) + " has no pose in this result",
                         "Export a file for each of the others"};
        if (*seen)
            whole = whole ? PoseSpan{std::min(whole->first_ns, (*seen)->first_ns),
                                     std::max(whole->last_ns, (*seen)->last_ns)}
                          : **seen;
    }
    return whole;
}

/// The part in which anybody is seen, on the grid of frames that the request asks for.
void cutTo(const PoseSpan& seen, ExportRequest& request) {
    int64_t begin_ns = request.from_s ? roundedNs(*request.from_s) : seen.first_ns;
    if (begin_ns < seen.first_ns) {
        constexpr double kRounding_frames = 1e-6;
        const double frames =
            1e-9 * static_cast<double>(seen.first_ns - begin_ns) * request.frames_per_second;
        begin_ns += roundedNs(std::ceil(frames - kRounding_frames) / request.frames_per_second);
    }
    request.from_s = static_cast<double>(begin_ns) * 1e-9;
    const int64_t to_ns = request.to_s ? roundedNs(*request.to_s) : seen.last_ns;
    request.to_s = static_cast<double>(std::min(to_ns, seen.last_ns)) * 1e-9;
    request.holds_ends = true;
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
    ExportRequest each = request;
    if (subjects->size() > 1) {
        const auto seen = seenOf(request, *subjects, false);
        if (!seen)
            return seen.error();
        if (*seen)
            cutTo(**seen, each);
    }
    std::vector<ExportRequest> requests;
    for (const TakeSubject& subject : *subjects) {
        ExportRequest own = each;
        own.suit = subject.suit();
        own.subject = subjectInWords(subject);
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
    const auto seen = seenOf(request, *subjects, true);
    if (!seen)
        return seen.error();
    ExportRequest each = request;
    cutTo(**seen, each);
    each.png_path = each.video_path = "";
    std::vector<ExportRequest> requests;
    for (const TakeSubject& subject : *subjects) {
        ExportRequest own = each;
        own.suit = subject.suit();
        own.subject = subjectInWords(subject);
        own.character = fileWord(subject.name.empty() ? std::to_string(subject.suit()) : subject.name);
        requests.push_back(std::move(own));
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
