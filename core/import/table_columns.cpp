// SPDX-License-Identifier: Apache-2.0
#include "core/import/table_columns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/text_file.h"
#include "core/import/column_text.h"
#include "core/math/conventions.h"

namespace noctule {
namespace {

constexpr TableUnit kTimeUnits[] = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
constexpr TableUnit kRateUnits[] = {
    {"rad/s", 1}, {"deg/s", std::numbers::pi / 180}, {"mdeg/s", std::numbers::pi / 180000}};
constexpr TableUnit kAccelUnits[] = {{"m/s^2", 1},
                                     {"g", kStandardGravity_m_per_s2},
                                     {"mg", kStandardGravity_m_per_s2 / 1000},
                                     {"cm/s^2", 0.01}};
constexpr TableUnit kFieldUnits[] = {{"uT", 1},  {"nT", 1e-3}, {"mT", 1e3},
                                     {"G", 100}, {"mG", 0.1},  {"a.u.", 1}};

constexpr size_t kLookedAtBytes = 256 * 1024, kLookedAtRows = 20'000, kShownCells = 4;

/// "GyrX (deg/s)" -> {"gyr", "x"} and "deg/s".
struct NameParts {
    std::vector<std::string> words;
    std::string unit;
};

NameParts partsOf(const std::string& name) {
    NameParts parts;
    std::string plain = name;
    const size_t open = name.find_first_of("([");
    if (open != std::string::npos) {
        const size_t close = name.find_first_of(")]", open);
        parts.unit = std::string(trimmed(
            std::string_view(name).substr(open + 1, close == std::string::npos ? close : close - open - 1)));
        plain = name.substr(0, open) + (close == std::string::npos ? "" : " " + name.substr(close + 1));
    }
    char before = ' ';
    for (const char letter : plain) {
        const auto code = static_cast<unsigned char>(letter);
        const bool begins =
            (std::isupper(code) && std::islower(static_cast<unsigned char>(before))) ||
            (std::isdigit(code) != 0) != (std::isdigit(static_cast<unsigned char>(before)) != 0);
        if (!std::isalnum(code)) {
            before = ' ';
            continue;
        }
        if (before == ' ' || begins)
            parts.words.emplace_back();
        parts.words.back() += static_cast<char>(std::tolower(code));
        before = letter;
    }
    return parts;
}

/// Words of a quantity, as programs write them.
const std::map<std::string, TableQuantity>& quantityWords() {
    using enum TableQuantity;
    static const std::map<std::string, TableQuantity> words = {{"gyr", kGyro},
                                                               {"gyro", kGyro},
                                                               {"gyroscope", kGyro},
                                                               {"omega", kGyro},
                                                               {"angular", kGyro},
                                                               {"gyros", kGyro},
                                                               {"acc", kAccel},
                                                               {"accel", kAccel},
                                                               {"acceleration", kAccel},
                                                               {"accelerometer", kAccel},
                                                               {"mag", kMag},
                                                               {"magn", kMag},
                                                               {"magnetometer", kMag},
                                                               {"magnetic", kMag},
                                                               {"quat", kQuaternion},
                                                               {"quaternion", kQuaternion},
                                                               {"orientation", kQuaternion},
                                                               {"q", kQuaternion}};
    return words;
}

constexpr std::string_view kEmptyWords[] = {
    "linear", "velocity", "field", "raw", "data", "value",   "calibrated", "sensor", "rate",
    "read",   "free",     "cal",   "ln",  "wr",   "noraxon", "myo",        "motion", "segments"};

std::optional<size_t> axisOf(const std::string& word, bool is_quaternion) {
    static const std::string axes = "wxyz";
    if (word.size() == 1 && axes.find(word) != std::string::npos) {
        const size_t axis = axes.find(word);
        if (is_quaternion || axis > 0)
            return is_quaternion ? axis : axis - 1;
    }
    if (is_quaternion && word.size() == 1 && word[0] >= '0' && word[0] <= '3')
        return static_cast<size_t>(word[0] - '0');
    return std::nullopt;
}

/// "ax", "gy", "wz", "mx", "qw": quantity and axis in one word.
bool tellShort(const std::string& word, TableColumn& column) {
    static const std::map<char, TableQuantity> letters = {{'a', TableQuantity::kAccel},
                                                          {'g', TableQuantity::kGyro},
                                                          {'w', TableQuantity::kGyro},
                                                          {'m', TableQuantity::kMag},
                                                          {'q', TableQuantity::kQuaternion}};
    const auto found = word.size() == 2 ? letters.find(word[0]) : letters.end();
    if (found == letters.end())
        return false;
    const auto axis = axisOf(word.substr(1), found->second == TableQuantity::kQuaternion);
    if (!axis)
        return false;
    column.quantity = found->second;
    column.axis = *axis;
    return true;
}

bool isTime(const std::vector<std::string>& words) {
    return std::ranges::any_of(words, [&](const std::string& word) {
        return word == "time" || word == "timestamp" || word == "elapsed" ||
               (word == "t" && words.size() <= 2);
    });
}

/// What is left of the name, without the words that tell the quantity, is the sensor.
void tellByName(TableColumn& column, const NameParts& parts) {
    std::string sensor;
    std::optional<TableQuantity> quantity;
    for (const std::string& word : parts.words)
        if (const auto found = quantityWords().find(word); found != quantityWords().end() && !quantity)
            quantity = found->second;
    std::optional<size_t> axis;
    const bool is_quaternion = quantity == TableQuantity::kQuaternion;
    // The axis stands last, a sensor's number before it.
    auto axis_word = parts.words.size();
    for (size_t i = parts.words.size(); quantity && !axis && i-- > 0;)
        if ((axis = axisOf(parts.words[i], is_quaternion)))
            axis_word = i;
    for (size_t i = 0; i < parts.words.size(); ++i) {
        const std::string& word = parts.words[i];
        if (!quantity && column.quantity == TableQuantity::kNothing && tellShort(word, column))
            continue;
        const bool tells = i == axis_word || (quantity && quantityWords().contains(word)) ||
                           std::ranges::find(kEmptyWords, word) != std::end(kEmptyWords);
        if (!tells)
            sensor += (sensor.empty() ? "" : "_") + word;
    }
    if (quantity && axis) {
        column.quantity = *quantity;
        column.axis = *axis;
    }
    if (column.quantity == TableQuantity::kNothing && isTime(parts.words))
        column.quantity = TableQuantity::kTime;
    else if (column.quantity != TableQuantity::kNothing)
        column.sensor = sensor.empty() ? "sensor" : sensor;
}

/// One time will do, and one of several accelerations: "Acc_X" goes before "FreeAcc_X". The shorter name
/// stays.
void dropDoubles(TableColumns& table) {
    std::vector<TableColumn>& columns = table.columns;
    const auto same = [](const TableColumn& a, const TableColumn& b) {
        return a.quantity != TableQuantity::kNothing && a.quantity == b.quantity && a.axis == b.axis &&
               a.sensor == b.sensor;
    };
    for (size_t i = 0; i < columns.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            if (same(columns[i], columns[j])) {
                const bool is_time = columns[i].quantity == TableQuantity::kTime;
                const bool later = !is_time && columns[i].name.size() < columns[j].name.size();
                TableColumn& dropped = columns[later ? j : i];
                dropped.quantity = TableQuantity::kNothing;
                dropped.axis = 0;
                dropped.sensor.clear();
            }
}

/// A unit as programs write it; empty: not known.
std::string unitNamed(TableQuantity quantity, std::string text) {
    std::erase(text, ' ');
    if (text.size() > 2 && (text.front() == '(' || text.front() == '['))
        text = text.substr(1, text.size() - 2);
    if (quantity == TableQuantity::kAccel && (text == "G" || text == "mG"))
        text = text == "G" ? "g" : "mg";
    static const std::map<std::string, std::string> same = {
        {"m/s2", "m/s^2"},      {"m/s²", "m/s^2"},      {"ms-2", "m/s^2"},    {"m/(s^2)", "m/s^2"},
        {"m/(sec^2)", "m/s^2"}, {"local_flux", "a.u."}, {"m/s/s", "m/s^2"},   {"°/s", "deg/s"},
        {"dps", "deg/s"},       {"degs", "deg/s"},      {"deg/sec", "deg/s"}, {"rad/sec", "rad/s"},
        {"rads", "rad/s"},      {"µT", "uT"},           {"μT", "uT"},         {"ut", "uT"},
        {"gauss", "G"},         {"Gauss", "G"},         {"mgauss", "mG"},     {"sec", "s"},
        {"seconds", "s"},       {"msec", "ms"},         {"µs", "us"},         {"μs", "us"},
        {"usec", "us"}};
    if (const auto found = same.find(text); found != same.end())
        text = found->second;
    for (const TableUnit& unit : unitsOf(quantity))
        if (text == unit.name)
            return text;
    return {};
}

/// Values of the first rows by column; cells that are no numbers are missing. `cut`: the last line has no
/// end.
std::vector<std::vector<double>> firstValues(const TableHead& head, TableColumns& table, bool cut) {
    std::vector<std::vector<double>> values(head.names.size());
    std::string_view rest = head.rows;
    for (size_t row = 0; row < kLookedAtRows && !rest.empty();) {
        const std::string_view line = cutLine(rest);
        if (trimmed(line).empty() || (cut && rest.empty()))
            continue;
        const std::vector<std::string> cells = cellsOfLine(line, head.separator);
        for (size_t i = 0; i < std::min(cells.size(), values.size()); ++i) {
            double value = kMissing;
            if (!readCell(cells[i], head.separator != ',', value))
                value = readInstant(cells[i]).value_or(kMissing);
            values[i].push_back(value);
            if (row < kShownCells)
                table.columns[i].cells.push_back(cells[i]);
        }
        ++row;
    }
    return values;
}

double medianOf(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Median length of the vectors of a quantity, over all sensors of which all three axes are there.
double usualLength(const TableColumns& table, const std::vector<std::vector<double>>& values,
                   TableQuantity quantity) {
    std::map<std::string, std::array<const std::vector<double>*, 3>> sensors;
    for (size_t i = 0; i < table.columns.size(); ++i)
        if (const TableColumn& column = table.columns[i]; column.quantity == quantity && column.axis < 3)
            sensors[column.sensor][column.axis] = &values[i];
    std::vector<double> lengths;
    for (const auto& [sensor, axes] : sensors) {
        if (!axes[0] || !axes[1] || !axes[2])
            continue;
        const size_t rows = std::min({axes[0]->size(), axes[1]->size(), axes[2]->size()});
        for (size_t row = 0; row < rows; ++row)
            lengths.push_back(std::hypot((*axes[0])[row], (*axes[1])[row], (*axes[2])[row]));
    }
    return medianOf(std::move(lengths));
}

/// Gravity, the Earth's field and a usual rate tell which unit the numbers have.
void tellUnits(TableColumns& table, const std::vector<std::vector<double>>& values) {
    const double accel = usualLength(table, values, TableQuantity::kAccel);
    if (accel > 0)
        table.accel_unit = accel < 3                    ? "g"
                           : accel < 50                 ? "m/s^2"
                           : accel > 970 && accel < 990 ? "cm/s^2"
                                                        : "mg";
    const double mag = usualLength(table, values, TableQuantity::kMag);
    if (mag > 0)
        table.mag_unit = mag > 15 && mag < 90           ? "uT"
                         : mag > 0.15 && mag < 0.9      ? "G"
                         : mag > 150 && mag < 900       ? "mG"
                         : mag > 15'000 && mag < 90'000 ? "nT"
                                                        : "a.u.";
    double fastest = 0;
    for (size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i].quantity == TableQuantity::kGyro)
            for (const double value : values[i])
                fastest = std::isfinite(value) ? std::max(fastest, std::abs(value)) : fastest;
        if (table.columns[i].quantity != TableQuantity::kTime)
            continue;
        std::vector<double> steps;
        for (size_t row = 1; row < values[i].size(); ++row)
            steps.push_back(values[i][row] - values[i][row - 1]);
        const double step = medianOf(std::move(steps));
        table.time_unit = step < 0.5 ? "s" : step < 500 ? "ms" : step < 500'000 ? "us" : "ns";
    }
    table.gyro_unit = fastest > 35 ? "deg/s" : "rad/s";  // nobody turns at 35 rad/s for long
}

void takeUnit(TableColumns& table, TableQuantity quantity, const std::string& text) {
    const std::string unit = unitNamed(quantity, text);
    std::string* const into = quantity == TableQuantity::kTime    ? &table.time_unit
                              : quantity == TableQuantity::kGyro  ? &table.gyro_unit
                              : quantity == TableQuantity::kAccel ? &table.accel_unit
                              : quantity == TableQuantity::kMag   ? &table.mag_unit
                                                                  : nullptr;
    if (into && !unit.empty())
        *into = unit;
}

const char* memberOf(TableQuantity quantity) {
    switch (quantity) {
        case TableQuantity::kGyro:
            return "gyro";
        case TableQuantity::kAccel:
            return "accel";
        case TableQuantity::kMag:
            return "mag";
        case TableQuantity::kQuaternion:
            return "quaternion";
        default:
            return "time";
    }
}

/// Column numbers from 1 by sensor, quantity and axis; 0: none.
using ColumnsOfSensors = std::map<std::string, std::map<TableQuantity, std::vector<size_t>>>;

Error columnError(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUsage, what, remedy};
}

Status addColumn(ColumnsOfSensors& sensors, const TableColumn& column, size_t number) {
    if (column.sensor.empty())
        return columnError("column " + column.name + " belongs to no sensor", "Name the sensor");
    std::vector<size_t>& axes = sensors[column.sensor][column.quantity];
    axes.resize(axisCount(column.quantity));
    if (std::exchange(axes.at(column.axis), number) != 0)
        return columnError(
            "two columns are the same axis of sensor " + column.sensor + ", the second is " + column.name,
            "Choose another meaning for one of them");
    return Done{};
}

nlohmann::json sensorEntry(const TableColumns& table, const std::string& id,
                           const std::map<TableQuantity, std::vector<size_t>>& quantities) {
    nlohmann::json sensor{{"id", id}};
    for (const auto& [quantity, columns] : quantities)
        sensor[memberOf(quantity)] = columns;
    sensor["gyro_unit"] = table.gyro_unit;
    sensor["accel_unit"] = table.accel_unit;
    sensor["mag_unit"] = table.mag_unit;
    return sensor;
}

}  // namespace

