// SPDX-License-Identifier: Apache-2.0
// The columns of a table of another program: where they are, and what each of them probably is, told from its
// name and its first values. A guess is shown to the operator and becomes a map (README.md) when confirmed.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/job.h"

namespace noctule {

/// The table's header and where its rows begin.
struct TableHead {
    std::vector<std::string> names;
    std::vector<std::string> units;  ///< of a line below the names; empty, or one per name
    char separator = ',';
    size_t first_line = 1;
    std::string_view rows;
    bool has_names = true;
};
/// The header is the first line with two cells of which one is no number and which most lines below it match
/// in their count of cells: other lines before a table are narrower. A table without has columns 1, 2...
Result<TableHead> tableHead(std::string_view text, const std::string& path);

enum class TableQuantity { kNothing, kTime, kGyro, kAccel, kMag, kQuaternion };
/// Columns that make one of it: 3 axes x y z, of a quaternion w x y z; of the time 1.
size_t axisCount(TableQuantity quantity);

struct TableUnit {
    const char* name;  ///< as the map says it
    double scale;      ///< to SI, of fields to microtesla
};
/// Empty for what has none.
std::span<const TableUnit> unitsOf(TableQuantity quantity);

struct TableColumn {
    std::string name;
    std::vector<std::string> cells;  ///< the first few
    TableQuantity quantity = TableQuantity::kNothing;
    size_t axis = 0;     ///< below axisCount(quantity)
    std::string sensor;  ///< whose; of the time empty
};

struct TableColumns {
    std::vector<TableColumn> columns;
    bool has_header = true;  ///< false: the columns are named by their numbers
    std::string time_unit = "s", gyro_unit = "rad/s", accel_unit = "m/s^2", mag_unit = "uT";
};

/// Reads the first lines only. kUnreadable names the file.
Result<TableColumns> guessColumns(const std::string& path);

/// A sentence for each quantity of a sensor that the table has in further columns, by their names, beside the
/// `used` ones.
std::vector<std::string> columnsLeftOut(const std::vector<std::string>& names,
                                        const std::vector<size_t>& used);

/// The quantity, axis and sensor that its name tells.
TableColumn columnNamed(const std::string& name);

/// kUsage says which column is missing or named twice. `rate_hz` stands for the time where no column has it.
Result<nlohmann::json> mapOfColumns(const TableColumns& table, double rate_hz);

}  // namespace noctule
