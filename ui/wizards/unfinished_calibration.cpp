// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/unfinished_calibration.h"

#include <QDir>
#include <QFileInfo>
#include <nlohmann/json.hpp>
#include <set>

#include "core/job/atomic_file.h"
#include "core/math/json.h"
#include "ui/models/suit_memory.h"

namespace noctule::ui {
namespace {

constexpr const char* kUnfinishedFormat = "noctule-unfinished-calibration";

QString textIn(const nlohmann::json& json, const char* member) {
    return QString::fromStdString(json.value(member, std::string()));
}

}  // namespace

int UnfinishedCalibration::stepsDone() const {
    std::set<int> steps;
    for (const WizardEvidence& part : evidence)
        if (!part.boards.empty())
            steps.insert(part.step);
    return static_cast<int>(steps.size());
}

QString unfinishedPath(const QString& calibration_folder, const QString& task, const QString& serial) {
    const QDir folder(calibration_folder);
    const auto name = QStringLiteral("%1.%2.unfinished.json");
    if (!serial.isEmpty())
        return folder.filePath(name.arg(task, fileNameOf(serial)));
    const QStringList kept = folder.entryList({name.arg(task, "*")}, QDir::Files, QDir::Time);
    return kept.isEmpty() ? QString() : folder.filePath(kept.front());
}

Status writeUnfinished(const QString& path, const QString& task, const UnfinishedCalibration& unfinished) {
    nlohmann::json json;
    json["format"] = kUnfinishedFormat;
    json["version"] = 1;
    json["task"] = task.toStdString();
    json["started_utc"] = unfinished.started_utc.toStdString();
    json["distances"] = unfinished.distances_path.toStdString();
    if (unfinished.share > 0)
        json["share"] = unfinished.share;
    json["evidence"] = nlohmann::json::array();
    for (const WizardEvidence& part : unfinished.evidence)
        json["evidence"].push_back({{"file", QFileInfo(part.path).fileName().toStdString()},
                                    {"step", part.step},
                                    {"placement", part.placement.toStdString()},
                                    {"boards", part.boards}});
    return writeFileAtomically(path.toStdString(), json.dump(2) + "\n", true);
}

UnfinishedCalibration readUnfinished(const QString& path, const QString& evidence_folder) {
    const auto text = readWholeFile(path.toStdString());
    const auto json = noctule::json::parse(text ? *text : std::string());
    if (!json.is_object())
        return {};
    UnfinishedCalibration unfinished;
    try {
        if (json.value("version", 1) > 1)
            return {};
        unfinished.started_utc = textIn(json, "started_utc");
        unfinished.distances_path = textIn(json, "distances");
        unfinished.share = json.value("share", 0.0);
        for (const nlohmann::json& entry : json.at("evidence")) {
            const QString file = QDir(evidence_folder).filePath(QFileInfo(textIn(entry, "file")).fileName());
            const int step = entry.at("step").get<int>();
            if (step >= 0 && QFileInfo(file).isFile())
                unfinished.evidence.push_back({file, step, textIn(entry, "placement"),
                                               entry.at("boards").get<std::vector<std::string>>()});
        }
    } catch (const nlohmann::json::exception&) {
        return {};
    }
    return unfinished;
}

}  // namespace noctule::ui
