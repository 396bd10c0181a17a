// SPDX-License-Identifier: Apache-2.0
// Xsens MT Manager's text export: one file per sensor, PREFIX_DEVICEID.txt. Columns are found by name; the
// separator is a tab, comma, semicolon or single blank. Since MT Manager 2019.2 no rate is stated. Movella
// DOT's tables have other units, names and first lines. Sources: opensim-core, XsensDataReader.cpp; exports
// of MT Manager 4 and 2022; Xsens DOT User Manual, section 4.2.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/text_file.h"
#include "core/import/column_text.h"
#include "core/import/formats.h"
#include "core/import/sensor_rows.h"
#include "core/math/euler.h"

namespace noctule {

namespace {

constexpr double kTickOfFineTime_s = 1e-4, kTickOfDot_s = 1e-6;
constexpr int64_t kCounterPeriod = 65536;
/// Of a row without a counter: before all others, and differences from it are still numbers.
constexpr int64_t kNoCount = std::numeric_limits<int64_t>::min() / 4;

/// One file, its columns by name.
struct XsensFile {
    std::string id;
    std::optional<double> stated_rate_hz;
    std::optional<WorldFrame> stated_world;
    std::map<std::string, std::vector<double>> columns;
    std::vector<int64_t> counts;  ///< unwrapped
    bool cut = false;
    bool is_dot = false;  ///< of Movella DOT: rates in deg/s

