// SPDX-License-Identifier: Apache-2.0
// Writes files one after the other and reads each again: one job.
#pragma once

#include <QDateTime>
#include <map>
#include <vector>

#include "core/processing/check_export.h"
#include "ui/style/lengths.h"
#include "ui/views/export/export_settings.h"

namespace noctule::ui {

/// What became of one take: the check of its file, or why there is none. A file of several takes that could
/// not be written is one outcome, of the take that is damaged or of none.
struct ExportOutcome {
    QString take;
    std::string path;
    ExportCheck check;
    std::optional<Error> error;
    bool in_one_file = false;    ///< the take is one of several in the file
    QString result{};            ///< title of the result that went out, as Review has it
    std::string damaged_take{};  ///< path of the take whose database is torn; empty: the error is another one
};

struct ExportResults {
    std::vector<ExportOutcome> outcomes;
    double seconds = 0;

    int written() const;  ///< files
    int faulty() const;   ///< files that are not there, or of which the check found something
};

/// The performers whom the results of takes hold; a file is asked again only after it changed.
class PerformerNames {
public:
    /// None when they cannot be read.
    const std::vector<std::string>& of(const ExportRequest& request);

private:
    struct Asked {
        QDateTime changed;
        std::vector<std::string> names;
    };
    std::map<std::pair<std::string, std::string>, Asked> known_;  ///< by take and run
};

/// How many files the jobs make: one for each performer, or one for all.
int fileCount(const std::vector<ExportJob>& jobs, PerformerNames& performers);
int fileCount(const std::vector<ExportJob>& jobs);

/// The first `most` files that the jobs make, without their folder, as runExport() names them.
QStringList fileNames(const std::vector<ExportJob>& jobs, int most, PerformerNames& performers);

/// A file for each person of a take of several, or one in which each is a character. Goes on after a take
/// that fails; an Error only when cancelled, the folder cannot be made, or several takes with several people
/// are wanted in one file.
Result<ExportResults> runExport(const std::vector<ExportJob>& of_takes, const JobContext& job);

/// The frame at `time_s` of the first one, written to a temporary folder, checked and deleted.
Result<ExportResults> tryOneFrame(ExportJob job, double time_s, const JobContext& context);

/// The whole check as plain text.
QString checkAsText(const ExportResults& results);
/// "1.78 m, feet on the floor", "+Z, left hand to +X", "0.0004°, 0.001 mm".
QString heightInWords(const ExportCheck& check, Units units = chosenUnits());
QString facingInWords(const ExportCheck& check);
/// How far, and what helps (ExportCheck::floorRemedy()); empty: nothing is to be said.
QString belowFloorInWords(const ExportCheck& check, Units units = chosenUnits());
QString differenceInWords(const ExportCheck& check);
/// Of a picture or film: "1280 × 720 pixels".
QString pictureInWords(const ExportCheck& check);
/// "Board 7 (left forearm) was silent from 0:11.2 to 0:11.6. It follows its neighbours in those 25 frames."
QString silenceInWords(const SilentBoard& silent);

}  // namespace noctule::ui
