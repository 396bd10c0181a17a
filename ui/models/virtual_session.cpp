// SPDX-License-Identifier: Apache-2.0
#include "ui/models/virtual_session.h"

#include <optional>
#include <system_error>

#include "core/job/atomic_file.h"
#include "core/job/staged_progress.h"
#include "core/processing/process_take.h"
#include "ui/models/session_model.h"

namespace noctule::ui {
namespace {

namespace fs = std::filesystem;

/// In session.json of a session that was made here.
constexpr const char* kMark = "x_virtual_suit";
constexpr const char* kWorkshop = ".making";

/// A folder that is gone again unless kept.
class NewFolder {
public:
    explicit NewFolder(fs::path path) : path_(std::move(path)) {}
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder() {
        std::error_code ignored;
        if (!path_.empty())
            fs::remove_all(path_, ignored);
    }
    const fs::path& path() const { return path_; }
    void keep() { path_.clear(); }

private:
    fs::path path_;
};

std::optional<Session> ourSession(const fs::path& folder, const JobContext& job) {
    auto session = openSession(folder, job);
    if (!session || session->unknown.value(kMark, false) != true)
        return std::nullopt;
    return std::move(*session);
}

bool isFree(const fs::path& folder) {
    std::error_code error;
    return !fs::exists(folder, error) || (fs::is_directory(folder, error) && fs::is_empty(folder, error));
}

/// The folder to use: ours when there is one already, else the next that is free.
fs::path chooseFolder(const VirtualSessionRequest& request, const JobContext& job,
                      std::optional<Session>& existing) {
    for (int number = 1;; ++number) {
        const std::string name = request.session_name + (number == 1 ? "" : " " + std::to_string(number));
        const fs::path folder = request.sessions_folder / name;
        existing = isFree(folder) ? std::nullopt : ourSession(folder, job);
        if (existing || isFree(folder))
            return folder;
    }
}

Result<Session> newSession(const VirtualSessionRequest& request, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(request.sessions_folder, error);
    if (error)
        return Error{ErrorKind::kDisk,
                     request.sessions_folder.string() + ": cannot be made: " + error.message(),
                     "Choose another folder for sessions in the preferences"};
    auto session = createSession(folder, folder.filename().string(), request.created_utc,
                                 SessionModel::firstPerformer().toStdString());
    if (!session)
        return session.error();
    session->unknown[kMark] = true;
    if (const Status saved = saveSession(*session); !saved)
        return saved.error();
    return session;
}

/// The sample's root is known; without it the body would drift through the room.
Status process(const std::string& path, const VirtualSessionRequest& request, const JobContext& job) {
    ProcessRequest processing;
    processing.take_path = path;
    processing.software = request.software;
    processing.created_utc = request.created_utc;
    {
        const auto take = Take::open(path);
        if (!take)
            return take.error();
        const auto root = take->externalRoot();
        processing.tracker.root_given = root.ok() && !root->empty();
    }
    const auto summary = processTake(processing, job);
    return summary ? Status(Done{}) : Status(summary.error());
}

}  // namespace

/// In a hidden folder of the session; the take comes into takes/ when it is whole.
Result<std::string> makeSimulatedTake(const VirtualSessionRequest& request, const Session& session,
                                      const JobContext& job) {
    const std::string name = nextTakeName(session, request.take_base);
    const NewFolder workshop(asidePath((session.folder / kWorkshop).string()));
    std::error_code error;
    fs::create_directory(workshop.path(), error);
    const std::string file = name + ".noctule";
    const std::string made = (workshop.path() / file).string();
    {
        StagedProgress stage(job, 0, 0.3);
        if (const Status done = request.make_take(made, stage.job()); !done)
            return done.error();
    }
    StagedProgress stage(job, 0.3, 1);
    if (const Status done = process(made, request, stage.job()); !done)
        return done.error();
    if (const Status published = publishFile(made, (session.takesFolder() / file).string(), false);
        !published)
        return published.error();
    return name;
}

Result<VirtualSession> makeVirtualSession(const VirtualSessionRequest& request, const JobContext& job) {
    std::optional<Session> existing;
    const fs::path folder = chooseFolder(request, job, existing);
    if (job.cancelled())
        return JobContext::cancelledError();
    if (existing)
        for (const SessionTake& take : existing->takes)
            if (take.processed)
                return VirtualSession{folder, take.name};
    NewFolder made(existing ? fs::path() : folder);
    auto session = existing ? Result<Session>(*existing) : newSession(request, folder);
    if (!session)
        return session.error();
    const auto take = makeSimulatedTake(request, *session, job);
    if (!take)
        return take.error();
    made.keep();
    return VirtualSession{folder, *take};
}

}  // namespace noctule::ui
