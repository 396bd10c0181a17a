// SPDX-License-Identifier: Apache-2.0
#include "ui/models/studio.h"

#include <QFileInfo>
#include <algorithm>
#include <chrono>

#include "core/recording/take.h"
#include "core/suit/calibration_lack.h"
#include "ui/language/core_words.h"
#include "ui/models/virtual_session.h"

namespace noctule::ui {
namespace {

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

/// How many people there are, and how many of their suits have sources.
struct People {
    int64_t all = 0, heard = 0;
};

People peopleOf(const Take& take) {
    People people;
    const auto subjects = take.subjects();
    if (!subjects)
        return people;
    for (const TakeSubject& subject : *subjects) {
        const auto sources = take.sourceCount(subject.suit());
        people.all += !subject.room;
        people.heard += !subject.room && sources && *sources > 0;
    }
    return people;
}

/// Waits for its turn and still hears Cancel; false: cancelled.
bool waitForTurn(std::unique_lock<std::timed_mutex>& turn, const JobContext& job) {
    constexpr std::chrono::milliseconds kLook(50);
    while (!turn.try_lock_for(kLook)) {
        if (job.cancelled())
            return false;
        job.progress(0, Studio::tr("Waits for another take").toStdString());
    }
    return true;
}

}  // namespace

Studio::Studio(StudioParts parts, QObject* parent)
    : SharedContext(std::move(parts), parent),
      CaptureContext(static_cast<SharedContext&>(*this)),
      ReviewContext(static_cast<SharedContext&>(*this)),
      processing_(std::make_shared<std::timed_mutex>()) {
    connect(&suits(), &LiveSuits::takeOfSeveral, this,
            [this](const QString& path) { processAccurately(path.toStdString()); });
}

Job* Studio::tryVirtualSuit() {
    if (trying_ && trying_->state() == Job::State::kRunning)
        return trying_;
    emit settled(About::kFile);
    VirtualSessionRequest request;
    request.sessions_folder = sessionsFolder().toStdString();
    request.session_name = tr("Virtual suit").toStdString();
    request.take_base = tr("sample", "name of takes").toStdString();
    request.software = parts().software;
    request.created_utc = parts().utc_now();
    request.make_take = parts().make_sample_take;
    trying_ = jobs().start<VirtualSession>(
        tr("Virtual suit"), [request](const JobContext& job) { return makeVirtualSession(request, job); },
        [this](Result<VirtualSession> made) -> QString {
            if (!made) {
                if (made.error().kind != ErrorKind::kCancelled)
                    emit failed(coreWords(made.error().message), coreWords(made.error().remedy),
                                About::kFile);
                return {};
            }
            session().open(words(made->folder.string()), words(made->take));
            goTo(Step::kReview);
            return tr("%1 is ready").arg(words(made->take));
        });
    return trying_;
}

Job* Studio::importMotion(std::shared_ptr<const figure::UnderstoodMotion> motion,
                          const std::string& scenario) {
    if (!session().makeSure())
        return nullptr;
    emit settled(About::kFile);
    VirtualSessionRequest request;
    request.take_base = motion->clip.name;
    request.software = parts().software;
    request.created_utc = parts().utc_now();
    request.make_take = [make = parts().make_motion_take, motion, scenario](const std::string& path,
                                                                            const JobContext& job) {
        return make(*motion, scenario, path, job);
    };
    return jobs().start<std::string>(
        {tr("Importing %1"), words(motion->clip.name)},
        [request, session = session().session()](const JobContext& job) {
            return makeSimulatedTake(request, session, job);
        },
        [this, folder = session().session().folder](Result<std::string> made) -> QString {
            if (!made) {
                if (made.error().kind != ErrorKind::kCancelled)
                    emit failed(coreWords(made.error().message), coreWords(made.error().remedy),
                                About::kFile);
                return {};
            }
            if (session().isOpen() && session().session().folder == folder) {
                session().refresh(words((session().session().takesFolder() / (*made + ".noctule")).string()));
                session().setCurrentTake(session().session().findTake(*made));
                goTo(Step::kReview);
            }
            return tr("%1 is ready").arg(words(*made));
        });
}

namespace {

/// It holds more than nominal values.
bool isCalibrated(const Take& take) {
    const auto suit = take.suit();
    const auto calibration = take.calibrationInForce();
    return suit && calibration && !lackOf(*suit, calibration->value).isTotal();
}

}  // namespace

ProcessRequest Studio::accurateRequest(const std::string& take_path, const PartsOfOne& own,
                                       const JobContext& job) {
    ProcessRequest request;
    request.take_path = take_path;
    const auto take = Take::open(take_path, Access::kRead, {job.cancel});
    const People people = take ? peopleOf(*take) : People();
    if (people.all <= 1) {
        if (!own.fills_in || !take || !isCalibrated(*take))
            request.calibration = own.calibration;
        request.actor = own.actor;
    }
    if (people.heard > 1)
        return request;  // smoothers go over one body only; pulses are told apart by carrier
    request.tracker.smoother = Smoother::kFull;
    request.detector = Detector::kMatched;
    return request;
}

Job* Studio::process(const ProcessRequest& request) {
    emit settled(About::kProcess);
    return startProcessing(request.take_path, [request](const JobContext&) { return request; });
}

Job* Studio::processAccurately(const std::string& take_path, const PartsOfOne& own) {
    emit settled(About::kProcess);
    return startAccurately(take_path, own);
}

Job* Studio::startAccurately(const std::string& take_path, const PartsOfOne& own) {
    return startProcessing(
        take_path, [take_path, own](const JobContext& job) { return accurateRequest(take_path, own, job); });
}

Job* Studio::startProcessing(const std::string& take_path,
                             std::function<ProcessRequest(const JobContext&)> settings) {
    const QString path = words(take_path);
    const QString take = QFileInfo(path).completeBaseName();
    Job* job = jobs().start<ProcessSummary>(
        {tr("Processing %1"), take},
        [settings = std::move(settings), software = parts().software, created_utc = parts().utc_now(),
         turns = processing_](const JobContext& job) -> Result<ProcessSummary> {
            std::unique_lock turn(*turns, std::defer_lock);
            if (!waitForTurn(turn, job))
                return JobContext::cancelledError();
            ProcessRequest request = settings(job);
            request.software = software;
            request.created_utc = created_utc;
            return processTake(request, job);
        },
        [this, path, take, kept = session().keepInPlace(path)](Result<ProcessSummary> summary) -> QString {
            if (!summary) {
                if (summary.error().is_damage)
                    this->take().noteDamage(path, summary.error());
                else if (summary.error().kind != ErrorKind::kCancelled)
                    emit failed(coreWords(summary.error().message), coreWords(summary.error().remedy),
                                About::kProcess);
                return {};
            }
            session().refresh(path);
            if (this->take().path() == path)
                this->take().reload(true);
            else
                session().keepShownResult(session().indexOf(path), {});  // as the new one of an open take
            QString result = tr("%1 of %2 is ready: %n pose(s)", "name of the result, of the take",
                                static_cast<int>(summary->poses))
                                 .arg(words(summary->run_name), take);
            emit said(result);
            return result;
        });
    this->take().followProcessing(path, job);
    return job;
}

void Studio::processInTurn(std::vector<std::pair<std::string, PartsOfOne>> takes) {
    emit settled(About::kProcess);
    processNext(std::move(takes));
}

/// What failed with the takes before it is still told.
void Studio::processNext(std::vector<std::pair<std::string, PartsOfOne>> takes) {
    if (takes.empty())
        return;
    const auto [path, own] = std::move(takes.front());
    takes.erase(takes.begin());
    connect(startAccurately(path, own), &Job::ended, this,
            [this, rest = std::move(takes)] { processNext(rest); });
}

}  // namespace noctule::ui
