// SPDX-License-Identifier: Apache-2.0
#include "core/recording/schema.h"

#include <algorithm>
#include <cctype>

namespace noctule {

namespace {

const ColumnDefinition kId{"id", "INTEGER PRIMARY KEY"};
const ColumnDefinition kSuit{"suit", "INTEGER NOT NULL DEFAULT 1"};
const ColumnDefinition kSample{"sample", "INTEGER NOT NULL"};
const ColumnDefinition kFirstSample{"first_sample", "INTEGER NOT NULL"};
const ColumnDefinition kSampleCount{"sample_count", "INTEGER NOT NULL"};
const ColumnDefinition kJson{"json", "TEXT NOT NULL"};
const ColumnDefinition kCreated{"created_utc", "TEXT"};

ColumnDefinition integer(const char* name) {
    return {name, "INTEGER"};
}
ColumnDefinition real(const char* name) {
    return {name, "REAL"};
}
ColumnDefinition text(const char* name) {
    return {name, "TEXT"};
}
ColumnDefinition blob(const char* name) {
    return {name, "BLOB"};
}

/// Written as it happens: every take has them.
std::vector<TableDefinition> recordedTables() {
    return {
        {"meta", {{"key", "TEXT PRIMARY KEY"}, {"value", "TEXT NOT NULL"}}},
        {"suit",
         {kId,
          kJson,
          {"clock_offset_ns", "REAL NOT NULL DEFAULT 0"},
          {"clock_rate", "REAL NOT NULL DEFAULT 1"}}},
        {"calibration", {kId, kSuit, kCreated, kJson}},
        {"actor", {kId, kSuit, kCreated, kJson}},
        {.name = "adc_block",
         .columns = {kId,
                     kSuit,
                     kFirstSample,
                     kSampleCount,
                     {"codec", "INTEGER NOT NULL DEFAULT 0"},
                     {"data", "BLOB NOT NULL"}},
         .index = "CREATE UNIQUE INDEX adc_block_first ON adc_block(suit, first_sample)"},
        {.name = "pulse",
         .columns = {kId, kSuit, kSample, {"source", "INTEGER NOT NULL"}},
         .index = "CREATE INDEX pulse_sample ON pulse(suit, sample)"},
        {"status",
         {kId, kSuit, kSample, real("temperature_c"), real("humidity_percent"), real("battery_v"),
          real("battery_percent")}},
        {"gap", {kId, kSuit, kFirstSample, kSampleCount, integer("board"), text("reason")}},
        {"marker", {kId, kSuit, kSample, {"kind", "TEXT NOT NULL"}, {"label", "TEXT NOT NULL"}}},
        {"note", {kId, {"created_utc", "TEXT NOT NULL"}, {"text", "TEXT NOT NULL"}}},
    };
}

/// Computed from what was recorded, one set for each run.
std::vector<TableDefinition> derivedTables() {
    return {
        {"derived",
         {{"run", "INTEGER PRIMARY KEY"},
          text("kind"),
          text("name"),
          kCreated,
          text("software"),
          text("settings"),
          integer("calibration_id"),
          integer("actor_id")}},
        {"inertial",
         {integer("run"), kSuit, integer("board"), integer("frame"), real("sample"), integer("gx"),
          integer("gy"), integer("gz"), integer("ax"), integer("ay"), integer("az"), integer("mx"),
          integer("my"), integer("mz"), integer("corrected")},
         "PRIMARY KEY(run, suit, board, frame)"},
        {"range",
         {integer("run"), integer("pulse"), kSuit, integer("board"), text("detector"), real("arrival_sample"),
          real("distance_m"), real("w_s"), real("w_t"), real("w_a"), real("sigma_m"), text("fate"),
          real("innovation_m")},
         "PRIMARY KEY(run, pulse, suit, board)"},
        {"pose",
         {integer("run"), kSuit, integer("time_ns"), blob("sigma"), real("px"), real("py"), real("pz"),
          blob("q")},
         "PRIMARY KEY(run, suit, time_ns)"},
        {"orientation",
         {integer("run"), kSuit, integer("board"), integer("time_ns"), real("qw"), real("qx"), real("qy"),
          real("qz"), real("heading_sigma_rad")},
         "PRIMARY KEY(run, suit, board, time_ns)"},
        {"clock",
         {integer("run"), kSuit, integer("time_ns"), real("offset_ns"), real("rate"), real("sigma_ns")},
         "PRIMARY KEY(run, suit, time_ns)"},
        {"relative",
         {integer("run"), kSuit, integer("other_suit"), text("joint"), text("other_joint"),
          integer("time_ns"), real("xx"), real("xy"), real("xz"), real("yy"), real("yz"), real("zz")},
         "PRIMARY KEY(run, suit, other_suit, joint, other_joint, time_ns)"},
        {"contact",
         {integer("run"), kSuit, text("foot"), integer("from_ns"), integer("to_ns"), integer("by_hand")},
         "PRIMARY KEY(run, suit, foot, from_ns)"},
    };
}

/// What another system saw of the same performance.
std::vector<TableDefinition> attachedTables() {
    return {
        {"reference",
         {kSuit, integer("time_ns"), real("px"), real("py"), real("pz"), blob("q")},
         "PRIMARY KEY(suit, time_ns)"},
        {"external_root",
         {kSuit, integer("time_ns"), real("px"), real("py"), real("pz"), real("qw"), real("qx"), real("qy"),
          real("qz"), real("sigma_p_m"), real("sigma_q_rad")},
         "PRIMARY KEY(suit, time_ns)"},
    };
}

/// What a robot was told and where it was.
std::vector<TableDefinition> robotTables() {
    return {
        {"robot_drive",
         {{"drive", "INTEGER PRIMARY KEY"}, kCreated, kJson, integer("take_time_ns"), integer("lost_rows")}},
        {"robot_command",
         {integer("drive"), integer("sequence"), integer("time_ns"), integer("pose_time_ns"),
          integer("pose_arrived_ns"), text("state"), text("trouble"), blob("q"), blob("tips")},
         "PRIMARY KEY(drive, sequence)"},
        {.name = "robot_state",
         .columns = {kId, integer("drive"), integer("time_ns"), integer("obeyed_sequence"),
                     integer("refuses"), blob("q"), blob("v"), blob("tips")},
         .index = "CREATE INDEX robot_state_time ON robot_state(drive, time_ns)"},
    };
}

std::vector<TableDefinition> makeTables() {
    std::vector<TableDefinition> tables = recordedTables();
    for (TableDefinition& table : tables)
        table.required = true;
    for (const std::vector<TableDefinition>& optional : {derivedTables(), attachedTables(), robotTables()})
        tables.insert(tables.end(), optional.begin(), optional.end());
    return tables;
}

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// SQLite does not tell upper from lower case in names.
bool isTakeTable(const std::string& name) {
    return std::ranges::find(takeTables(), lowerCase(name), &TableDefinition::name) != takeTables().end();
}

Status checkOnlyTables(const Database& database) {
    Result<Statement> list = database.prepare("PRAGMA table_list");
    if (!list)
        return list.error();
    while (true) {
        const Result<bool> row = list->step();
        if (!row)
            return row.error();
        if (!*row)
            return Done{};
        const std::string name = list->text(1).value_or(""), type = list->text(2).value_or("");
        if (list->text(0) == "main" && type != "table" && isTakeTable(name))
            return Error{ErrorKind::kUnreadable,
                         database.name() + ": is not a take, its '" + name + "' is a " + type +
                             (type == "view" ? "" : " table") + " instead of a table of rows",
                         "Choose a .noctule file from a source that you trust"};
    }
}

std::string createStatement(const TableDefinition& table) {
    std::string sql = "CREATE TABLE " + table.name + "(";
    for (size_t i = 0; i < table.columns.size(); ++i)
        sql += (i ? ", " : "") + table.columns[i].name + " " + table.columns[i].declaration;
    if (!table.constraint.empty())
        sql += ", " + table.constraint;
    return sql + ")";
}

}  // namespace

const std::vector<TableDefinition>& takeTables() {
    static const std::vector<TableDefinition> kTables = makeTables();
    return kTables;
}

const TableDefinition& takeTable(const std::string& name) {
    const auto& tables = takeTables();
    const auto found = std::find_if(tables.begin(), tables.end(),
                                    [&](const TableDefinition& table) { return table.name == name; });
    require(found != tables.end(), "a table that the take format does not have");
    return *found;
}

Result<TakeSchema> TakeSchema::read(const Database& database) {
    TakeSchema schema;
    if (const Status plain = checkOnlyTables(database); !plain)
        return plain.error();
    for (const TableDefinition& table : takeTables()) {
        Result<Statement> statement = database.prepare("PRAGMA table_info(" + table.name + ")");
        if (!statement)
            return statement.error();
        while (true) {
            const Result<bool> row = statement->step();
            if (!row)
                return row.error();
            if (!*row)
                break;
            schema.columns_[table.name].insert(statement->text(1).value_or(""));
        }
    }
    return schema;
}

bool TakeSchema::has(const std::string& table, const std::string& column) const {
    const auto found = columns_.find(table);
    return found != columns_.end() && found->second.count(column) > 0;
}

std::string TakeSchema::expression(const std::string& table, const std::string& column) const {
    if (has(table, column))
        return table + "." + column;
    return column == "suit" ? "1" : "NULL";
}

std::string TakeSchema::select(const std::string& table, const std::vector<std::string>& columns) const {
    std::string sql = "SELECT ";
    for (size_t i = 0; i < columns.size(); ++i)
        sql += (i ? "," : "") + expression(table, columns[i]);
    return sql + (has(table) ? " FROM " + table : " FROM (SELECT 1 WHERE 0)");
}

Status TakeSchema::complete(const Database& database, const std::string& table) {
    const TableDefinition& definition = takeTable(table);
    if (!has(table)) {
        if (const Status made = database.execute(createStatement(definition)); !made)
            return made;
        if (!definition.index.empty())
            if (const Status made = database.execute(definition.index); !made)
                return made;
    }
    for (const ColumnDefinition& column : definition.columns) {
        if (has(table) && !has(table, column.name))
            if (const Status added = database.execute("ALTER TABLE " + table + " ADD COLUMN " + column.name +
                                                      " " + column.declaration);
                !added)
                return added;
    }
    for (const ColumnDefinition& column : definition.columns)
        columns_[table].insert(column.name);
    return Done{};
}

}  // namespace noctule