size_t axisCount(TableQuantity quantity) {
    return quantity == TableQuantity::kNothing      ? 0
           : quantity == TableQuantity::kTime       ? 1
           : quantity == TableQuantity::kQuaternion ? 4
                                                    : 3;
}

std::span<const TableUnit> unitsOf(TableQuantity quantity) {
    switch (quantity) {
        case TableQuantity::kTime:
            return kTimeUnits;
        case TableQuantity::kGyro:
            return kRateUnits;
        case TableQuantity::kAccel:
            return kAccelUnits;
        case TableQuantity::kMag:
            return kFieldUnits;
        default:
            return {};
    }
}

TableColumn columnNamed(const std::string& name) {
    TableColumn column{name, {}, TableQuantity::kNothing, 0, {}};
    tellByName(column, partsOf(name));
    return column;
}

Result<TableColumns> guessColumns(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes(kLookedAtBytes, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(std::max<std::streamsize>(0, file.gcount())));
    const std::optional<std::string> utf8 = fromUtf16(bytes);
    const auto head =
        tableHead(withoutByteOrderMark(utf8 ? std::string_view(*utf8) : std::string_view(bytes)), path);
    if (!head)
        return head.error();
    TableColumns table;
    table.has_header = head->has_names;
    for (const std::string& name : head->names)
        table.columns.push_back(columnNamed(name));
    dropDoubles(table);
    const auto values = firstValues(*head, table, bytes.size() == kLookedAtBytes);
    if (values.front().empty())
        return Error{ErrorKind::kUnreadable, path + ": there is a header and no row below it",
                     "Give a table with numbers"};
    tellUnits(table, values);
    for (size_t i = 0; i < table.columns.size(); ++i) {
        if (!head->units.empty())
            takeUnit(table, table.columns[i].quantity, head->units[i]);
        takeUnit(table, table.columns[i].quantity, partsOf(table.columns[i].name).unit);
    }
    // Dates and times of day are read as seconds, however far apart they are.
    const auto is_instant = [](const std::string& cell) { return readInstant(cell).has_value(); };
    for (const TableColumn& column : table.columns)
        if (column.quantity == TableQuantity::kTime && std::ranges::any_of(column.cells, is_instant))
            table.time_unit = "s";
    return table;
}

