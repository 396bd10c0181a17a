// SPDX-License-Identifier: Apache-2.0
// Tables of any program, read as a map says: which columns are which quantity of which sensor, in which unit
// and along which axes. README.md describes the map.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/body/actor.h"
#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/text_file.h"
#include "core/import/column_text.h"
#include "core/import/formats.h"
#include "core/import/sensor_rows.h"
#include "core/import/table_columns.h"
#include "core/math/json.h"

namespace noctule {

namespace {

using json::Json;

bool knowsCsv(const ImportFile& file) {
    const std::string extension = file.extension();
    return extension == ".csv" || extension == ".txt" || extension == ".tsv";
}

Error mapError(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUsage, "The map: " + what, remedy};
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        if (list.size() < 400)
            list += (list.empty() ? "" : ", ") + name;
    return list;
}

/// Reads a map against a table's columns.
class ColumnMap {
public:
    ColumnMap(const Json& map, const TableHead& head) : map_(map), head_(head) {}

    /// Index in `wanted` of a column that the map names or counts from 1.
    Result<size_t> column(const Json& entry, const std::string& what) {
        size_t index = head_.names.size();
        if (entry.is_string()) {
            const auto found = std::find(head_.names.begin(), head_.names.end(), entry.get<std::string>());
            index = size_t(found - head_.names.begin());
        } else if (entry.is_number_unsigned() && entry.get<uint64_t>() >= 1 &&
                   entry.get<uint64_t>() <= head_.names.size()) {
            index = entry.get<size_t>() - 1;
        }
        if (index >= head_.names.size())
            return mapError(what + " names column " + entry.dump().substr(0, 60) + ", which the table lacks",
                            "Its columns are: " + listOf(head_.names));
        wanted_.push_back(index);
        return wanted_.size() - 1;
    }

    Result<std::vector<size_t>> columns(const Json& sensor, const char* member, size_t count) {
        std::vector<size_t> found;
        if (!sensor.contains(member))
            return found;
        const Json& list = sensor[member];
        if (!list.is_array() || list.size() != count)
            return mapError(std::string(member) + " is no list of " + std::to_string(count) + " columns",
                            "Write it as [\"name\", ...]");
        for (const Json& entry : list) {
            const auto index = column(entry, member);
            if (!index)
                return index.error();
            found.push_back(*index);
        }
        return found;
    }

    Result<double> unit(const Json& object, const char* member, TableQuantity quantity) {
        const auto named = json::text(object, member);
        std::string known;
        for (const TableUnit& one : unitsOf(quantity)) {
            if (named && *named == one.name)
                return one.scale;
            known += (known.empty() ? "" : ", ") + std::string(one.name);
        }
        return mapError(std::string(member) + (named ? " is " + inQuotes(*named) : " is missing"),
                        "Known units: " + known);
    }

