// SPDX-License-Identifier: Apache-2.0
// OpenSense's attitudes: a .sto table of quaternions, sensor to ground. The file does not say what ground is.
#include <cmath>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/opensim.h"
#include "core/formats/text_file.h"
#include "core/import/formats.h"
#include "core/import/sensor_rows.h"

namespace noctule {

namespace {

bool knowsSto(const ImportFile& file) {
    return file.head().find("endheader") != std::string_view::npos &&
           file.head().find("DataType=Quaternion") != std::string_view::npos;
}

/// LF ends, no blanks around the lines, no empty lines at the end: what parseOpenSimTable reads.
std::string plainLines(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    while (!text.empty()) {
        plain += trimmed(cutLine(text));
        plain += '\n';
    }
    while (plain.ends_with("\n\n"))
        plain.pop_back();
    return plain;
}

Error stoError(const ImportFile& file, const std::string& what) {
    return {ErrorKind::kUnreadable, file.path + ": " + what, "Write the table with OpenSense again"};
}

double statedRate(const OpenSimTable& table) {
    for (const std::string& line : table.header)
        if (line.starts_with("DataRate="))
            if (double rate = 0; parseNumber(line.data() + 9, line.data() + line.size(), rate))
                return rate;
    return 0;
}

SensorRows rowsOfColumn(const OpenSimTable& table, size_t column, const Quaterniond& turn) {
    SensorRows rows;
    for (size_t row = 0; row < table.rows(); ++row) {
        const double* q = table.values.data() + row * table.width + 1 + 4 * column;
        rows.q_world_sensor.push_back(turn * checkedRotation(Quaterniond(q[0], q[1], q[2], q[3])));
    }
    return rows;
}

Result<ImportedRecording> readSto(const std::vector<ImportFile>& files, const ImportChoice& choice,
                                  const JobContext&) {
    const ImportFile& file = files.front();
    const auto table =
        parseOpenSimTable(plainLines(withoutByteOrderMark(file.bytes)), file.path, MissingCells::kNan);
    if (!table)
        return table.error();
    const size_t sensors = table->columns.size() - 1;
    if (sensors == 0 || table->width != 1 + 4 * sensors)
        return stoError(file, "has " + std::to_string(table->width) + " numbers in a row for " +
                                  std::to_string(sensors) + " quaternions");
    if (table->rows() < 2)
        return Error{ErrorKind::kUnusable,
                     file.path + ": holds one row, a pose to calibrate with and no recording",
                     "Import the trial's table instead"};
    std::vector<double> time_s;
    for (size_t row = 0; row < table->rows(); ++row)
        time_s.push_back(table->values[row * table->width]);
    auto grid = gridOfTimes(time_s, file.path);
    if (!grid)
        return grid.error();
    ImportedRecording recording;
    recording.name = file.stem();
    recording.start_s = grid->start_s;
    if (const double rate = statedRate(*table); rate > 0 && std::abs(rate / grid->rate_hz - 1) > 0.01)
        recording.warnings.push_back("The header states " + std::to_string(rate) +
                                     " rows a second, the times show " + std::to_string(grid->rate_hz) +
                                     "; the times were believed");
    if (choice.rate_hz > 0)
        grid->rate_hz = choice.rate_hz;
    const WorldFrame world = choice.world.value_or(WorldFrame::kEastNorthUp);
    if (!choice.world)
        recording.warnings.push_back(
            "The table does not say what its ground is; ENU was assumed, as MT "
            "Manager's data have it (--world opensim for tables in OpenSim's axes)");
    for (size_t s = 0; s < sensors; ++s)
        recording.sensors.push_back(
            sensorOnGrid(table->columns[s + 1], rowsOfColumn(*table, s, worldFromFile(world)), *grid));
    for (const std::string& finding : grid->findings(file.path))
        recording.warnings.push_back(finding);
    recording.notes = {"The table holds attitudes only: no rates, accelerations or field",
                       "Attitudes take the sensor's frame to " + worldFrameText(world)};
    return recording;
}

}  // namespace

const ImportFormat& stoFormat() {
    static const ImportFormat format = {"sto", "OpenSense's table of quaternions", false, knowsSto, readSto};
    return format;
}

}  // namespace noctule