Result<nlohmann::json> mapOfColumns(const TableColumns& table, double rate_hz) {
    nlohmann::json map{{"format", "noctule-import-map"}, {"version", 1}};
    ColumnsOfSensors sensors;
    for (size_t i = 0; i < table.columns.size(); ++i) {
        const TableColumn& column = table.columns[i];
        if (column.quantity == TableQuantity::kTime && map.contains("time"))
            return columnError("two columns are the time, the second is " + column.name,
                               "Choose another meaning for one of them");
        if (column.quantity == TableQuantity::kTime)
            map["time"] = {{"column", i + 1}, {"unit", table.time_unit}};
        else if (column.quantity != TableQuantity::kNothing)
            if (Status added = addColumn(sensors, column, i + 1); !added)
                return added.error();
    }
    if (!map.contains("time") && rate_hz <= 0)
        return columnError("no column is the time", "Choose the column of the time, or give the rate");
    if (rate_hz > 0)
        map["rate_hz"] = rate_hz;
    if (sensors.empty())
        return columnError("no column belongs to a sensor",
                           "Say which columns are rates, accelerations or attitudes");
    map["sensors"] = nlohmann::json::array();
    for (const auto& [id, quantities] : sensors) {
        for (const auto& [quantity, columns] : quantities)
            if (const auto gap = std::ranges::find(columns, size_t{0}); gap != columns.end()) {
                const auto axis = static_cast<size_t>(gap - columns.begin());
                const std::string names = quantity == TableQuantity::kQuaternion ? "WXYZ" : "XYZ";
                return columnError("sensor " + id + " lacks " + names[axis] + " of its " + memberOf(quantity),
                                   "Choose the column, or nothing for the others");
            }
        map["sensors"].push_back(sensorEntry(table, id, quantities));
    }
    return map;
}

}  // namespace noctule
