// SPDX-License-Identifier: Apache-2.0
#include "ui/models/suit_memory.h"

#include <QDir>
#include <QRegularExpression>
#include <algorithm>

#include "core/job/atomic_file.h"
#include "core/processing/outside_files.h"
#include "core/suit/calibration_parts.h"

namespace noctule::ui {
namespace {

bool tellsAnything(const Calibration& parts) {
    return std::ranges::any_of(parts.boards, [](const auto& board) { return !board.made.empty(); }) ||
           std::ranges::any_of(parts.sources, [](const auto& source) { return !source.offsets_s.empty(); });
}

}  // namespace

QString fileNameOf(QString words) {
    return words.replace(QRegularExpression("[^A-Za-z0-9._-]"), "-");
}

QString SuitMemory::folderOf(const QString& serial) const {
    return QDir(folder_).filePath(fileNameOf(serial));
}

Status SuitMemory::keep(const QString& serial, const Calibration& calibration) const {
    const Calibration parts = withoutWearing(calibration);
    if (serial.isEmpty() || !tellsAnything(parts))
        return Done{};
    const QDir folder(folderOf(serial));
    folder.mkpath(".");
    const QString base = fileNameOf(QString::fromStdString(parts.created_utc));
    QString name = base + ".json";
    for (int number = 2; folder.exists(name); ++number)
        name = QStringLiteral("%1-%2.json").arg(base).arg(number, 3, 10, QChar('0'));
    return writeFileAtomically(folder.filePath(name).toStdString(), toJson(parts).dump(2) + "\n", false);
}

std::optional<Calibration> SuitMemory::latest(const QString& serial,
                                              const std::vector<Calibration>& except) const {
    std::vector<nlohmann::json> others;
    for (const Calibration& calibration : except)
        others.push_back(toJson(withoutWearing(calibration)));
    if (serial.isEmpty())
        return std::nullopt;
    const QDir folder(folderOf(serial));
    std::optional<Calibration> latest;
    for (const QString& file : folder.entryList({"*.json"}, QDir::Files, QDir::Name))
        if (auto calibration = readCalibrationFile(folder.filePath(file).toStdString()))
            if ((!latest || calibration->created_utc >= latest->created_utc) &&
                std::ranges::find(others, toJson(*calibration)) == others.end())
                latest = std::move(*calibration);
    return latest;
}

}  // namespace noctule::ui
