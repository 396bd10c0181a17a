// SPDX-License-Identifier: Apache-2.0
#include "core/recording/schema.h"

#include <algorithm>

namespace noctule {

namespace {

std::vector<TableDefinition> makeTables() {
    const ColumnDefinition id{"id", "INTEGER PRIMARY KEY"};
    const ColumnDefinition suit{"suit", "INTEGER NOT NULL DEFAULT 1"};
    const ColumnDefinition sample{"sample", "INTEGER NOT NULL"};
    const ColumnDefinition first_sample{"first_sample", "INTEGER NOT NULL"};
    const ColumnDefinition sample_count{"sample_count", "INTEGER NOT NULL"};
    const ColumnDefinition json{"json", "TEXT NOT NULL"};
    const ColumnDefinition created_utc{"created_utc", "TEXT"};
    const auto integer = [](const char* name) { return ColumnDefinition{name, "INTEGER"}; };
    const auto real = [](const char* name) { return ColumnDefinition{name, "REAL"}; };
    const auto text = [](const char* name) { return ColumnDefinition{name, "TEXT"}; };
    const auto blob = [](const char* name) { return ColumnDefinition{name, "BLOB"}; };
    return {
        {"meta", {{"key", "TEXT PRIMARY KEY"}, {"value", "TEXT NOT NULL"}}, "", "", true},
        {"suit",
         {id,
          json,
          {"clock_offset_ns", "REAL NOT NULL DEFAULT 0"},
          {"clock_rate", "REAL NOT NULL DEFAULT 1"}},
         "",
         "",
         true},
        {"calibration", {id, suit, created_utc, json}, "", "", true},
        {"actor", {id, suit, created_utc, json}, "", "", true},
        {"adc_block",
         {id,
          suit,
          first_sample,
          sample_count,
          {"codec", "INTEGER NOT NULL DEFAULT 0"},
          {"data", "BLOB NOT NULL"}},
         "",
         "CREATE UNIQUE INDEX adc_block_first ON adc_block(suit, first_sample)",
         true},
        {"pulse",
         {id, suit, sample, {"source", "INTEGER NOT NULL"}},
         "",
         "CREATE INDEX pulse_sample ON pulse(suit, sample)",
         true},
        {"status",
         {id, suit, sample, real("temperature_c"), real("humidity_percent"), real("battery_v"),
          real("battery_percent")},
         "",
         "",
         true},
        {"gap", {id, suit, first_sample, sample_count, integer("board"), text("reason")}, "", "", true},
        {"marker", {id, suit, sample, {"kind", "TEXT NOT NULL"}, {"label", "TEXT NOT NULL"}}, "", "", true},
        {"note", {id, {"created_utc", "TEXT NOT NULL"}, {"text", "TEXT NOT NULL"}}, "", "", true},
        {"derived",
         {{"run", "INTEGER PRIMARY KEY"},
          text("kind"),
          text("name"),
          created_utc,
          text("software"),
          text("settings"),
          integer("calibration_id"),
          integer("actor_id")},
         "",
         "",
         false},
        {"inertial",
         {integer("run"), suit, integer("board"), integer("frame"), real("sample"), integer("gx"),
          integer("gy"), integer("gz"), integer("ax"), integer("ay"), integer("az"), integer("mx"),
          integer("my"), integer("mz"), integer("corrected")},
         "PRIMARY KEY(run, suit, board, frame)",
         "",
         false},
        {"range",
         {integer("run"), integer("pulse"), suit, integer("board"), text("detector"), real("arrival_sample"),
          real("distance_m"), real("w_s"), real("w_t"), real("w_a"), real("sigma_m"), text("fate"),
          real("innovation_m")},
         "PRIMARY KEY(run, pulse, suit, board)",
         "",
         false},
        {"pose",
         {integer("run"), suit, integer("time_ns"), blob("sigma"), real("px"), real("py"), real("pz"),
          blob("q")},
         "PRIMARY KEY(run, suit, time_ns)",
         "",
         false},
        {"reference",
         {suit, integer("time_ns"), real("px"), real("py"), real("pz"), blob("q")},
         "PRIMARY KEY(suit, time_ns)",
         "",
         false},
        {"external_root",
         {suit, integer("time_ns"), real("px"), real("py"), real("pz"), real("qw"), real("qx"), real("qy"),
          real("qz"), real("sigma_p_m"), real("sigma_q_rad")},
         "PRIMARY KEY(suit, time_ns)",
         "",
         false},
    };
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
