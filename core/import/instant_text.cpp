// SPDX-License-Identifier: Apache-2.0
// Dates and times of day in the cells of tables.
#include <cctype>
#include <chrono>
#include <cmath>

#include "core/import/column_text.h"

namespace noctule {
namespace {

/// Goes through the digits and signs of an instant.
class InstantCursor {
public:
    explicit InstantCursor(std::string_view text) : text_(text) {}

    bool atEnd() const { return text_.empty(); }
    bool take(std::string_view any_of) {
        if (text_.empty() || any_of.find(text_.front()) == std::string_view::npos)
            return false;
        text_.remove_prefix(1);
        return true;
    }
    bool digits(size_t count, int& number) {
        number = 0;
        for (size_t i = 0; i < count; ++i) {
            if (text_.empty() || !std::isdigit(static_cast<unsigned char>(text_.front())))
                return false;
            number = 10 * number + (text_.front() - '0');
            text_.remove_prefix(1);
        }
        return true;
    }
    /// Of a second, behind its point.
    double fraction() {
        double value = 0, place = 0.1;
        for (int digit = 0; digits(1, digit); place /= 10)
            value += place * digit;
        return value;
    }
    bool followsDate() const { return text_.size() > 4 && (text_[4] == '-' || text_[4] == '/'); }

private:
    std::string_view text_;
};

constexpr double kMinute_s = 60, kHour_s = 3600, kDay_s = 86400;

std::optional<double> dayOf(InstantCursor& cursor) {
    int year = 0, month = 0, day = 0;
    if (!cursor.digits(4, year) || !cursor.take("-/") || !cursor.digits(2, month) || !cursor.take("-/") ||
        !cursor.digits(2, day) || !cursor.take("T _"))
        return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(unsigned(month)),
                                           std::chrono::day(unsigned(day))};
    if (!date.ok())
        return std::nullopt;
    return kDay_s * double(std::chrono::sys_days(date).time_since_epoch().count());
}

/// "Z", "+02:00", "+0200", or nothing: seconds before UTC.
std::optional<double> readZone(InstantCursor& cursor) {
    if (cursor.atEnd() || cursor.take("Z"))
        return 0;
    const bool is_east = cursor.take("+");
    int hours = 0, minutes = 0;
    if ((!is_east && !cursor.take("-")) || !cursor.digits(2, hours))
        return std::nullopt;
    cursor.take(":");
    if (!cursor.digits(2, minutes))
        return std::nullopt;
    return (is_east ? 1 : -1) * (kHour_s * hours + kMinute_s * minutes);
}

}  // namespace

std::optional<double> readInstant(std::string_view cell) {
    InstantCursor cursor(cell);
    double seconds = 0;
    if (cursor.followsDate()) {
        const auto date = dayOf(cursor);
        if (!date)
            return std::nullopt;
        seconds = *date;
    }
    int hour = 0, minute = 0, second = 0;
    if (!cursor.digits(2, hour) || !cursor.take(":") || !cursor.digits(2, minute) || !cursor.take(":") ||
        !cursor.digits(2, second) || hour > 24 || minute > 59 || second > 60)
        return std::nullopt;
    seconds += kHour_s * hour + kMinute_s * minute + second;
    if (cursor.take(".,"))
        seconds += cursor.fraction();
    const auto zone = readZone(cursor);
    return zone && cursor.atEnd() ? std::optional(seconds - *zone) : std::nullopt;
}

std::optional<double> readDateAndTime(std::string_view text) {
    return InstantCursor(text).followsDate() ? readInstant(text) : std::nullopt;
}

}  // namespace noctule