    const Json& map() const { return map_; }
    const std::vector<size_t>& wanted() const { return wanted_; }

private:
    const Json& map_;
    const TableHead& head_;
    std::vector<size_t> wanted_;
};

/// What the map says of one sensor.
struct MappedSensor {
    std::string id, segment;
    std::vector<size_t> gyro, accel, mag, quaternion;
    double gyro_scale = 1, accel_scale = 1, mag_scale = 1;
    Matrix3d R_sensor_file = Matrix3d::Identity();
};

/// ["x","-z","y"]: the sensor's axes as axes of the file.
Result<Matrix3d> axesOf(const Json& sensor) {
    Matrix3d R = Matrix3d::Zero();
    if (!sensor.contains("axes"))
        return Matrix3d(Matrix3d::Identity());
    const Json& axes = sensor["axes"];
    for (size_t row = 0; row < 3 && axes.is_array() && axes.size() == 3; ++row) {
        const std::string text = axes[row].is_string() ? axes[row].get<std::string>() : "";
        const bool minus = text.starts_with("-");
        const std::string_view axis = std::string_view(text).substr(minus ? 1 : 0);
        if (axis == "x" || axis == "y" || axis == "z")
            R(Eigen::Index(row), axis[0] - 'x') = minus ? -1 : 1;
    }
    if (std::abs(R.determinant() - 1) > 1e-9)
        return mapError("axes " + sensor["axes"].dump().substr(0, 60) + " are no turn",
                        "Write three different axes that keep right-handed: [\"y\", \"-x\", \"z\"]");
    return R;
}

Result<MappedSensor> mappedSensor(const Json& entry, ColumnMap& map) {
    MappedSensor sensor;
    sensor.id = json::text(entry, "id").value_or("");
    sensor.segment = json::text(entry, "segment").value_or("");
    if (sensor.id.empty() || sensor.id.size() > 200)
        return mapError("a sensor has no id", "Give each sensor an id");
    const auto& segments = canonicalJointNames();
    if (!sensor.segment.empty() &&
        std::find(segments.begin(), segments.end(), sensor.segment) == segments.end())
        return mapError("sensor " + sensor.id + " is put on " + inQuotes(sensor.segment.substr(0, 60)) +
                            ", which no body has",
                        "Segments are: " + listOf(segments));
    for (const auto& [member, into, count] :
         {std::tuple{"gyro", &sensor.gyro, 3}, std::tuple{"accel", &sensor.accel, 3},
          std::tuple{"mag", &sensor.mag, 3}, std::tuple{"quaternion", &sensor.quaternion, 4}}) {
        auto columns = map.columns(entry, member, size_t(count));
        if (!columns)
            return columns.error();
        *into = std::move(*columns);
    }
    const auto take = [&](const std::vector<size_t>& columns, const Result<double>& scale,
                          double& into) -> Status {
        if (columns.empty())
            return Done{};
        if (!scale)
            return scale.error();
        into = *scale;
        return Done{};
    };
    for (const Status& status :
         {take(sensor.gyro, map.unit(entry, "gyro_unit", TableQuantity::kGyro), sensor.gyro_scale),
          take(sensor.accel, map.unit(entry, "accel_unit", TableQuantity::kAccel), sensor.accel_scale),
          take(sensor.mag, map.unit(entry, "mag_unit", TableQuantity::kMag), sensor.mag_scale)})
        if (!status)
            return status.error();
    if (sensor.gyro.empty() && sensor.accel.empty() && sensor.quaternion.empty())
        return mapError("sensor " + sensor.id + " has neither gyro, accel nor quaternion",
                        "Name at least one of them");
    const auto axes = axesOf(entry);
    if (!axes)
        return axes.error();
    sensor.R_sensor_file = *axes;
    return sensor;
}

/// Axis by axis: a product would spread one that is missing over all of them.
Vector3d alongAxes(const Matrix3d& R_sensor_file, const Vector3d& vector) {
    Vector3d turned;
    for (Eigen::Index row = 0; row < 3; ++row) {
        Eigen::Index axis = 0;
        R_sensor_file.row(row).cwiseAbs().maxCoeff(&axis);
        turned[row] = R_sensor_file(row, axis) * vector[axis];
    }
    return turned;
}

SensorRows mappedRows(const MappedSensor& sensor, const NumberColumns& table, const Quaterniond& turn) {
    SensorRows rows;
    const auto vectors = [&](const std::vector<size_t>& c, double scale) {
        std::vector<Vector3d> found;
        if (!c.empty())
            found = vectorsOf(table.columns[c[0]], table.columns[c[1]], table.columns[c[2]], scale);
        for (Vector3d& vector : found)
            vector = alongAxes(sensor.R_sensor_file, vector);
        return found;
    };
    rows.gyro_rad_per_s = vectors(sensor.gyro, sensor.gyro_scale);
    rows.accel_m_per_s2 = vectors(sensor.accel, sensor.accel_scale);
    rows.mag = vectors(sensor.mag, sensor.mag_scale);
    const Quaterniond q_file_sensor(Matrix3d(sensor.R_sensor_file.transpose()));
    for (size_t i = 0; i < table.rows && !sensor.quaternion.empty(); ++i) {
        const auto& c = sensor.quaternion;
        const Quaterniond q(table.columns[c[0]][i], table.columns[c[1]][i], table.columns[c[2]][i],
                            table.columns[c[3]][i]);
        rows.q_world_sensor.push_back(turn * checkedRotation(q) * q_file_sensor);
    }
    return rows;
}

Result<RowGrid> mappedGrid(const Json& map, const NumberColumns& table, std::optional<size_t> time,
                           double scale, double rate_hz, const std::string& path) {
    if (time) {
        std::vector<double> time_s = table.columns[*time];
        for (double& t : time_s)
            t *= scale;
        auto grid = gridOfTimes(time_s, path);
        if (grid && rate_hz > 0)
            grid->rate_hz = rate_hz;
        return grid;
    }
    const double stated = rate_hz > 0 ? rate_hz : json::number(map, "rate_hz").value_or(0);
    if (!(stated >= 1 && stated <= 10'000))
        return mapError("it has neither time nor a rate_hz of 1 to 10000",
                        "Write \"time\": {\"column\": \"t\", \"unit\": \"s\"} or \"rate_hz\": 100");
    std::vector<int64_t> counts(table.rows);
    for (size_t i = 0; i < counts.size(); ++i)
        counts[i] = int64_t(i);
    return gridOfCounts(counts, stated, path);
}

Result<std::vector<MappedSensor>> mappedSensors(const Json& map, ColumnMap& reader) {
    std::vector<MappedSensor> sensors;
    const auto list = map.find("sensors");
    if (list == map.end() || !list->is_array() || list->empty() || list->size() > 100)
        return mapError("it has no list of 1 to 100 sensors", "Write \"sensors\": [{\"id\": ...}]");
    for (const Json& entry : *list) {
        auto sensor = mappedSensor(entry, reader);
        if (!sensor)
            return sensor.error();
        sensors.push_back(std::move(*sensor));
    }
    return sensors;
}

/// Times of day do not say on which day they are.
void tellOfDays(const NumberColumns& table, const std::string& path, std::vector<std::string>& warnings) {
    constexpr double kWorthTelling_s = 600, kHour_s = 3600;
    char hours[32];
    if (table.longest_hole_s >= kWorthTelling_s) {
        std::snprintf(hours, sizeof hours, "%.2f", table.longest_hole_s / kHour_s);
        warnings.push_back(path + ": its times of day have no date, so a hole of " + hours +
                           " h is a guess; it may be longer by whole days");
    }
    if (table.longest_return_s >= kWorthTelling_s) {
        std::snprintf(hours, sizeof hours, "%.2f", table.longest_return_s / kHour_s);
        warnings.push_back(path + ": its times of day have no date and jump back by " + hours +
                           " h; the clock was probably set back, but the next day is possible too");
    }
}

Result<ImportedRecording> readMapped(const ImportFile& file, const TableHead& head,
                                     const ImportChoice& choice, const JobContext& job) {
    ColumnMap reader(choice.map, head);
    std::optional<size_t> time;
    double time_scale = 1;
    if (const auto entry = choice.map.find("time"); entry != choice.map.end()) {
        if (!entry->is_object() || !entry->contains("column"))
            return mapError("time names no column", "Write \"time\": {\"column\": \"t\", \"unit\": \"s\"}");
        const auto column = reader.column((*entry)["column"], "time");
        const auto unit = reader.unit(*entry, "unit", TableQuantity::kTime);
        if (!column || !unit)
            return column ? unit.error() : column.error();
        time = *column;
        time_scale = *unit;
    }
    const auto sensors = mappedSensors(choice.map, reader);
    if (!sensors)
        return sensors.error();
    ColumnRequest request{head.separator, head.names, reader.wanted(), head.first_line,
                          head.separator != ','};
    if (time)
        request.time = reader.wanted()[*time];
    const auto table = columnsOfText(head.rows, request, file.path, job);
    if (!table)
        return table.error();
    const auto grid = mappedGrid(choice.map, *table, time, time_scale, choice.rate_hz, file.path);
    if (!grid)
        return grid.error();
    ImportedRecording recording;
    recording.name = file.stem();
    recording.start_s = grid->start_s;
    const auto named = json::text(choice.map, "world");
    const auto world = choice.world ? choice.world : worldFrameNamed(named.value_or("enu"));
    if (!world)
        return mapError("world is " + inQuotes(*named), "Write enu, nwu, ned, opensim or noctule");
    for (const MappedSensor& sensor : *sensors) {
        recording.sensors.push_back(
            sensorOnGrid(sensor.id, mappedRows(sensor, *table, worldFromFile(*world)), *grid));
        recording.sensors.back().segment = sensor.segment;
    }
    recording.warnings = grid->findings(file.path);
    if (table->cut)
        recording.warnings.push_back(file.path + ": the last line has no end and was left out");
    tellOfDays(*table, file.path, recording.warnings);
    recording.notes = {"Columns, units and axes are those of the map"};
    for (const std::string& left_out : columnsLeftOut(head.names, reader.wanted()))
        recording.notes.push_back(left_out);
    return recording;
}

Result<ImportedRecording> readCsv(const std::vector<ImportFile>& files, const ImportChoice& choice,
                                  const JobContext& job) {
    const ImportFile& file = files.front();
    const std::optional<std::string> utf8 = fromUtf16(file.bytes);
    const std::string_view text =
        withoutByteOrderMark(utf8 ? std::string_view(*utf8) : std::string_view(file.bytes));
    const auto head = tableHead(text, file.path);
    if (!head)
        return head.error();
    if (!choice.map.is_object())
        return Error{
            ErrorKind::kUsage,
            file.path + ": a table needs a map of its columns; they are " + listOf(head->names),
            "Give a map of the columns with --map MAP.json; noctule --batch import --help shows one"};
    return readMapped(file, *head, choice, job);
}

}  // namespace

const ImportFormat& csvFormat() {
    static const ImportFormat format = {"csv", "any table of numbers", false, knowsCsv, readCsv};
    return format;
}

}  // namespace noctule
