// SPDX-License-Identifier: Apache-2.0
// Markers of an optical system out of C3D and TRC files, in our world and metres.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/positions_csv.h"
#include "core/job/job.h"

namespace noctule {

struct MarkerRecording {
    double rate_hz = 0;
    std::string unit, up;            ///< as the file says or is taken: "mm", "Z"
    std::vector<std::string> names;  ///< without "subject:"
    std::vector<Vector3d> p_m;       ///< row after row; file's axes; NaN: not seen
    std::vector<std::string> warnings;

    size_t rows() const { return names.empty() ? 0 : p_m.size() / names.size(); }
    const Vector3d& at(size_t row, size_t marker) const { return p_m[row * names.size() + marker]; }
};

Result<MarkerRecording> parseC3d(std::string_view bytes, const std::string& where, const JobContext& job);
Result<MarkerRecording> parseTrc(std::string_view text, const std::string& where, const JobContext& job);

/// Whether the name ends in .c3d or .trc.
bool isMarkerFile(const std::string& path);
/// By the name's ending.
Result<MarkerRecording> readMarkers(const std::string& path, const JobContext& job);

/// Joints as means of markers: {"LeftUpLeg": ["LASI", "LPSI"], ...}; an empty object takes markers that carry
/// joints' names. `up` is "X", "Y" or "Z", empty: as the file says. Rows in which a joint is not seen are
/// left out and said. kUsage names a marker that is missing.
Result<PositionTable> jointsOfMarkers(const MarkerRecording& markers, const nlohmann::json& joints,
                                      const std::string& up, const std::string& where);

}  // namespace noctule
