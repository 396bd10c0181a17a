// SPDX-License-Identifier: Apache-2.0
#include "core/processing/points_table.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>

#include "core/formats/csv_cells.h"
#include "core/job/atomic_file.h"
#include "core/job/limits.h"

namespace noctule {
namespace {

constexpr const char* kHeader = "time_s,subject,suit,device,x_m,y_m,z_m,sigma_m";
constexpr size_t kColumns = 8;
constexpr size_t kMostBytes = size_t{2} << 30;  ///< five hours of two people

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r;") == std::string::npos)
        return text;
    std::string cell = "\"";
    for (const char letter : text)
        cell += letter == '"' ? "\"\"" : letter == '\n' || letter == '\r' ? " " : std::string(1, letter);
    return cell + "\"";
}

std::optional<double> finiteNumber(const std::string& cell) {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool whole = error == std::errc() && end == cell.data() + cell.size() && !cell.empty();
    return whole && std::isfinite(value) && std::abs(value) <= limits::kFarthest_m * 10 ? std::optional(value)
                                                                                        : std::nullopt;
}

Error badTable(const std::string& path, size_t line, const std::string& what) {
    return {ErrorKind::kUnreadable, path + ": line " + std::to_string(line) + ": " + what,
            "Choose a table that process --estimator comocap --points wrote"};
}

}  // namespace

PointsTableWriter::PointsTableWriter() : text_(std::string(kHeader) + "\n") {}

PointsSink PointsTableWriter::sink() {
    return {[this](const std::vector<TakePoint>& points) {
                for (const TakePoint& point : points)
                    names_.push_back(quoted(point.subject) + "," + std::to_string(point.suit) + "," +
                                     quoted(point.device));
            },
            [this](const PointsFrame& frame) {
                for (size_t i = 0; i < frame.p_m.size(); ++i) {
                    const Vector3d& p = frame.p_m[i];
                    char time[32], place[128];
                    std::snprintf(time, sizeof time, "%.6f,", frame.time_s);
                    std::snprintf(place, sizeof place, ",%.5f,%.5f,%.5f,%.5f\n", p.x(), p.y(), p.z(),
                                  frame.sigma_m[i]);
                    text_ += time + names_[i] + place;
                }
            }};
}

Result<PointsTable> readPointsTable(const std::string& path) {
    const auto text = readWholeFile(path, {.most_bytes = kMostBytes, .most_stream_bytes = kMostBytes});
    if (!text)
        return text.error();
    std::istringstream lines(*text);
    std::string line;
    std::getline(lines, line);
    if (line.ends_with('\r'))
        line.pop_back();
    if (line != kHeader)
        return badTable(path, 1, std::string("the columns are not ") + kHeader);
    PointsTable table;
    for (size_t number = 2; std::getline(lines, line); ++number) {
        const CsvCells row = csvCells(line, ',');
        if (row.cells.size() == 1 && row.cells[0].empty())
            continue;
        if (row.cells.size() != kColumns)
            return badTable(path, number, "it has " + std::to_string(row.cells.size()) + " cells, not 8");
        std::array<double, kColumns> values{};
        for (const size_t column : {0U, 2U, 4U, 5U, 6U, 7U}) {
            const auto value = finiteNumber(row.cells[column]);
            if (!value)
                return badTable(path, number, "'" + row.cells[column] + "' is no number in range");
            values[column] = *value;
        }
        PointTrack& track = table[{static_cast<int>(values[2]), row.cells[3]}];
        if (!track.time_s.empty() && values[0] <= track.time_s.back())
            return badTable(path, number, "its time does not increase");
        track.time_s.push_back(values[0]);
        track.p_m.emplace_back(values[4], values[5], values[6]);
        track.sigma_m.push_back(values[7]);
    }
    if (table.empty())
        return badTable(path, 2, "there is no row");
    return table;
}

}  // namespace noctule
