// SPDX-License-Identifier: Apache-2.0
#include "core/import/markers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/body/actor.h"
#include "core/formats/number_text.h"
#include "core/import/import_format.h"
#include "core/import/sensor_rows.h"
#include "core/job/atomic_file.h"

namespace noctule {

namespace {

constexpr size_t kMostMarkerBytes = size_t{2} << 30;

std::string markerExtension(const std::string& path) {
    return ImportFile{path, ""}.extension();
}

struct JointMarkers {
    std::string joint;
    std::vector<size_t> markers;
};

std::string namesOf(const MarkerRecording& markers) {
    std::string names;
    for (const std::string& name : markers.names)
        if (names.size() < 300)
            names += (names.empty() ? "" : ", ") + name;
    return names;
}

Result<std::vector<JointMarkers>> jointsAsNamed(const MarkerRecording& markers, const std::string& where) {
    std::vector<JointMarkers> joints;
    for (const std::string& joint : canonicalJointNames())
        for (size_t m = 0; m < markers.names.size(); ++m)
            if (markers.names[m] == joint)
                joints.push_back({joint, {m}});
    if (!joints.empty())
        return joints;
    return Error{ErrorKind::kUsage,
                 where + ": no marker carries a joint's name; they are " + namesOf(markers),
                 "Attach it by noctule --batch attach, and say which markers surround which joint: --markers "
                 "MAP.json with {\"Hips\": [\"LASI\", \"RASI\"], ...}"};
}

Result<std::vector<JointMarkers>> jointsAsMapped(const MarkerRecording& markers, const nlohmann::json& map,
                                                 const std::string& where) {
    std::vector<JointMarkers> joints;
    for (const auto& [joint, list] : map.items()) {
        JointMarkers one{joint, {}};
        for (const auto& name : list.is_array() ? list : nlohmann::json::array()) {
            const auto found = std::find(markers.names.begin(), markers.names.end(),
                                         name.is_string() ? name.get<std::string>() : "");
            if (found == markers.names.end())
                return Error{ErrorKind::kUsage, where + ": has no marker " + name.dump().substr(0, 60),
                             "Its markers are: " + namesOf(markers)};
            one.markers.push_back(size_t(found - markers.names.begin()));
        }
        if (one.markers.empty())
            return Error{ErrorKind::kUsage, "The markers of " + joint + " are no list of names",
                         "Write \"" + joint + "\": [\"NAME\", ...]"};
        joints.push_back(std::move(one));
    }
    return joints;
}

/// The file's axes to ours by the one that points up; what lies ahead is not known.
Matrix3d worldFromUp(const std::string& up) {
    Matrix3d R = Matrix3d::Identity();
    if (up == "Z")
        R << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    if (up == "X")
        R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    return R;
}

Vector3d meanOf(const MarkerRecording& markers, size_t row, const std::vector<size_t>& of) {
    Vector3d sum = Vector3d::Zero();
    for (const size_t m : of)
        sum += markers.at(row, m);
    return sum / double(of.size());
}

}  // namespace

bool isMarkerFile(const std::string& path) {
    return markerExtension(path) == ".c3d" || markerExtension(path) == ".trc";
}

Result<MarkerRecording> readMarkers(const std::string& path, const JobContext& job) {
    ReadOptions options;
    options.cancel = job.cancel;
    options.most_bytes = options.most_stream_bytes = kMostMarkerBytes;
    auto bytes = readWholeFile(path, options);
    if (!bytes)
        return bytes.error();
    return markerExtension(path) == ".c3d" ? parseC3d(*bytes, path, job) : parseTrc(*bytes, path, job);
}

Result<PositionTable> jointsOfMarkers(const MarkerRecording& markers, const nlohmann::json& map,
                                      const std::string& up, const std::string& where) {
    const auto joints =
        map.is_object() && !map.empty() ? jointsAsMapped(markers, map, where) : jointsAsNamed(markers, where);
    if (!joints)
        return joints.error();
    const std::string& axis = up.empty() ? markers.up : up;
    if (axis != "X" && axis != "Y" && axis != "Z")
        return Error{ErrorKind::kUsage, where + ": does not say which axis points up",
                     "Give it: --up y (OpenSim) or --up z (most laboratories)"};
    const Matrix3d R = worldFromUp(axis);
    PositionTable table;
    table.warnings = markers.warnings;
    for (const JointMarkers& one : *joints)
        table.joints.push_back(one.joint);
    size_t unseen = 0;
    for (size_t row = 0; row < markers.rows(); ++row) {
        std::vector<Vector3d> places;
        for (const JointMarkers& one : *joints)
            places.push_back(R * meanOf(markers, row, one.markers));
        if (!std::all_of(places.begin(), places.end(), [](const Vector3d& p) { return p.allFinite(); })) {
            ++unseen;
            continue;
        }
        table.time_s.push_back(double(row) / markers.rate_hz);
        table.p_world_m.insert(table.p_world_m.end(), places.begin(), places.end());
    }
    if (unseen > 0)
        table.warnings.push_back(where + ": " + std::to_string(unseen) + " of " +
                                 std::to_string(markers.rows()) +
                                 " rows lack a marker of a joint and were left out.");
    if (table.time_s.empty())
        return Error{ErrorKind::kUnusable, where + ": in no row all of these markers are seen",
                     "Choose other markers"};
    return table;
}

}  // namespace noctule
