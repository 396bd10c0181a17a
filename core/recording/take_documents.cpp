// SPDX-License-Identifier: Apache-2.0
// Calibrations and actors of a take: several stand side by side, the highest id of a suit is in force.
#include "core/job/limits.h"
#include "core/math/json.h"
#include "core/recording/take.h"

namespace noctule {

Result<std::vector<DocumentRow>> Take::documents(const std::string& table) const {
    return collectRows<DocumentRow>(
        *database_, *log_, table, schema_->select(table, {"id", "suit", "created_utc"}) + " ORDER BY 1",
        [](const Statement& row, DocumentRow& document) -> RowVerdict {
            const int64_t suit = row.integer(1).value_or(0);
            if (suit < 1 || suit > 1000)
                return "suit is not 1, 2, ...";
            document = {row.integer(0).value_or(0), static_cast<int>(suit), row.shortened(2, limits::kName)};
            return "";
        });
}

Result<std::vector<DocumentRow>> Take::calibrations() const {
    return documents("calibration");
}

Result<std::vector<DocumentRow>> Take::actors() const {
    return documents("actor");
}

template <class T, class Parse>
Result<Stored<T>> Take::document(const std::string& table, const std::string& where, const std::string& who,
                                 Parse parse) const {
    Result<Statement> row =
        database_->prepare(schema_->select(table, {"id", "json"}) + where + " ORDER BY 1 DESC LIMIT 1");
    if (!row)
        return row.error();
    const Result<bool> there = row->step();
    if (!there)
        return there.error();
    if (!*there)
        return unusable("there is no " + table + " " + who, "Give one to process, with --" + table);
    const int64_t id = row->integer(0).value_or(0);
    Result<T> value =
        parse(json::parse(row->text(1).value_or("")), path() + ": " + table + " " + std::to_string(id));
    if (!value)
        return value.error();
    return Stored<T>{id, std::move(*value)};
}

Result<Stored<Calibration>> Take::calibrationInForce(int suit) const {
    suit = seen(suit);
    return document<Calibration>("calibration", ofSuit("calibration", suit),
                                 "of suit " + std::to_string(suit), calibrationFromJson);
}

Result<Stored<Actor>> Take::actorInForce(int suit) const {
    suit = seen(suit);
    return document<Actor>("actor", ofSuit("actor", suit), "of suit " + std::to_string(suit), actorFromJson);
}

Result<Calibration> Take::calibration(int64_t id) const {
    auto stored = document<Calibration>("calibration", " WHERE id=" + std::to_string(id),
                                        "with id " + std::to_string(id), calibrationFromJson);
    if (!stored)
        return stored.error();
    return std::move(stored->value);
}

Result<Actor> Take::actor(int64_t id) const {
    auto stored = document<Actor>("actor", " WHERE id=" + std::to_string(id), "with id " + std::to_string(id),
                                  actorFromJson);
    if (!stored)
        return stored.error();
    return std::move(stored->value);
}

Result<Actor> Take::referenceActor(int suit) const {
    suit = seen(suit);
    const auto own = meta_.find(suit == 1 ? "reference_actor" : "reference_actor_" + std::to_string(suit));
    if (own != meta_.end())
        return actorFromJson(json::parse(own->second), path() + ": reference_actor");
    auto in_force = actorInForce(suit);
    if (!in_force)
        return in_force.error();
    return std::move(in_force->value);
}

}  // namespace noctule
