// SPDX-License-Identifier: Apache-2.0
#include "core/import/mat_recording.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/import/formats.h"

namespace noctule {

namespace {

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

/// "hip.gyr" -> {"hip", "gyr"}; "imu_gyr" -> {"imu", "gyr"}; "gyr" -> {"", "gyr"}.
struct ArrayName {
    std::string sensor;
    std::string quantity;  ///< gyr, acc, mag or empty
};

ArrayName splitName(const std::string& name) {
    const std::string lower = lowerCase(name);
    const size_t member = lower.rfind('.');
    const size_t from = member == std::string::npos ? 0 : member + 1;
    for (const char* quantity : {"gyr", "acc", "mag"}) {
        const size_t at = lower.find(quantity, from);
        if (at == std::string::npos)
            continue;
        std::string sensor = name.substr(0, at);
        while (!sensor.empty() && (sensor.back() == '.' || sensor.back() == '_'))
            sensor.pop_back();
        return {sensor, quantity};
    }
    return {};
}

using Quantities = std::map<std::string, const Eigen::MatrixXd*>;

std::map<std::string, Quantities> sensorsIn(const MatArrays& arrays) {
    std::map<std::string, Quantities> found;
    for (const auto& [name, array] : arrays) {
        const ArrayName parts = splitName(name);
        if (!parts.quantity.empty() && array.cols() == 3)
            found[parts.sensor][parts.quantity] = &array;
    }
    std::erase_if(
        found, [](const auto& sensor) { return !sensor.second.count("gyr") || !sensor.second.count("acc"); });
    return found;
}

/// By its whole name, else by that of a struct's member: "sampling_rate", "data.sampling_rate".
const Eigen::MatrixXd* arrayOf(const MatArrays& arrays, std::initializer_list<const char*> names) {
    for (const bool as_member : {false, true})
        for (const char* name : names)
            for (const auto& [key, array] : arrays) {
                const size_t member = as_member ? key.rfind('.') + 1 : 0;  // npos + 1 is 0
                if (lowerCase(key.substr(member)) == name && array.size() > 0)
                    return &array;
            }
    return nullptr;
}

std::vector<Vector3d> rowsOf(const Eigen::MatrixXd& array) {
    std::vector<Vector3d> rows(static_cast<size_t>(array.rows()));
    for (Eigen::Index i = 0; i < array.rows(); ++i)
        rows[size_t(i)] = array.row(i).transpose();
    return rows;
}

struct Timing {
    double rate_hz = 0, start_s = 0;
};

std::optional<Timing> timingOf(const MatArrays& arrays, double rate_hz) {
    Timing timing{rate_hz, 0};
    if (const auto* t = arrayOf(arrays, {"t", "time", "time_s", "timestamp"}); t && t->size() > 1) {
        timing.start_s = (*t)(0);
        std::vector<double> steps;
        for (Eigen::Index i = 1; i < t->size(); ++i)
            steps.push_back((*t)(i) - (*t)(i - 1));
        std::nth_element(steps.begin(), steps.begin() + long(steps.size() / 2), steps.end());
        if (!(timing.rate_hz > 0) && steps[steps.size() / 2] > 0)
            timing.rate_hz = 1 / steps[steps.size() / 2];
    }
    if (const auto* rate = arrayOf(arrays, {"sampling_rate", "fs", "rate", "rate_hz"});
        rate && !(rate_hz > 0))
        timing.rate_hz = (*rate)(0);
    if (!(timing.rate_hz >= 1 && timing.rate_hz <= 10'000))
        return std::nullopt;
    return timing;
}

void takeReference(const MatArrays& arrays, Eigen::Index rows, ImportedRecording& recording) {
    const auto* quaternions = arrayOf(arrays, {"opt_quat"});
    if (!quaternions || quaternions->cols() != 4 || quaternions->rows() != rows)
        return;
    const Quaterniond turn = worldFromFile(WorldFrame::kEastNorthUp);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const auto q = quaternions->row(i);
        recording.q_world_sensor.push_back(turn * Quaterniond(q(0), q(1), q(2), q(3)));
    }
    const auto* places = arrayOf(arrays, {"opt_pos"});
    const bool has_places = places && places->cols() == 3 && places->rows() == rows;
    for (Eigen::Index i = 0; i < rows; ++i)
        recording.p_world_sensor_m.push_back(has_places ? Vector3d(turn * places->row(i).transpose())
                                                        : Vector3d::Zero());
    if (const auto* moves = arrayOf(arrays, {"movement"}); moves && moves->size() == rows)
        for (Eigen::Index i = 0; i < rows; ++i)
            recording.moves.push_back((*moves)(i) != 0);
}

}  // namespace

Result<ImportedRecording> recordingFromMat(const MatArrays& arrays, const std::string& name, double rate_hz) {
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
        return Error{ErrorKind::kUnreadable, name + ": " + what, remedy};
    };
    const auto sensors = sensorsIn(arrays);
    if (sensors.empty()) {
        std::string held;
        for (const auto& [key, array] : arrays)
            if (held.size() < 200)
                held += (held.empty() ? "" : ", ") + key;
        return refuse("no sensor was found; the file holds " + (held.empty() ? "no numeric arrays" : held),
                      "Name the N x 3 arrays of each sensor so that they end in gyr, acc and mag");
    }
    const auto timing = timingOf(arrays, rate_hz);
    if (!timing)
        return refuse("the file states no usable sampling rate", "Give it, 1 to 10000 Hz (--rate HZ)");
    ImportedRecording recording;
    recording.name = name;
    recording.start_s = timing->start_s;
    for (const auto& [id, quantities] : sensors) {
        ImportedSensor sensor{id.empty() ? "sensor" : id, {}};
        sensor.samples.rate_hz = timing->rate_hz;
        const Eigen::Index rows = quantities.at("gyr")->rows();
        for (const auto& [quantity, array] : quantities)
            if (array->rows() != rows)
                return refuse("sensor " + sensor.id + " has " + std::to_string(rows) + " rows of gyr and " +
                                  std::to_string(array->rows()) + " of " + quantity,
                              "Export the recording again, so that all arrays of a sensor have one length");
        sensor.samples.gyro_rad_per_s = rowsOf(*quantities.at("gyr"));
        sensor.samples.accel_m_per_s2 = rowsOf(*quantities.at("acc"));
        if (quantities.count("mag"))
            sensor.samples.mag = rowsOf(*quantities.at("mag"));
        recording.sensors.push_back(std::move(sensor));
    }
    if (recording.sensors.size() == 1)
        takeReference(arrays, Eigen::Index(recording.sensors[0].samples.size()), recording);
    return recording;
}

namespace {

bool knowsMat(const ImportFile& file) {
    return file.head().starts_with("MATLAB") || file.extension() == ".mat";
}

Result<ImportedRecording> readMat(const std::vector<ImportFile>& files, const ImportChoice& choice,
                                  const JobContext&) {
    const auto arrays = parseMat(files.front().bytes, files.front().path);
    if (!arrays)
        return arrays.error();
    return recordingFromMat(*arrays, files.front().stem(), choice.rate_hz);
}

}  // namespace

const ImportFormat& matFormat() {
    static const ImportFormat format = {"mat", "MATLAB files of level 5 (BROAD, qmt)", false, knowsMat,
                                        readMat};
    return format;
}

}  // namespace noctule
