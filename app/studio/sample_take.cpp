// SPDX-License-Identifier: Apache-2.0
#include "app/studio/sample_take.h"

#include <QFile>
#include <numbers>

#include "app/batch/files.h"
#include "core/formats/bvh.h"
#include "core/inertial/frame_layout.h"
#include "core/recording/take_edit.h"
#include "core/simulation/cast.h"
#include "core/simulation/simulate.h"
#include "core/suit/default_suit.h"

namespace noctule::studio {
namespace {

Result<MotionClip> sampleMotion() {
    QFile file(kSampleMotion);
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorKind::kInternal, "The sample motion is not part of this program",
                     "Install Noctule again"};
    const auto document = parseBvh(file.readAll().toStdString(), "sample.bvh");
    if (!document)
        return document.error();
    return toClip(*document);
}

constexpr double kPairApart_m = 2;

// Played in a loop. Rounds after the first start at 1 s and last 18 s, a multiple of the boards' 6 s stream
// period. Pose at 1 s and at 19 s: rest pose. Frames of the first second cannot be decoded without what
// precedes them.
constexpr double kRest_s = 5.2;
constexpr int kTake_s = 19, kLoopsFrom_s = 1;
static_assert((kTake_s - kLoopsFrom_s) % kStreamPeriod_s == 0);
static_assert(kLoopsFrom_s < kRest_s);

Status noteLoop(const std::string& path) {
    auto take = Take::open(path, Access::kReadWrite);
    if (!take)
        return take.error();
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (Status noted = edit->setMeta(kLoopsFromKey, std::to_string(kLoopsFrom_s)); !noted)
        return noted;
    return edit->commit();
}

struct Header {
    std::string path, created_utc, software;
};

Status writeStaged(const simulation::StageRequest& request, simulation::Level level, const Header& header,
                   const JobContext& job) {
    job.progress(0, "Preparing the motion");
    const auto stage = simulation::prepareStage(request);
    if (!stage)
        return stage.error();
    if (job.cancelled())
        return JobContext::cancelledError();
    simulation::TakeRequest take;
    take.out_path = header.path;
    take.level = level;
    take.name = batch::takeName(header.path);
    take.created_utc = header.created_utc;
    take.software = header.software;
    if (const auto summary = simulation::writeTake(*stage, take, job); !summary)
        return summary.error();
    return Done{};
}

}  // namespace

Status makeSampleTake(const std::string& path, const std::string& created_utc, const std::string& software,
                      const JobContext& job) {
    auto clip = sampleMotion();
    if (!clip)
        return clip.error();
    simulation::StageRequest request;
    request.suit = defaultSuit();
    request.clip = std::move(*clip);
    request.scenario = simulation::Scenario::nominal();
    request.rest_seconds = kRest_s;
    request.duration_s = kTake_s;
    const Status written =
        writeStaged(request, simulation::Level::kSignal, {path, created_utc, software}, job);
    return written ? noteLoop(path) : written;
}

Status makePairTake(const std::string& path, const std::string& created_utc, const std::string& software,
                    const JobContext& job) {
    const auto clip = sampleMotion();
    if (!clip)
        return clip.error();
    job.progress(0, "Preparing the motion");
    simulation::CastRequest request;
    for (const std::string name : {"A", "B"}) {
        simulation::CastSubject subject;
        subject.name = name;
        subject.stage.clip = *clip;
        subject.stage.suit = defaultSuit();
        subject.place = name == "A" ? simulation::StandingPlace{0, -kPairApart_m / 2, 0}
                                    : simulation::StandingPlace{0, kPairApart_m / 2, std::numbers::pi};
        request.subjects.push_back(std::move(subject));
    }
    request.shared_clock = true;
    request.scenario = simulation::Scenario::nominal();
    request.rest_seconds = kRest_s;
    request.duration_s = kTake_s;
    const auto cast = simulation::prepareCast(request);
    if (!cast)
        return cast.error();
    simulation::TakeRequest take;
    take.out_path = path;
    take.name = batch::takeName(path);
    take.created_utc = created_utc;
    take.software = software;
    const auto written = simulation::writeTake(*cast, take, job);
    return written ? noteLoop(path) : Status(written.error());
}

Status makeMotionTake(const MotionTake& wanted, const JobContext& job) {
    const auto scenario = simulation::Scenario::named(wanted.scenario);
    if (!scenario)
        return scenario.error();
    simulation::StageRequest request;
    request.suit = defaultSuit();
    request.clip = wanted.motion.clip;
    request.joints = wanted.motion.joints;
    request.scenario = *scenario;
    return writeStaged(request, simulation::Level::kReadings,
                       {wanted.path, wanted.created_utc, wanted.software}, job);
}

}  // namespace noctule::studio
