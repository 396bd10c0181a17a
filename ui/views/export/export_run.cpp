// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_run.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <span>

#include "core/job/staged_progress.h"
#include "core/processing/export_names.h"
#include "core/processing/run_subjects.h"
#include "core/review/take_review.h"
#include "ui/language/core_words.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/review_words.h"

namespace noctule::ui {
namespace {

constexpr double kFacing_rad = 0.1;
constexpr double kSmallest_m = 1e-6, kSmallest_rad = radians(1e-4);  ///< that is told

struct RunWords {
    Q_DECLARE_TR_FUNCTIONS(noctule::ui::ExportRun)
};

std::vector<ExportRequest> requestsOf(std::span<const ExportJob> takes) {
    std::vector<ExportRequest> requests;
    for (const ExportJob& take : takes)
        requests.push_back(take.request);
    return requests;
}

/// "2: Gyroscopes only"
QString resultTitle(const std::string& take_path, const std::string& run, const JobContext& context) {
    if (const auto overview = overviewTake(take_path, context))
        for (const ReviewRun& each : overview->runs)
            if (each.run.name == run)
                return numberedTitle(each);
    return QString::fromStdString(run);
}

/// The take that is damaged, by the file's name with which the error begins. Null: none of them is.
const ExportJob* damagedOf(std::span<const ExportJob> takes, const Error& error) {
    const auto found = std::ranges::find_if(takes, [&](const ExportJob& take) {
        return error.message.starts_with(take.request.take_path + ":");
    });
    return error.is_damage && found != takes.end() ? &*found : nullptr;
}

/// The outcome of a file that could not be written.
ExportOutcome failedOutcome(std::span<const ExportJob> takes, const Error& error) {
    const ExportJob& first = takes.front();
    const ExportJob* damaged = damagedOf(takes, error);
    ExportOutcome outcome{first.in_one_file ? QString() : first.take, first.path(), {}, error, false};
    if (damaged) {
        outcome.take = damaged->take;
        outcome.path = damaged->path();
        outcome.in_one_file = damaged->in_one_file;
        outcome.damaged_take = damaged->request.take_path;
    }
    return outcome;
}

/// One file, then the check of each take in it.
std::vector<ExportOutcome> writeAndCheck(std::span<const ExportJob> takes, const JobContext& context) {
    const ExportJob& first = takes.front();
    const JobContext silent{nullptr, context.cancel};
    const auto written =
        first.in_one_file ? exportStacks(requestsOf(takes), context) : exportTake(first.request, context);
    if (!written)
        return {failedOutcome(takes, written.error())};
    const auto checks =
        first.in_one_file ? checkStacks(requestsOf(takes), silent) : checkExport(first.request, silent);
    std::vector<ExportOutcome> outcomes;
    for (size_t i = 0; i < takes.size() && !context.cancelled(); ++i) {
        ExportOutcome outcome{takes[i].take, first.path(), {}, {}, first.in_one_file};
        if (checks) {
            outcome.check = (*checks)[i];
            outcome.result = resultTitle(takes[i].request.take_path, outcome.check.run, silent);
        } else {
            outcome.error = checks.error();
            if (damagedOf(takes.subspan(i, 1), checks.error()))
                outcome.damaged_take = takes[i].request.take_path;
        }
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

/// `path`, or one with a number behind its name where a file is there or the name is in `taken`.
std::string freePathOf(const std::string& path, ExportFormat format, std::set<std::string>& taken) {
    const std::filesystem::path named(path);
    return freeFilePath(named.parent_path().string(), named.stem().string(), entryOf(format).extension,
                        taken);
}

/// A take of several people is one job for each of them. In one file they are characters of their own; stacks
/// of several takes share one body, so that such a take cannot stand among them.
Result<std::vector<ExportJob>> oneForEachPerson(const std::vector<ExportJob>& jobs) {
    std::vector<ExportJob> all;
    std::set<std::string> taken;
    for (const ExportJob& job : jobs) {
        const bool is_alone = std::ranges::count(jobs, job.path(), &ExportJob::path) == 1;
        const bool together = job.in_one_file && is_alone;
        const auto requests = together ? requestsTogether(job.request) : requestsOfSubjects(job.request);
        if (together && !requests)
            return requests.error();
        if (requests && requests->size() > 1 && job.in_one_file && !together)
            return Error{ErrorKind::kUnusable, job.request.take_path + ": holds several performers",
                         RunWords::tr("Export it by itself, or without one file for all").toStdString()};
        if (!requests || requests->size() == 1) {
            all.push_back(job);
            continue;
        }
        for (const ExportRequest& request : *requests) {
            all.push_back(job);
            all.back().request = request;
            if (together) {
                all.back().take = RunWords::tr("%1, %2", "take, performer")
                                      .arg(job.take, QString::fromStdString(request.character));
                continue;
            }
            std::string& path = all.back().request.*entryOf(job.format).path;
            path = freePathOf(path, job.format, taken);
        }
    }
    return all;
}

Status makeFolderOf(const ExportJob& job) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::path(job.path()).parent_path();
    std::filesystem::create_directories(folder, error);
    if (error)
        return Error{ErrorKind::kDisk, folder.string() + ": the folder cannot be made",
                     "Choose another folder, or look at its rights"};
    return Done{};
}

/// How many different files are among outcomes that `is_meant`.
template <class Meant>
int filesOf(const std::vector<ExportOutcome>& outcomes, Meant is_meant) {
    std::set<std::string> paths;
    for (const ExportOutcome& outcome : outcomes)
        if (is_meant(outcome))
            paths.insert(outcome.path);
    return static_cast<int>(paths.size());
}

/// Takes of one file stand together.
size_t takesInFileAt(const std::vector<ExportJob>& jobs, size_t first) {
    size_t count = 1;
    while (first + count < jobs.size() && jobs[first + count].path() == jobs[first].path())
        ++count;
    return count;
}

QString fileName(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).fileName();
}

}  // namespace

int ExportResults::written() const {
    return filesOf(outcomes, [](const ExportOutcome& outcome) { return !outcome.error; });
}

int ExportResults::faulty() const {
    return filesOf(outcomes,
                   [](const ExportOutcome& outcome) { return outcome.error || !outcome.check.ok(); });
}

const std::vector<std::string>& PerformerNames::of(const ExportRequest& request) {
    const QDateTime changed = QFileInfo(QString::fromStdString(request.take_path)).lastModified();
    const auto [known, is_new] = known_.try_emplace({request.take_path, request.run});
    Asked& asked = known->second;
    if (is_new || asked.changed != changed) {
        asked = {changed, {}};
        if (const auto subjects = subjectsOfRun(request.take_path, request.run))
            for (const TakeSubject& subject : *subjects)
                asked.names.push_back(subject.name);
    }
    return asked.names;
}

int fileCount(const std::vector<ExportJob>& jobs, PerformerNames& performers) {
    std::set<std::string> paths;
    int files = 0;
    for (const ExportJob& job : jobs)
        if (paths.insert(job.path()).second)
            files += job.in_one_file ? 1 : std::max(1, static_cast<int>(performers.of(job.request).size()));
    return files;
}

int fileCount(const std::vector<ExportJob>& jobs) {
    PerformerNames performers;
    return fileCount(jobs, performers);
}

QStringList fileNames(const std::vector<ExportJob>& jobs, int most, PerformerNames& performers) {
    std::set<std::string> taken;
    QStringList names;
    for (const ExportJob& job : jobs) {
        if (names.size() >= most)
            break;
        const std::vector<std::string> people =
            job.in_one_file ? std::vector<std::string>() : performers.of(job.request);
        if (people.size() > 1) {
            for (const std::string& person : people)
                names += fileName(freePathOf(pathOfSubject(job.path(), person), job.format, taken));
        } else if (const QString name = fileName(job.path()); !names.contains(name)) {
            names += name;
        }
    }
    return names.mid(0, most);
}

Result<ExportResults> runExport(const std::vector<ExportJob>& of_takes, const JobContext& job) {
    QElapsedTimer clock;
    clock.start();
    const auto each = oneForEachPerson(of_takes);
    if (!each && damagedOf(of_takes, each.error()))
        return ExportResults{{failedOutcome(of_takes, each.error())}};
    if (!each)
        return each.error();
    const std::vector<ExportJob>& jobs = *each;
    ExportResults results;
    for (size_t i = 0, per_file = 1; i < jobs.size(); i += per_file) {
        per_file = takesInFileAt(jobs, i);
        if (const Status made = makeFolderOf(jobs[i]); !made)
            return made.error();
        const auto share = [&](size_t takes) {
            return static_cast<double>(takes) / static_cast<double>(jobs.size());
        };
        const QString what = jobs[i].in_one_file ? fileName(jobs[i].path()) : jobs[i].take;
        StagedProgress part(job, share(i), share(i + per_file),
                            RunWords::tr("Writing and checking %1").arg(what).toStdString());
        part.job().progress(0, {});
        for (ExportOutcome& outcome : writeAndCheck({&jobs[i], per_file}, part.job()))
            results.outcomes.push_back(std::move(outcome));
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
    job.in_one_file = false;
    return runExport({job}, context);
}

QString heightInWords(const ExportCheck& check, Units units) {
    const QString height = lengthText(check.height_m, 2, units);
    if (std::abs(check.lowest_m) <= ExportCheck::kOnFloor_m)
        return RunWords::tr("%1, feet on the floor").arg(height);
    return check.lowest_m > 0 ? RunWords::tr("%1, lowest point %2 above the floor")
                                    .arg(height, lengthText(check.lowest_m, 2, units))
                              : RunWords::tr("%1, lowest point %2 below the floor")
                                    .arg(height, lengthText(-check.lowest_m, 2, units));
}

QString belowFloorInWords(const ExportCheck& check, Units units) {
    const QString lowest = lengthText(-check.lowest_m, 2, units),
                  usual = lengthText(-check.usual_lowest_m, 2, units);
    switch (check.floorRemedy()) {
        case FloorRemedy::kNone:
            break;
        case FloorRemedy::kHoldFeet:
            return RunWords::tr(
                       "The figure goes %1 below the floor: this result holds no feet on it. If they stood "
                       "on a level floor, process the take with filter Noctule, gyroscopes and Level floor.")
                .arg(lowest);
        case FloorRemedy::kLevelGround:
            return RunWords::tr(
                       "The figure goes %1 below the floor of the rest pose, as it may on uneven ground. If "
                       "the floor was level, process the take with Level floor.")
                .arg(lowest);
        case FloorRemedy::kMoveUp:
            return RunWords::tr(
                       "The figure stands %1 below the floor. Move the motion up by that in the program "
                       "that reads it.")
                .arg(usual);
        case FloorRemedy::kOtherSystem:
            return RunWords::tr(
                       "The figure stands %1 below the floor: its height is that of the other system. "
                       "Correct the floor there, or move the motion up in the program that reads it.")
                .arg(usual);
        case FloorRemedy::kRoom:
            return RunWords::tr(
                       "The figure stands %1 below the floor: its height is that of the anchors. Check how "
                       "high they hang, or move the motion up in the program that reads it.")
                .arg(usual);
    }
    return {};
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
    QStringList lines;
    if (check.has_figure)
        lines << RunWords::tr("Height: %1").arg(heightInWords(check, Units::kMetric))
              << RunWords::tr("Facing: %1").arg(facingInWords(check));
    lines << RunWords::tr("Joints: %1 of %2").arg(check.joints).arg(check.expected_joints)
          << RunWords::tr("Largest difference to the take: %1").arg(differenceInWords(check));
    if (const QString below = belowFloorInWords(check, Units::kMetric); !below.isEmpty())
        lines << below;
    return lines;
}

}  // namespace

QString checkAsText(const ExportResults& results) {
    QStringList lines;
    for (const ExportOutcome& outcome : results.outcomes) {
        lines += fileName(outcome.path);
        if (outcome.error) {
            lines += "  " + coreWords(outcome.error->text());
            continue;
        }
        const ExportCheck& check = outcome.check;
        lines += "  " + RunWords::tr("Take %1, result: %2").arg(outcome.take, outcome.result);
        lines += "  " + RunWords::tr("%1 of %2 frames at %3 per second, %4")
                            .arg(countText(static_cast<qint64>(check.frames)),
                                 countText(static_cast<qint64>(check.expected_frames)),
                                 numberText(check.frames_per_second, 2), bytesText(check.bytes));
        for (const QString& line : check.is_picture ? QStringList(pictureInWords(check)) : motionLines(check))
            lines += "  " + line;
        for (const SilentBoard& silent : check.silent)
            lines += "  " + silenceInWords(silent);
        for (const std::string& held : check.held)
            lines += "  " + coreWords(held);
        for (const std::string& fault : check.faults)
            lines += "  " + coreWords(fault);
    }
    return lines.join('\n') + '\n';
}

}  // namespace noctule::ui