    double tick_s() const { return is_dot ? kTickOfDot_s : kTickOfFineTime_s; }
    bool has(const std::string& name) const {
        const auto found = columns.find(name);
        return found != columns.end() && std::any_of(found->second.begin(), found->second.end(),
                                                     [](double value) { return std::isfinite(value); });
    }
    const std::vector<double>& at(const std::string& name) const { return columns.at(name); }
    bool hasAll(std::initializer_list<const char*> names) const {
        return std::all_of(names.begin(), names.end(), [&](const char* name) { return has(name); });
    }
};

bool knowsXsensText(const ImportFile& file) {
    return file.head().find("PacketCounter") != std::string_view::npos &&
           file.head().find("<mvnx") == std::string_view::npos;
}

Error xsensError(const std::string& path, const std::string& what) {
    return {ErrorKind::kUnreadable, path + ": " + what,
            "Export the recording as text in MT Manager again, with inertial data and the packet counter"};
}

/// The text behind "// KEY:"; nothing when the line is another one.
std::optional<std::string_view> headerValue(std::string_view line, std::string_view key) {
    const size_t at = line.find(key);
    if (at == std::string_view::npos)
        return std::nullopt;
    return trimmed(line.substr(at + key.size()));
}

/// "60.0Hz"; others are passed over.
void takeRate(std::string_view text, XsensFile& file) {
    double rate = 0;
    if (parseNumber(text.data(), text.data() + text.size(), rate) && rate >= 1 && rate <= 10'000)
        file.stated_rate_hz = rate;
}

void readHeaderLine(std::string_view line, XsensFile& file) {
    if (const auto text = headerValue(line, "Update Rate:"))
        takeRate(*text, file);
    if (const auto text = headerValue(line, "DeviceId:"); text && !text->empty() && text->size() < 64)
        file.id = std::string(*text);
    if (const auto text = headerValue(line, "Coordinate system:"))
        file.stated_world = worldFrameNamed(std::string(text->substr(0, 3)));
}

/// "OutputRate:,60Hz,,,": a key, a comma and what is left of the commas of a table.
void readDotLine(std::string_view line, XsensFile& file) {
    file.is_dot = true;
    const auto value = [&](std::string_view key) {
        std::string_view text = line.substr(0, 0);
        if (const auto found = headerValue(line, key))
            text = *found;
        while (!text.empty() && (text.front() == ',' || text.front() == ' '))
            text.remove_prefix(1);
        return trimmed(text.substr(0, text.find(',')));
    };
    const std::string_view tag = value("DeviceTag:");
    // As delivered all have the same.
    if (!tag.empty() && tag.size() < 64 && tag != "Xsens DOT" && tag != "Movella DOT")
        file.id = std::string(tag);
    takeRate(value("OutputRate:"), file);
}

/// Names of DOT's columns as MT Manager has them; Euler_X is the roll.
std::string columnName(const std::string& name) {
    static const std::map<std::string, std::string> dot = {
        {"Quat_W", "Quat_q0"}, {"Quat_X", "Quat_q1"}, {"Quat_Y", "Quat_q2"}, {"Quat_Z", "Quat_q3"},
        {"Euler_X", "Roll"},   {"Euler_Y", "Pitch"},  {"Euler_Z", "Yaw"}};
    const auto found = dot.find(name);
    return found == dot.end() ? name : found->second;
}

/// PREFIX_DEVICEID -> DEVICEID.
std::string deviceOf(const ImportFile& file) {
    const std::string stem = file.stem();
    const size_t bar = stem.rfind('_');
    return bar == std::string::npos || bar + 1 == stem.size() ? stem : stem.substr(bar + 1);
}

/// The counter has 16 bits and starts again at 0.
std::vector<int64_t> unwrapped(const std::vector<double>& counter) {
    std::vector<int64_t> counts;
    const bool wraps = std::all_of(counter.begin(), counter.end(),
                                   [](double c) { return std::isnan(c) || (c >= 0 && c < kCounterPeriod); });
    int64_t last = 0;
    for (const double c : counter) {
        if (!(std::abs(c) < 1e12)) {
            counts.push_back(kNoCount);
            continue;
        }
        int64_t count = std::llround(c);
        if (wraps && !counts.empty()) {
            int64_t step = (count - last) % kCounterPeriod;
            if (step > kCounterPeriod / 2)
                step -= kCounterPeriod;
            else if (step < -kCounterPeriod / 2)
                step += kCounterPeriod;
            count = last + step;
        }
        last = count;
        counts.push_back(count);
    }
    return counts;
}

/// Takes the lines up to the columns' names off `text`; these are returned. `number` counts lines.
Result<std::string_view> readHead(std::string_view& text, const ImportFile& given, XsensFile& file,
                                  size_t& number) {
    bool may_be_dot = false;
    while (!text.empty()) {
        const std::string_view line = cutLine(text);
        ++number;
        may_be_dot |= line.starts_with("DeviceTag:");
        if (line.starts_with("//"))
            readHeaderLine(line, file);
        else if (line.find("PacketCounter") != std::string_view::npos)
            return line;
        else if (line.starts_with("sep="))  // for spreadsheets: alone it tells nothing of who wrote it
            may_be_dot = true;
        else if (may_be_dot && !trimmed(line).empty())
            readDotLine(line, file);
        else if (!trimmed(line).empty())
            return xsensError(given.path, "line " + std::to_string(number) +
                                              " is neither a // line nor the names of the columns");
    }
    return xsensError(given.path, "there is no line with the columns' names");
}

Result<XsensFile> readXsensFile(const ImportFile& given, const JobContext& job) {
    XsensFile file;
    const std::optional<std::string> utf8 = fromUtf16(given.bytes);
    std::string_view text =
        withoutByteOrderMark(utf8 ? std::string_view(*utf8) : std::string_view(given.bytes));
    size_t number = 0;
    const auto header = readHead(text, given, file, number);
    if (!header)
        return header.error();
    ColumnRequest request;
    request.separator = separatorOf(*header);
    request.names = cellsOfLine(*header, request.separator);
    if (!request.names.empty() && request.names.back().empty())
        request.names.pop_back();
    for (size_t i = 0; i < request.names.size(); ++i)
        if (!request.names[i].empty())
            request.wanted.push_back(i);
    request.first_line = number + 1;
    request.decimal_comma = request.separator != ',';
    auto columns = columnsOfText(text, request, given.path, job);
    if (!columns)
        return columns.error();
    file.cut = columns->cut;
    for (size_t i = 0; i < request.wanted.size(); ++i) {
        const std::string& name = request.names[request.wanted[i]];
        file.is_dot |= columnName(name) != name;
        file.columns[columnName(name)] = std::move(columns->columns[i]);
    }
    if (file.is_dot)
        file.stated_world = WorldFrame::kEastNorthUp;
    if (file.id.empty())
        file.id = file.is_dot ? given.stem() : deviceOf(given);  // DOT's names of files end with a time
    if (!file.has("PacketCounter"))
        return xsensError(given.path, "its packet counter is empty");
    file.counts = unwrapped(file.at("PacketCounter"));
    return file;
}

/// Seconds of each row on a clock that the file brings; empty when it brings none.
std::vector<double> clockOf(const XsensFile& file) {
    std::vector<double> time_s;
    if (file.has("SampleTimeFine")) {
        double turns = 0, last = 0;
        for (const double ticks : file.at("SampleTimeFine")) {
            if (std::isfinite(ticks) && !time_s.empty() && ticks < last - 2147483648.0)
                turns += 4294967296.0;  // 32 bits
            if (std::isfinite(ticks))
                last = ticks;
            time_s.push_back((ticks + turns) * file.tick_s());
        }
    } else if (file.hasAll({"UTC_Hour", "UTC_Minute", "UTC_Second", "UTC_Nano"})) {
        double days = 0, last = 0;
        for (size_t i = 0; i < file.counts.size(); ++i) {
            double s = 3600 * file.at("UTC_Hour")[i] + 60 * file.at("UTC_Minute")[i] +
                       file.at("UTC_Second")[i] + 1e-9 * file.at("UTC_Nano")[i];
            if (std::isfinite(s) && s < last - 43200)
                days += 86400;
            if (std::isfinite(s))
                last = s;
            time_s.push_back(s + days);
        }
    }
    return time_s;
}

/// Rows a second by that clock: its usual step for one count.
std::optional<double> rateByClock(const XsensFile& file) {
    const std::vector<double> time_s = clockOf(file);
    std::vector<double> steps;
    for (size_t i = 1; i < time_s.size(); ++i)
        if (const int64_t counts = file.counts[i] - file.counts[i - 1]; counts > 0 && counts < 1000)
            if (const double step = (time_s[i] - time_s[i - 1]) / double(counts); step > 0)
                steps.push_back(step);
    if (steps.size() < 2)
        return std::nullopt;
    std::nth_element(steps.begin(), steps.begin() + long(steps.size() / 2), steps.end());
    const double rate = 1 / steps[steps.size() / 2];
    return rate >= 1 && rate <= 10'000 ? std::optional(rate) : std::nullopt;
}

Result<double> rateOf(const std::vector<XsensFile>& files, const ImportChoice& choice,
                      ImportedRecording& recording, const std::string& path) {
    if (choice.rate_hz > 0)
        return choice.rate_hz;
    std::optional<double> stated, clocked;
    for (const XsensFile& file : files) {
        if (!stated)
            stated = file.stated_rate_hz;
        if (!clocked)
            clocked = rateByClock(file);
        if (file.stated_rate_hz && stated && std::abs(*file.stated_rate_hz - *stated) > 1e-6)
            return Error{ErrorKind::kUnusable, path + ": its sensors state different rates",
                         "Import the sensors of one recording at a time"};
    }
    if (stated && clocked && std::abs(*clocked / *stated - 1) > 0.01)
        recording.warnings.push_back("The header states " + std::to_string(*stated) +
                                     " rows a second, SampleTimeFine shows " + std::to_string(*clocked) +
                                     "; the header's was taken (--rate HZ replaces it)");
    if (stated || clocked)
        return stated ? *stated : *clocked;
    return Error{ErrorKind::kUnusable,
                 path + ": states no rate and brings no clock, as MT Manager writes since 2019.2",
                 "Give the rate of the recording (--rate HZ)"};
}

std::vector<Quaterniond> attitudesOf(const XsensFile& file, const Quaterniond& turn) {
    std::vector<Quaterniond> q(file.counts.size(), missingRotation());
    const auto fill = [&](auto rotation) {
        for (size_t i = 0; i < q.size(); ++i)
            q[i] = turn * checkedRotation(rotation(i));
        return q;
    };
    if (file.hasAll({"Quat_q0", "Quat_q1", "Quat_q2", "Quat_q3"}))
        return fill([&](size_t i) {
            return Quaterniond(file.at("Quat_q0")[i], file.at("Quat_q1")[i], file.at("Quat_q2")[i],
                               file.at("Quat_q3")[i]);
        });
    if (file.hasAll({"Mat[1][1]", "Mat[1][2]", "Mat[1][3]", "Mat[2][1]", "Mat[2][2]", "Mat[2][3]",
                     "Mat[3][1]", "Mat[3][2]", "Mat[3][3]"}))
        return fill([&](size_t i) {
            Matrix3d R;
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c)
                    R(r, c) = file.at("Mat[" + std::to_string(r + 1) + "][" + std::to_string(c + 1) + "]")[i];
            const bool turns =
                (R * R.transpose() - Matrix3d::Identity()).norm() < 0.05 && R.determinant() > 0;
            return turns ? Quaterniond(R) : missingRotation();
        });
    if (file.hasAll({"Roll", "Pitch", "Yaw"}))
        return fill([&](size_t i) {
            return rotationFromEuler(kEulerZYX, {radians(file.at("Yaw")[i]), radians(file.at("Pitch")[i]),
                                                 radians(file.at("Roll")[i])});
        });
    return {};
}

SensorRows rowsOf(const XsensFile& file, const Quaterniond& turn) {
    SensorRows rows;
    const auto vectors = [&](const char* x, const char* y, const char* z) {
        return file.hasAll({x, y, z}) ? vectorsOf(file.at(x), file.at(y), file.at(z))
                                      : std::vector<Vector3d>();
    };
    rows.gyro_rad_per_s = vectors("Gyr_X", "Gyr_Y", "Gyr_Z");
    if (file.is_dot)
        for (Vector3d& rate : rows.gyro_rad_per_s)
            rate *= radians(1);
    rows.accel_m_per_s2 = vectors("Acc_X", "Acc_Y", "Acc_Z");
    rows.mag = vectors("Mag_X", "Mag_Y", "Mag_Z");
    rows.q_world_sensor = attitudesOf(file, turn);
    return rows;
}

WorldFrame xsensWorld(const std::vector<XsensFile>& files, const ImportChoice& choice,
                      ImportedRecording& recording) {
    const auto stated = std::find_if(files.begin(), files.end(),
                                     [](const XsensFile& file) { return file.stated_world.has_value(); });
    if (!choice.world && stated == files.end())
        recording.warnings.push_back(
            "No coordinate system is stated; attitudes were taken as ENU, MT Manager's "
            "usual one (--world replaces it)");
    return choice.world            ? *choice.world
           : stated != files.end() ? *stated->stated_world
                                   : WorldFrame::kEastNorthUp;
}

/// Counters of one recording run together; one file may begin behind the wrap.
void alignCounters(std::vector<XsensFile>& files) {
    for (XsensFile& file : files) {
        const int64_t apart = file.counts.front() - files.front().counts.front();
        const int64_t turns = apart > kCounterPeriod / 2 ? -1 : apart < -kCounterPeriod / 2 ? 1 : 0;
        for (int64_t& count : file.counts)
            count += turns * kCounterPeriod;
    }
}

Result<ImportedRecording> readXsensText(const std::vector<ImportFile>& given, const ImportChoice& choice,
                                        const JobContext& job) {
    ImportedRecording recording;
    recording.name = given.front().stem();
    std::vector<XsensFile> files;
    for (const ImportFile& one : given) {
        auto file = readXsensFile(one, job);
        if (!file)
            return file.error();
        if (file->counts.front() == kNoCount)
            return xsensError(one.path, "its first row has no packet counter");
        if (file->cut)
            recording.warnings.push_back(one.path + ": the last line has no end and was left out");
        files.push_back(std::move(*file));
        job.progress(double(files.size()) / double(given.size()), "Reading");
    }
    const auto rate_hz = rateOf(files, choice, recording, given.front().path);
    if (!rate_hz)
        return rate_hz.error();
    alignCounters(files);
    const WorldFrame world = xsensWorld(files, choice, recording);
    int64_t first = files.front().counts.front();
    for (const XsensFile& file : files)
        first = std::min(first, file.counts.front());
    for (const XsensFile& file : files) {
        const auto grid = gridOfCounts(file.counts, *rate_hz, file.id);
        if (!grid)
            return grid.error();
        ImportedSensor sensor = sensorOnGrid(file.id, rowsOf(file, worldFromFile(world)), *grid);
        sensor.offset_s = double(file.counts.front() - first) / *rate_hz;
        for (const std::string& finding : grid->findings(file.id))
            recording.warnings.push_back(finding);
        recording.sensors.push_back(std::move(sensor));
    }
    recording.notes = {files.front().is_dot
                           ? "Rates are deg/s in Movella DOT's tables; they were converted to rad/s"
                           : "Rates are rad/s, accelerations m/s^2 with gravity, as MT Manager writes them",
                       "Attitudes take the sensor's frame to " + worldFrameText(world),
                       "Sensors are aligned by their packet counters"};
    return recording;
}

}  // namespace

const ImportFormat& xsensTextFormat() {
    static const ImportFormat format = {"mt", "MT Manager's text export, one file per sensor", true,
                                        knowsXsensText, readXsensText};
    return format;
}

}  // namespace noctule
