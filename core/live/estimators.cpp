// SPDX-License-Identifier: Apache-2.0
#include "core/live/estimators.h"

#include <algorithm>

#include "core/estimation/manifold_parameters.h"
#include "core/estimation/paper_parameters.h"
#include "core/job/nearest_word.h"
#include "core/live/point_estimators.h"

namespace noctule {
namespace {

Result<std::vector<UnnamedFile>> spoolFiles(size_t count, const std::string& folder) {
    std::vector<UnnamedFile> files;
    while (files.size() < count) {
        auto file = UnnamedFile::make(folder, "what smoothing puts aside",
                                      "Check that you may write there, or process without smoothing");
        if (!file)
            return file.error();
        files.push_back(std::move(*file));
    }
    return files;
}

ManifoldSetup manifoldSetup(const TrackerSettings& settings) {
    ManifoldSetup setup = settingsFrom(manifoldParameters(), settings.parameters);
    ManifoldParameters& parameters = setup.filter;
    parameters.sensors = settings.sensors;
    parameters.root_given = settings.root_given;
    parameters.g_m_per_s2 = settings.g_m_per_s2;
    parameters.ground.ground = settings.ground;
    parameters.ground.given = settings.contacts;
    setup.live_relocation.silence_s = parameters.relocation.silence_s;
    if (settings.smoother == Smoother::kNone)
        parameters.relocation = setup.live_relocation;
    return setup;
}

Result<std::unique_ptr<Estimator>> makeManifold(const EstimatorWorld& world) {
    const TrackerSettings& settings = world.settings;
    const ManifoldSetup setup = manifoldSetup(settings);
    const ManifoldParameters& parameters = setup.filter;
    const Skeleton& skeleton = world.actor.skeleton;
    const size_t wanted = settings.smoother == Smoother::kBatch  ? 3
                          : settings.smoother == Smoother::kFull ? 1
                                                                 : 0;
    auto files = spoolFiles(wanted, settings.spool_folder);
    if (!files)
        return files.error();
    std::unique_ptr<Estimator> estimator;
    if (settings.smoother == Smoother::kBatch)
        estimator = std::make_unique<BatchSmoother>(
            skeleton, world.mounted, parameters,
            BatchFiles{std::move((*files)[0]), std::move((*files)[1]), std::move((*files)[2])}, setup.batch);
    else if (settings.smoother == Smoother::kFull)
        estimator = std::make_unique<FixedIntervalSmoother>(skeleton, world.mounted, parameters,
                                                            std::move((*files)[0]), setup.stretch_s);
    else if (settings.smoother == Smoother::kLag)
        estimator = std::make_unique<FixedLagSmoother>(skeleton, world.mounted, parameters, setup.lag_s,
                                                       setup.stride_s);
    else
        estimator = std::make_unique<ManifoldFilter>(skeleton, world.mounted, parameters);
    return estimator;
}

Result<std::unique_ptr<Estimator>> makePaper(const EstimatorWorld& world) {
    PaperParameters parameters = settingsFrom(paperParameters(), world.settings.parameters);
    parameters.sensors = world.settings.sensors;
    parameters.root_given = world.settings.root_given;
    parameters.g_m_per_s2 = world.settings.g_m_per_s2;
    const KinematicTree tree(world.actor.skeleton, BallCoordinates::kEuler);
    auto mounted = mountSuit(world.suit, world.calibration, world.actor, tree);
    if (!mounted)
        return mounted.error();
    return std::unique_ptr<Estimator>(
        std::make_unique<PaperFilter>(world.actor.skeleton, std::move(*mounted), world.mounted, parameters));
}

Result<std::unique_ptr<Estimator>> refuseLive(const EstimatorWorld& world) {
    const std::string& name = world.settings.estimator;
    return Error{ErrorKind::kUsage, "estimator " + name + " needs a whole take",
                 "Record first, then process the take with --estimator " + name};
}

EstimatorEntry pointEstimator(const std::string& name, const std::string& summary) {
    return {name, summary, pointParameters(name), false, false, Detector::kInflection, true, refuseLive};
}

}  // namespace

ManifoldParameters filterParameters(const TrackerSettings& settings) {
    return manifoldSetup(settings).filter;
}

const std::vector<EstimatorEntry>& estimators() {
    static const std::vector<EstimatorEntry> kAll{
        {"manifold", "extended Kalman filter with rotations on the manifold, adaptive noise and smoothers",
         describe(manifoldParameters()), true, true, Detector::kMatched, false, makeManifold},
        {"paper", "the Kalman filter of Vlasic 2007 to the letter, as a baseline",
         describe(paperParameters()), false, false, Detector::kInflection, false, makePaper, true},
        {"orientation",
         "suits of independent inertial sensors: each one's orientation, then the body's pose; whole takes",
         {},
         true,
         true,
         Detector::kMatched,
         true,
         refuseLive},
        pointEstimator(
            "comocap",
            "Welch 2018: microphones and sources of several people as free points, from the ranges "
            "to the room, within and between people; a table of points, no poses"),
        pointEstimator("ms-comocap", "Welch 2018: comocap with a share of the ranges"),
        pointEstimator("environment", "Welch 2018: the same points from the ranges to the room alone"),
    };
    return kAll;
}

const EstimatorEntry* findEstimator(const std::string& name) {
    const auto found = std::ranges::find(estimators(), name, &EstimatorEntry::name);
    return found == estimators().end() ? nullptr : &*found;
}

Result<const EstimatorEntry*> estimatorNamed(const std::string& name) {
    if (const EstimatorEntry* found = findEstimator(name))
        return found;
    std::vector<std::string> names;
    for (const EstimatorEntry& entry : estimators())
        names.push_back(entry.name);
    const std::string near = nearestWord(name, names);
    return Error{ErrorKind::kUsage, "there is no estimator '" + name + "'",
                 near.empty() ? "`noctule --batch estimators` lists all"
                              : "Did you mean " + near + "? `noctule --batch estimators` lists all"};
}

}  // namespace noctule
