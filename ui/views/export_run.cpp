// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export_run.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ui/models/part_names.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr double kOnFloor_m = 0.03, kFacing_rad = 0.1;
constexpr double kSmallest_m = 1e-6, kSmallest_rad = radians(1e-4);  ///< that is told

struct RunWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ExportRun)
};

/// A take's share of the progress, always under the same words; writing takes most of it.
class TakeProgress : public ProgressSink {
public:
    TakeProgress(const JobContext& whole, double from, double to, std::string words)
        : whole_(whole), from_(from), to_(to), words_(std::move(words)) {
        progress(0, {});
    }
    JobContext job() { return {this, whole_.cancel}; }
    void progress(double fraction, const std::string&) override {
        whole_.progress(from_ + (to_ - from_) * fraction, words_);
    }

private:
    JobContext whole_;
    double from_, to_;
    std::string words_;
};

ExportOutcome writeAndCheck(const ExportJob& job, const JobContext& context) {
    ExportOutcome outcome{job.take, job.path(), {}, {}};
    if (const auto written = exportTake(job.request, context); !written) {
        outcome.error = written.error();
        return outcome;
    }
    auto checks = checkExport(job.request, {nullptr, context.cancel});
    if (checks)
        outcome.check = std::move(checks->front());
    else
        outcome.error = checks.error();
    return outcome;
}

QString fileName(const ExportOutcome& outcome) {
    return QFileInfo(QString::fromStdString(outcome.path)).fileName();
}

}  // namespace

int ExportResults::written() const {
    return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(),
                                          [](const ExportOutcome& outcome) { return !outcome.error; }));
}

int ExportResults::faulty() const {
    return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(), [](const ExportOutcome& outcome) {
        return outcome.error || !outcome.check.ok();
    }));
}

Result<ExportResults> runExport(const std::vector<ExportJob>& jobs, const JobContext& job) {
    QElapsedTimer clock;
    clock.start();
    ExportResults results;
    for (size_t i = 0; i < jobs.size(); ++i) {
        std::error_code error;
        const std::filesystem::path folder = std::filesystem::path(jobs[i].path()).parent_path();
        std::filesystem::create_directories(folder, error);
        if (error)
            return Error{ErrorKind::kDisk, folder.string() + ": the folder cannot be made",
                         "Choose another folder, or look at its rights"};
        const double step = 1.0 / static_cast<double>(jobs.size()), begin = step * static_cast<double>(i);
        TakeProgress part(job, begin, begin + step,
                          RunWords::tr("Writing and checking %1").arg(jobs[i].take).toStdString());
        results.outcomes.push_back(writeAndCheck(jobs[i], part.job()));
        if (job.cancelled())
            return JobContext::cancelledError();
    }
    results.seconds = static_cast<double>(clock.elapsed()) / 1000;
    return results;
}

Result<ExportResults> tryOneFrame(ExportJob job, double time_s, const JobContext& context) {
    const QTemporaryDir folder;
    if (!folder.isValid())
        return Error{ErrorKind::kDisk, "There is no room for a temporary file",
                     "Free some space on the disk"};
    std::string& path = job.request.*entryOf(job.format).path;
    path = folder.filePath(QFileInfo(QString::fromStdString(path)).fileName()).toStdString();
    job.request.from_s = job.request.to_s = time_s;
    return runExport({job}, context);
}

QString heightInWords(const ExportCheck& check) {
    const QString height = metresText(check.height_m);
    if (std::abs(check.lowest_m) < kOnFloor_m)
        return RunWords::tr("%1, feet on the floor").arg(height);
    return check.lowest_m > 0
               ? RunWords::tr("%1, lowest point %2 above the floor").arg(height, metresText(check.lowest_m))
               : RunWords::tr("%1, lowest point %2 below the floor").arg(height, metresText(-check.lowest_m));
}

QString facingInWords(const ExportCheck& check) {
    const double turned_rad = std::remainder(check.facing_rad, 2 * M_PI);
    if (std::abs(turned_rad) < kFacing_rad)
        return RunWords::tr("+Z, left hand to +X");
    return turned_rad > 0 ? RunWords::tr("%1 to the left of +Z").arg(degreesText(turned_rad, 0))
                          : RunWords::tr("%1 to the right of +Z").arg(degreesText(-turned_rad, 0));
}

QString differenceInWords(const ExportCheck& check) {
    const QString distance = check.largest_position_m < kSmallest_m
                                 ? RunWords::tr("under %1").arg(millimetresText(kSmallest_m, 3))
                                 : millimetresText(check.largest_position_m, 3);
    if (!check.has_angles)
        return distance;
    const QString angle = check.largest_angle_rad < kSmallest_rad
                              ? RunWords::tr("under %1").arg(degreesText(kSmallest_rad, 4))
                              : degreesText(check.largest_angle_rad, 4);
    return RunWords::tr("%1, %2").arg(angle, distance);
}

QString silenceInWords(const SilentBoard& silent) {
    const QString from = timeText(silent.from_s), to = timeText(silent.to_s);
    const int frames = static_cast<int>(silent.frames);
    if (silent.board < 0)
        return RunWords::tr("All boards were silent from %1 to %2. The pose in those %n frames is a guess.",
                            nullptr, frames)
            .arg(from, to);
    return RunWords::tr(
               "Board %1 (%2) was silent from %3 to %4. It follows its neighbours in those %n frames.",
               nullptr, frames)
        .arg(silent.board + 1)
        .arg(segmentName(silent.segment, NameCase::kInside), from, to);
}

QString pictureInWords(const ExportCheck& check) {
    return RunWords::tr("%1 × %2 pixels").arg(check.size.width_px).arg(check.size.height_px);
}

namespace {

QStringList motionLines(const ExportCheck& check) {
    return {RunWords::tr("Height: %1").arg(heightInWords(check)),
            RunWords::tr("Facing: %1").arg(facingInWords(check)),
            RunWords::tr("Joints: %1 of %2").arg(check.joints).arg(check.expected_joints),
            RunWords::tr("Largest difference to the take: %1").arg(differenceInWords(check))};
}

}  // namespace

QString checkAsText(const ExportResults& results) {
    QStringList lines;
    for (const ExportOutcome& outcome : results.outcomes) {
        lines += fileName(outcome);
        if (outcome.error) {
            lines += "  " + QString::fromStdString(outcome.error->text());
            continue;
        }
        const ExportCheck& check = outcome.check;
        lines +=
            "  " + RunWords::tr("Take %1, result %2").arg(outcome.take, QString::fromStdString(check.run));
        lines += "  " + RunWords::tr("%1 of %2 frames at %3 per second, %4")
                            .arg(countText(static_cast<qint64>(check.frames)),
                                 countText(static_cast<qint64>(check.expected_frames)),
                                 numberText(check.frames_per_second, 2), bytesText(check.bytes));
        for (const QString& line : check.is_picture ? QStringList(pictureInWords(check)) : motionLines(check))
            lines += "  " + line;
        for (const SilentBoard& silent : check.silent)
            lines += "  " + silenceInWords(silent);
        for (const std::string& fault : check.faults)
            lines += "  " + QString::fromStdString(fault);
    }
    return lines.join('\n') + '\n';
}

}  // namespace noctule::ui
