// SPDX-License-Identifier: Apache-2.0
#include "app/studio/sample_take.h"

#include <QFile>

#include "app/batch/files.h"
#include "core/formats/bvh.h"
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

}  // namespace

Status makeSampleTake(const std::string& path, const std::string& created_utc, const std::string& software,
                      const JobContext& job) {
    auto clip = sampleMotion();
    if (!clip)
        return clip.error();
    job.progress(0, "Preparing the motion");
    simulation::StageRequest request;
    request.suit = defaultSuit();
    request.clip = std::move(*clip);
    request.scenario = simulation::Scenario::nominal();
    const auto stage = simulation::prepareStage(request);
    if (!stage)
        return stage.error();
    if (job.cancelled())
        return JobContext::cancelledError();
    simulation::TakeRequest take;
    take.out_path = path;
    take.name = batch::takeName(path);
    take.created_utc = created_utc;
    take.software = software;
    if (const auto summary = simulation::writeTake(*stage, take, job); !summary)
        return summary.error();
    return Done{};
}

}  // namespace noctule::studio
