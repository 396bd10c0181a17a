// SPDX-License-Identifier: Apache-2.0
// x-IMU3 recordings: a folder of CSV tables per device, or the device's byte stream (.ximu3). Source: x-io
// Technologies, x-IMU3-Software and x-IMU3-CSV.
#include "core/import/ximu3.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/formats/csv_cells.h"
#include "core/formats/text_file.h"
#include "core/import/column_text.h"
#include "core/import/formats.h"
#include "core/import/segment_names.h"
#include "core/import/sensor_rows.h"

namespace noctule {

namespace {

constexpr double kCommonClock = 0.8;  ///< share of the longest recording that all devices have in common

bool isInertialTable(const ImportFile& file) {
    return file.head().starts_with("Timestamp (us),Gyroscope X");
}

/// Older firmware sends it behind a quaternion.
bool holdsAcceleration(const ImportFile& file) {
    return file.fileName() == "LinearAcceleration.csv" || file.fileName() == "EarthAcceleration.csv";
}

/// Those of a device's tables that are read.
bool isTable(const ImportFile& file) {
    const std::string name = file.fileName();
    return name == "Magnetometer.csv" || name == "Quaternion.csv" || name == "RotationMatrix.csv" ||
           name == "EulerAngles.csv" || holdsAcceleration(file) || isInertialTable(file);
}

/// The answers of a device to commands, beside its tables.
bool isCommands(const ImportFile& file) {
    return file.fileName() == "Command.json" && file.head().find("\"ping\"") != std::string_view::npos;
}

bool knowsXimu3(const ImportFile& file) {
    return file.extension() == ".ximu3" || isCommands(file) ||
           (isTable(file) && file.head().starts_with("Timestamp (us),"));
}

/// Of the device's tables or of its Command.json.
std::string deviceFolder(const ImportFile& file) {
    const std::string folder = file.folderName();
    return folder.empty() ? file.stem() : folder;
}

Result<Ximu3Table> tableOf(const ImportFile& file, size_t values, const std::vector<const char*>& units,
                           const JobContext& job, bool& cut) {
    std::string_view text = withoutByteOrderMark(file.bytes);
    ColumnRequest request;
    const std::string_view header = cutLine(text);
    request.names = cellsOfLine(header, ',');
    const Error strange{ErrorKind::kUnreadable,
                        file.path + ": its columns are " + std::string(header.substr(0, 120)),
                        "Export the recording again with the x-IMU3 GUI or x-IMU3 CSV"};
    if (request.names.size() < values + 1 || request.names[0] != "Timestamp (us)")
        return strange;
    for (size_t i = 0; i < units.size(); ++i)
        if (request.names[1 + i].find(units[i]) == std::string::npos)
            return strange;
    for (size_t i = 0; i <= values; ++i)
        request.wanted.push_back(i);
    auto columns = columnsOfText(text, request, file.path, job);
    if (!columns)
        return columns.error();
    cut |= columns->cut;
    Ximu3Table table;
    for (size_t row = 0; row < columns->rows; ++row) {
        table.time_s.push_back(1e-6 * columns->columns[0][row]);
        for (size_t i = 1; i <= values; ++i)
            table.values.push_back(columns->columns[i][row]);
    }
    return table;
}

/// Of Euler angles, or of accelerations behind a quaternion.
Status addOtherAttitudes(const ImportFile& file, Ximu3Device& device, const JobContext& job) {
    const bool are_angles = !holdsAcceleration(file);
    std::string_view text = withoutByteOrderMark(file.bytes);
    constexpr size_t kWithQuaternion = 8;
    if (device.other_attitude.rows() > 0 ||
        (!are_angles && cellsOfLine(cutLine(text), ',').size() < kWithQuaternion))
        return Done{};
    const size_t width = are_angles ? 3 : 4;
    const auto table = tableOf(file, width, {}, job, device.cut);
    if (!table)
        return table.error();
    for (size_t row = 0; row < table->rows(); ++row)
        addOtherAttitude(device.other_attitude, table->time_s[row], table->row(row, width), are_angles);
    return Done{};
}

/// Adds one CSV table to the device of its folder.
Status addTable(const ImportFile& file, Ximu3Device& device, const JobContext& job) {
    const std::string name = file.fileName();
    Ximu3Table* into = nullptr;
    size_t values = 0;
    std::vector<const char*> units;
    if (isInertialTable(file)) {
        into = &device.inertial;
        values = 6;
        units = {"(deg/s)", "(deg/s)", "(deg/s)", "(g)", "(g)", "(g)"};
    } else if (name == "Magnetometer.csv") {
        into = &device.magnetometer;
        values = 3;
    } else if (name == "Quaternion.csv") {
        into = &device.quaternion;
        values = 4;
    } else if (name == "RotationMatrix.csv") {
        into = &device.matrix;
        values = 9;
    } else {
        return addOtherAttitudes(file, device, job);
    }
    auto table = tableOf(file, values, units, job, device.cut);
    if (!table)
        return table.error();
    *into = std::move(*table);
    return Done{};
}

/// Row of `table` nearest to an instant within half a step of the grid; kNoRow without.
class NearestRow {
public:
    NearestRow(const Ximu3Table& table, double reach_s) : table_(table), reach_s_(reach_s) {}

