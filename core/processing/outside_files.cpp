// SPDX-License-Identifier: Apache-2.0
#include "core/processing/outside_files.h"

#include <algorithm>
#include <filesystem>

#include "core/formats/motion_document.h"
#include "core/formats/number_text.h"
#include "core/import/markers.h"
#include "core/job/atomic_file.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"
#include "core/motion/common_joints.h"
#include "core/recording/take.h"

namespace noctule {
namespace {

/// Y or Z, for TRC files never say: a person reaches farthest along the vertical, and one marker is highest
/// there.
std::string likelyUp(const MarkerRecording& markers) {
    Eigen::AlignedBox3d box(Vector3d::Zero());  // from the floor
    for (const Vector3d& place : markers.p_m)
        if (place.allFinite())
            box.extend(place);
    Eigen::AlignedBox3d means;
    for (size_t m = 0; m < markers.names.size(); ++m) {
        Vector3d sum = Vector3d::Zero();
        double count = 0;
        for (size_t row = 0; row < markers.rows(); ++row)
            if (markers.at(row, m).allFinite())
                sum += markers.at(row, m), count += 1;
        if (count > 0)
            means.extend(Vector3d(sum / count));
    }
    const Vector3d reach = markers.names.size() > 1 ? means.sizes() : Vector3d(box.max());
    return reach.y() >= reach.z() ? "Y" : "Z";
}

Result<PositionTable> readMarkedJoints(const std::string& path, const JobContext& job) {
    const auto markers = readMarkers(path, job);
    if (!markers)
        return markers.error();
    const std::string up = markers->up.empty() ? likelyUp(*markers) : "";
    auto joints = jointsOfMarkers(*markers, nlohmann::json::object(), up, path);
    if (joints && !up.empty())
        joints->warnings.push_back(std::filesystem::path(path).filename().string() +
                                   " does not say which axis points up; " + up +
                                   " was taken, along which its markers reach farthest.");
    return joints;
}

std::string sentence(const std::string& path, const BvhWarning& warning) {
    return std::filesystem::path(path).filename().string() + ", " + toText(warning) + ".";
}

}  // namespace

bool isPositionsFile(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension == ".csv" || extension == ".CSV";
}

bool holdsPlacesOnly(const std::string& path) {
    return isPositionsFile(path) || isMarkerFile(path);
}

Result<AttachRequest> readAttachment(const std::string& path, std::vector<std::string>& warnings,
                                     const JobContext& job) {
    AttachRequest request;
    request.source_name = path;
    if (holdsPlacesOnly(path)) {
        auto table = isPositionsFile(path) ? readPositionsCsv(path, job.cancel) : readMarkedJoints(path, job);
        if (!table)
            return table.error();
        warnings.insert(warnings.end(), table->warnings.begin(), table->warnings.end());
        request.positions = std::move(*table);
        return request;
    }
    const auto document = readMotionDocument(path);
    if (!document)
        return document.error();
    for (const BvhWarning& warning : document->warnings)
        warnings.push_back(sentence(path, warning));
    auto motion = figure::understandMotion(*document);
    if (motion) {
        for (const std::string& warning : motion->warnings)
            warnings.push_back(motion->clip.name + ": " + warning + ".");
        request.motion = OutsideMotion(std::move(*motion));
        return request;
    }
    auto as_it_is = partialMotion(*document, {}, motion.error(), warnings);
    if (!as_it_is)
        return as_it_is.error();
    request.motion = std::move(*as_it_is);
    return request;
}

Result<OutsideMotion> partialMotion(const BvhDocument& document, const figure::MotionHints& hints,
                                    const Error& why, std::vector<std::string>& warnings) {
    const bool corrected = hints.up != figure::UpAxis::kAuto || hints.height_m > 0 || !hints.joints.empty();
    if (corrected || document.frameCount() == 0)
        return why;
    const BvhUnitChoice choice =
        hints.unit == BvhUnit::kAuto ? chooseUnit(document) : BvhUnitChoice{hints.unit, 0, true};
    warnings.push_back(why.message + "; its names, axes and zero pose are taken as they are (Y up, unit " +
                       toText(choice.unit) + ")");
    if (!choice.plausible)
        warnings.push_back("No unit makes the figure in " + document.name + " as tall as a person");
    auto clip = toClip(document, choice.unit);
    if (!clip)
        return clip.error();
    return OutsideMotion(std::move(*clip));
}

Result<Calibration> readCalibrationFile(const std::string& path) {
    const auto text = readWholeFile(path);
    if (!text)
        return text.error();
    const nlohmann::json json = noctule::json::parse(*text);
    if (json.is_discarded())
        return Error{ErrorKind::kUnreadable, path + ": is not JSON", "Check that it is the right file"};
    return calibrationFromJson(json, path);
}

Result<ReferenceFacts> referenceFacts(const std::string& take_path) {
    const auto take = Take::open(take_path);
    if (!take)
        return take.error();
    const auto reference = take->reference();
    if (!reference)
        return reference.error();
    if (reference->frames.empty())
        return Error{ErrorKind::kUnusable, take_path + ": holds no reference", "Attach one first"};
    const auto actor = take->actorInForce();
    if (!actor)
        return actor.error();
    ReferenceFacts facts;
    const auto meta = [&](const char* key) {
        const auto found = take->meta().find(key);
        return found == take->meta().end() ? std::string() : shortText(found->second, limits::kName);
    };
    facts.kind = meta("reference_kind");
    facts.name = meta("reference_name");
    if (double shift_s = 0; parseFiniteNumber(meta("reference_shift_s"), shift_s))
        facts.shift_s = shift_s;
    const auto& joints = actor->value.skeleton.joints();
    facts.joints = static_cast<int>(std::count_if(
        joints.begin(), joints.end(), [](const Joint& joint) { return joint.type != JointType::kFixed; }));
    const auto common = commonJoints(actor->value.skeleton, reference->skeleton);
    facts.matched = static_cast<int>(
        std::count_if(common.begin(), common.end(), [](const CommonJoint& joint) { return joint.moves; }));
    return facts;
}

}  // namespace noctule
