// SPDX-License-Identifier: Apache-2.0
#include <sqlite3.h>

#include <cmath>

#include "core/job/outside_text.h"
#include "core/recording/database.h"

namespace noctule {

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Error Statement::failure() const {
    return Database::failure(sqlite3_db_handle(statement_.get()), name_, *watch_);
}

Statement& Statement::bind(int parameter, int64_t value) {
    sqlite3_bind_int64(statement_.get(), parameter + 1, value);
    return *this;
}

Statement& Statement::bind(int parameter, double value) {
    not_finite_ = not_finite_ || !std::isfinite(value);
    sqlite3_bind_double(statement_.get(), parameter + 1, value);
    return *this;
}

Statement& Statement::bind(int parameter, const std::optional<int64_t>& value) {
    return value ? bind(parameter, *value) : bindNull(parameter);
}

Statement& Statement::bind(int parameter, const std::optional<double>& value) {
    return value ? bind(parameter, *value) : bindNull(parameter);
}

Statement& Statement::bind(int parameter, std::string_view text) {
    sqlite3_bind_text64(statement_.get(), parameter + 1, text.data() ? text.data() : "", text.size(),
                        SQLITE_TRANSIENT, SQLITE_UTF8);
    return *this;
}

Statement& Statement::bindBlob(int parameter, std::span<const std::byte> bytes) {
    const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
    sqlite3_bind_blob64(statement_.get(), parameter + 1, data, bytes.size(), SQLITE_STATIC);
    return *this;
}

Statement& Statement::bindNull(int parameter) {
    sqlite3_bind_null(statement_.get(), parameter + 1);
    return *this;
}

Status Statement::run() {
    const Result<bool> stepped = step();
    reset();
    if (!stepped)
        return stepped.error();
    return Done{};
}

Result<bool> Statement::step() {
    if (std::exchange(not_finite_, false))
        return Error{ErrorKind::kInternal, name_ + ": a number to be stored is not finite",
                     "Please report this with the take"};
    watch_->steps = 0;
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW)
        return true;
    if (code == SQLITE_DONE)
        return false;
    return failure();
}

void Statement::reset() {
    sqlite3_reset(statement_.get());
    not_finite_ = false;
}

bool Statement::isNull(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::optional<int64_t> Statement::integer(int column) const {
    constexpr double kExact = 9007199254740992.0;  // 2^53
    const int type = sqlite3_column_type(statement_.get(), column);
    if (type == SQLITE_INTEGER)
        return sqlite3_column_int64(statement_.get(), column);
    const double value = type == SQLITE_FLOAT ? sqlite3_column_double(statement_.get(), column) : 0.5;
    if (std::abs(value) <= kExact && value == std::floor(value))
        return static_cast<int64_t>(value);
    return std::nullopt;
}

std::optional<double> Statement::real(int column) const {
    const int type = sqlite3_column_type(statement_.get(), column);
    if (type != SQLITE_INTEGER && type != SQLITE_FLOAT)
        return std::nullopt;
    const double value = sqlite3_column_double(statement_.get(), column);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::string> Statement::text(int column) const {
    if (sqlite3_column_type(statement_.get(), column) != SQLITE_TEXT)
        return std::nullopt;
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    if (!text)
        return std::nullopt;
    return std::string(text, static_cast<size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

std::string Statement::shortened(int column, size_t most) const {
    if (sqlite3_column_type(statement_.get(), column) != SQLITE_TEXT)
        return "";
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    const auto size = static_cast<size_t>(sqlite3_column_bytes(statement_.get(), column));
    return text ? shortText({text, size}, most) : "";
}

std::optional<std::span<const std::byte>> Statement::blob(int column) const {
    if (sqlite3_column_type(statement_.get(), column) != SQLITE_BLOB)
        return std::nullopt;
    const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
    return std::span(data, static_cast<size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

}  // namespace noctule