    size_t at(double time_s) {
        while (next_ + 1 < table_.rows() &&
               std::abs(table_.time_s[next_ + 1] - time_s) <= std::abs(table_.time_s[next_] - time_s))
            ++next_;
        return next_ < table_.rows() && std::abs(table_.time_s[next_] - time_s) <= reach_s_ ? next_
                                                                                            : RowGrid::kNoRow;
    }

private:
    const Ximu3Table& table_;
    double reach_s_;
    size_t next_ = 0;
};

Quaterniond rotationOfRow(const double* R) {
    Matrix3d matrix;
    matrix << R[0], R[1], R[2], R[3], R[4], R[5], R[6], R[7], R[8];
    const bool turns = (matrix * matrix.transpose() - Matrix3d::Identity()).norm() < 0.05;
    return turns && matrix.determinant() > 0 ? Quaterniond(matrix) : missingRotation();
}

SensorRows rowsOfDevice(const Ximu3Device& device, const Quaterniond& turn, double rate_hz) {
    SensorRows rows;
    const bool has_R = device.matrix.rows() > 0;
    const Ximu3Table& quaternion =
        device.quaternion.rows() > 0 || has_R ? device.quaternion : device.other_attitude;
    const bool has_q = quaternion.rows() > 0;
    NearestRow mags(device.magnetometer, 0.5 / rate_hz), quaternions(quaternion, 0.5 / rate_hz),
        matrices(device.matrix, 0.5 / rate_hz);
    for (size_t i = 0; i < device.inertial.rows(); ++i) {
        const double* v = device.inertial.row(i, 6);
        const double time_s = device.inertial.time_s[i];
        rows.gyro_rad_per_s.push_back(radians(1) * Vector3d(v[0], v[1], v[2]));
        rows.accel_m_per_s2.push_back(kStandardGravity_m_per_s2 * Vector3d(v[3], v[4], v[5]));
        if (device.magnetometer.rows() > 0) {
            const size_t m = mags.at(time_s);
            const double* field = m == RowGrid::kNoRow ? nullptr : device.magnetometer.row(m, 3);
            rows.mag.push_back(field ? Vector3d(field[0], field[1], field[2]) : missingVector());
        }
        if (!has_q && !has_R)
            continue;
        const size_t r = has_q ? quaternions.at(time_s) : matrices.at(time_s);
        Quaterniond q = missingRotation();
        if (r != RowGrid::kNoRow && has_q) {
            const double* w = quaternion.row(r, 4);
            q = checkedRotation(Quaterniond(w[0], w[1], w[2], w[3]));
        } else if (r != RowGrid::kNoRow) {
            q = rotationOfRow(device.matrix.row(r, 9));
        }
        rows.q_world_sensor.push_back(turn * q);
    }
    return rows;
}

/// Devices that synchronise over the network count alike; others begin whenever they were switched on.
void alignClocks(const std::vector<double>& starts, ImportedRecording& recording) {
    double first = starts[0], last = starts[0], end = std::numeric_limits<double>::infinity(), longest = 0;
    for (size_t s = 0; s < starts.size(); ++s) {
        const ImuSamples& samples = recording.sensors[s].samples;
        const double duration = double(samples.size()) / samples.rate_hz;
        first = std::min(first, starts[s]);
        last = std::max(last, starts[s]);
        end = std::min(end, starts[s] + duration);
        longest = std::max(longest, duration);
    }
    recording.start_s = first;
    if (starts.size() == 1)
        return;
    if (end - last >= kCommonClock * longest) {
        for (size_t s = 0; s < starts.size(); ++s)
            recording.sensors[s].offset_s = starts[s] - first;
        recording.notes.push_back(
            "The devices' clocks run together and were taken as one, as network "
            "synchronisation makes them");
    } else {
        recording.warnings.push_back(
            "The devices' clocks do not run together; all were taken to begin at the "
            "same instant. Switch on synchronisation before recording");
    }
}

using Ximu3Devices = std::map<std::string, Ximu3Device>;

/// Of the same folder; without such a one of the only device there is, as of files named one by one.
void addCommands(const std::vector<ImportFile>& files, Ximu3Devices& devices,
                 std::vector<std::string>& warnings) {
    for (const ImportFile& file : files) {
        if (!isCommands(file))
            continue;
        auto device = devices.find(deviceFolder(file));
        if (device == devices.end() && devices.size() == 1)
            device = devices.begin();
        if (device == devices.end())
            warnings.push_back(file.path + ": belongs to no device and was left out");
        else
            addXimu3Commands(file.bytes, device->second.settings);
    }
}

Result<Ximu3Devices> devicesIn(const std::vector<ImportFile>& files, std::vector<std::string>& warnings,
                               const JobContext& job) {
    Ximu3Devices devices;
    for (const ImportFile& file : files) {
        if (file.extension() == ".ximu3") {
            auto device = parseXimu3(file.bytes, job);
            if (!device)
                return device.error();
            devices[file.stem()] = std::move(*device);
        } else if (isTable(file)) {
            if (Status added = addTable(file, devices[deviceFolder(file)], job); !added)
                return added.error();
        }
    }
    addCommands(files, devices, warnings);
    return devices;
}

WorldFrame worldOf(const Ximu3Device& device, const ImportChoice& choice) {
    return choice.world.value_or(device.settings.world.value_or(WorldFrame::kNorthWestUp));
}

void sayWhatIsStated(const std::string& id, const Ximu3Device& device, const ImportChoice& choice,
                     ImportedRecording& recording) {
    const std::vector<std::string> notes = ximu3Notes(id, device.settings);
    recording.notes.insert(recording.notes.end(), notes.begin(), notes.end());
    if (device.settings.is_damaged)
        recording.warnings.push_back(id + ": what it states of itself cannot be read and was left out");
    if (device.quaternion.rows() + device.matrix.rows() + device.other_attitude.rows() == 0 || choice.world)
        return;
    if (device.settings.world)
        recording.notes.push_back(id + " states that its attitudes are in " +
                                  worldFrameText(*device.settings.world) + ", and so they were taken");
    else
        recording.warnings.push_back(id +
                                     ": does not say which axes its attitudes have; NWU was taken, its "
                                     "factory setting (--world replaces it)");
}

Result<ImportedRecording> readXimu3(const std::vector<ImportFile>& files, const ImportChoice& choice,
                                    const JobContext& job) {
    ImportedRecording recording;
    const auto devices = devicesIn(files, recording.warnings, job);
    if (!devices)
        return devices.error();
    const auto first = std::ranges::find_if_not(files, isCommands);
    recording.name = (first == files.end() ? files.front() : *first).stem();
    std::vector<double> starts;
    for (const auto& [id, device] : *devices) {
        if (device.inertial.rows() == 0)
            return Error{ErrorKind::kUnreadable,
                         files.front().path + ": device " + id + " has no inertial messages",
                         "Record with inertial messages switched on"};
        auto grid = gridOfTimes(device.inertial.time_s, id);
        if (!grid)
            return grid.error();
        if (choice.rate_hz > 0)
            grid->rate_hz = choice.rate_hz;
        recording.sensors.push_back(sensorOnGrid(
            id, rowsOfDevice(device, worldFromFile(worldOf(device, choice)), grid->rate_hz), *grid));
        ImportedSensor& sensor = recording.sensors.back();
        if (!segmentByName(id))
            sensor.segment = segmentByName(device.settings.name).value_or("");
        starts.push_back(grid->start_s);
        for (const std::string& finding : grid->findings(id))
            recording.warnings.push_back(finding);
        if (device.damaged > 0)
            recording.warnings.push_back(id + ": " + std::to_string(device.damaged) +
                                         " messages are damaged and were left out");
        if (device.cut)
            recording.warnings.push_back(id +
                                         ": the recording was cut in the middle of a message or line, "
                                         "which was left out");
        sayWhatIsStated(id, device, choice, recording);
    }
    if (recording.sensors.empty())
        return Error{ErrorKind::kUnreadable, files.front().path + ": no device has inertial messages",
                     "Give the folder that holds Inertial.csv, or the .ximu3 file"};
    alignClocks(starts, recording);
    recording.notes.push_back(
        "Gyroscopes are deg/s and accelerometers g in x-IMU3's messages; they were "
        "converted to rad/s and m/s^2");
    return recording;
}

}  // namespace

const ImportFormat& ximu3Format() {
    static const ImportFormat format = {"ximu3", "x-IMU3: folders of CSV tables, or .ximu3", true, knowsXimu3,
                                        readXimu3};
    return format;
}

}  // namespace noctule
