// SPDX-License-Identifier: Apache-2.0
#include "ui/models/motion_file.h"

#include <QCryptographicHash>
#include <algorithm>

#include "core/body/actor.h"
#include "core/formats/motion_document.h"
#include "core/math/json.h"

namespace noctule::ui {
namespace {

constexpr const char* kUp = "up";
constexpr const char* kBones = "bones";

/// A key of the settings for all files with these joints.
QString keyOf(const BvhDocument& document) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    for (const BvhJoint& joint : document.joints)
        hash.addData(QByteArray::fromStdString(joint.name) + '\n');
    return "motions/corrections/" + QString::fromLatin1(hash.result().toHex());
}

}  // namespace

Result<MotionFile> readMotionFile(const std::string& path, const figure::MotionHints& hints,
                                  const JobContext& job) {
    auto document = readMotionDocument(path, job);
    if (!document)
        return document.error();
    MotionFile file;
    for (const BvhWarning& warning : document->warnings)
        file.reader_warnings.push_back(toText(warning));
    file.document = std::make_shared<const BvhDocument>(std::move(*document));
    return understoodAnew(file, hints);
}

MotionFile understoodAnew(const MotionFile& file, const figure::MotionHints& hints) {
    MotionFile anew = file;
    auto motion = figure::understandMotion(*file.document, hints);
    anew.problem = motion ? std::nullopt : std::optional(motion.error());
    anew.motion = motion ? std::make_shared<const figure::UnderstoodMotion>(std::move(*motion)) : nullptr;
    return anew;
}

void KeptCorrections::keep(const BvhDocument& document, const figure::MotionHints& hints) {
    const QString key = keyOf(document);
    if (hints.joints.empty() && hints.up == figure::UpAxis::kAuto)
        return settings_.remove(key);
    const nlohmann::json kept{{kBones, hints.joints},
                              {kUp, hints.up == figure::UpAxis::kAuto ? "auto"
                                    : hints.up == figure::UpAxis::kZ  ? "z"
                                                                      : "y"}};
    settings_.setValue(key, QString::fromStdString(kept.dump()));
}

std::optional<figure::MotionHints> KeptCorrections::find(const BvhDocument& document) const {
    const nlohmann::json kept = json::parse(settings_.value(keyOf(document)).toString().toStdString());
    if (!kept.is_object())
        return std::nullopt;
    figure::MotionHints hints;
    if (const auto up = kept.find(kUp); up != kept.end() && up->is_string())
        if (const auto axis = figure::upAxisFromText(up->get<std::string>()))
            hints.up = *axis;
    if (const auto bones = kept.find(kBones); bones != kept.end() && bones->is_object())
        for (const auto& [joint, kept_name] : bones->items()) {
            const std::string name = kept_name.is_string() ? kept_name.get<std::string>() : "";
            if (std::ranges::count(document.joints, name, &BvhJoint::name) > 0 &&
                std::ranges::count(canonicalJointNames(), joint) > 0)
                hints.joints[joint] = name;
        }
    return hints;
}

}  // namespace noctule::ui
