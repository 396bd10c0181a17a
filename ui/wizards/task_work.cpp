// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/task_work.h"

#include <QFileInfo>
#include <stdexcept>

#include "core/guide/field_guide.h"
#include "core/guide/movement_guide.h"
#include "core/guide/placement_guide.h"
#include "core/guide/side_guide.h"
#include "core/guide/stand_guide.h"
#include "core/guide/turn_guide.h"
#include "core/job/atomic_file.h"

namespace noctule::ui {

std::unique_ptr<Guide> makeGuide(WizardTask task, const Suit& suit, const Calibration& known,
                                 int sample_rate_hz, const KnownDistances& distances) {
    switch (task) {
        case WizardTask::kSources:
            return std::make_unique<PlacementGuide>(suit, known, sample_rate_hz, distances);
        case WizardTask::kAccelerometers:
            return std::make_unique<SideGuide>(suit, known, sample_rate_hz);
        case WizardTask::kGyroscopes:
            return std::make_unique<TurnGuide>(suit, known, sample_rate_hz, 0);
        case WizardTask::kMagnetometers:
            return std::make_unique<FieldGuide>(suit, known, sample_rate_hz);
        case WizardTask::kMovement:
            return std::make_unique<MovementGuide>(suit, known, sample_rate_hz);
        case WizardTask::kRestPose:
        case WizardTask::kCheck:
            return std::make_unique<StandGuide>(suit, known, sample_rate_hz);
    }
    throw std::logic_error("every task has a guide");
}

Result<CalibrationResult> solveTask(WizardTask task, const CalibrateRequest& request,
                                    const KnownDistances& distances, const JobContext& job) {
    switch (task) {
        case WizardTask::kSources:
            return calibrateSources(request, distances, {}, job);
        case WizardTask::kAccelerometers:
            return calibrateAccelerometers(request, job);
        case WizardTask::kGyroscopes:
            return calibrateGyroscopes(request, 0, job);
        case WizardTask::kMagnetometers:
            return calibrateMagnetometers(request, std::nullopt, job);
        case WizardTask::kRestPose:
            return calibrateRestPose(request, job);
        case WizardTask::kMovement:
            return calibrateMotion(request, job);
        case WizardTask::kCheck:
            return checkStill(request, job);
    }
    throw std::logic_error("every task has a solver");
}

Result<KnownDistances> readDistances(const QString& path) {
    const auto text = readWholeFile(path.toStdString());
    if (!text)
        return text.error();
    const std::string name = QFileInfo(path).fileName().toStdString();
    const std::string header = text->substr(0, text->find('\n'));
    return header.find("distance") != std::string::npos ? readTapeMeasureCsv(*text, name)
                                                        : readDigitizerCsv(*text, name);
}

}  // namespace noctule::ui
