// SPDX-License-Identifier: Apache-2.0
// TRC: tab-separated markers. Which axis points up is not stated. Sources: opensim-core, TRCFileAdapter.cpp,
// and files of motion laboratories.
#include <algorithm>
#include <cmath>

#include "core/formats/csv_cells.h"
#include "core/formats/number_text.h"
#include "core/formats/text_file.h"
#include "core/import/column_text.h"
#include "core/import/markers.h"
#include "core/import/sensor_rows.h"

namespace noctule {

namespace {

constexpr size_t kMostMarkers = 1000;
constexpr size_t kMostTrcRows = 20'000'000;

class TrcReader {
public:
    TrcReader(std::string_view text, const std::string& where) : text_(text), where_(where) {}

    Result<MarkerRecording> read(const JobContext& job) {
        if (Status header = readHeader(); !header)
            return header.error();
        while (!text_.empty()) {
            const bool has_end = text_.find_first_of("\r\n") != std::string_view::npos;
            const std::string_view line = next();
            if (trimmed(line).empty())
                continue;
            if (!has_end) {
                markers_.warnings.push_back(where_ + ": the last line has no end and was left out");
                break;
            }
            if (Status row = readRow(line); !row)
                return row.error();
            if (number_ % 4096 == 0 && job.cancelled())
                return JobContext::cancelledError();
        }
        if (markers_.p_m.empty())
            return damaged("it holds no row of markers");
        checkCounts();
        return std::move(markers_);
    }

private:
    std::string_view next() {
        ++number_;
        return cutLine(text_);
    }
    Error damaged(const std::string& what) const {
        return {ErrorKind::kUnreadable, where_ + ", line " + std::to_string(number_) + ": " + what,
                "Export the markers again"};
    }

    Status readHeader() {
        if (!next().starts_with("PathFileType"))
            return damaged("it does not begin with PathFileType");
        auto keys = cellsOfLine(next(), '\t'), values = cellsOfLine(next(), '\t');
        if (filled(keys).size() == filled(values).size()) {  // some programs write several tabs
            keys = filled(keys);
            values = filled(values);
        }
        for (size_t i = 0; i < std::min(keys.size(), values.size()); ++i) {
            if (keys[i] == "DataRate" && !readCell(values[i], false, markers_.rate_hz))
                return damaged("DataRate is " + inQuotes(values[i]));
            if (keys[i] == "Units")
                markers_.unit = values[i].substr(0, 20);
            if (keys[i] == "NumFrames")
                (void)readCell(values[i], false, stated_rows_);
        }
        if (!(markers_.rate_hz >= 1 && markers_.rate_hz <= 100'000))
            return damaged("it states no usable DataRate");
        scale_ = markers_.unit == "m" ? 1 : markers_.unit == "cm" ? 0.01 : 0.001;
        if (markers_.unit != "m" && markers_.unit != "mm" && markers_.unit != "cm")
            markers_.warnings.push_back(where_ + ": states the unit " + inQuotes(markers_.unit) +
                                        "; mm was taken");
        const auto names = cellsOfLine(next(), '\t');
        if (names.size() < 3 || !names[0].starts_with("Frame"))
            return damaged("the line of names does not begin with Frame#");
        takeNames({names.begin() + 2, names.end()});
        if (markers_.names.empty() || markers_.names.size() > kMostMarkers)
            return damaged("it names " + std::to_string(markers_.names.size()) + " markers");
        next();  // X1 Y1 Z1 ...
        return Done{};
    }

    static std::vector<std::string> filled(std::vector<std::string> cells) {
        std::erase(cells, "");
        return cells;
    }

    /// Each name stands above its X; some programs write one tab between names.
    void takeNames(std::vector<std::string> cells) {
        while (!cells.empty() && cells.back().empty())
            cells.pop_back();
        size_t step = 3;
        for (size_t i = 0; i < cells.size(); ++i)
            if (i % 3 != 0 && !cells[i].empty())
                step = 1;
        if (step == 1)
            cells = filled(std::move(cells));
        for (size_t i = 0; i < cells.size(); i += step)
            markers_.names.push_back(cells[i].empty() ? "point " + std::to_string(i / step + 1)
                                                      : cells[i].substr(0, 100));
    }

    Status readRow(std::string_view line) {
        const auto cells = cellsOfLine(line, '\t');
        if (markers_.p_m.size() / markers_.names.size() >= kMostTrcRows)
            return damaged("it has more rows than any recording");
        for (size_t m = 0; m < markers_.names.size(); ++m) {
            Vector3d p = missingVector();
            for (size_t axis = 0; axis < 3; ++axis) {
                const size_t at = 2 + 3 * m + axis;
                if (at < cells.size() && !readCell(cells[at], false, p[Eigen::Index(axis)]))
                    return damaged(markers_.names[m] + " holds " + inQuotes(cells[at]) +
                                   ", which is no number");
            }
            markers_.p_m.push_back(scale_ * p);
        }
        return Done{};
    }

    void checkCounts() {
        if (std::isfinite(stated_rows_) && stated_rows_ > 0 && stated_rows_ != double(markers_.rows()))
            markers_.warnings.push_back(
                where_ + ": states " + std::to_string(std::llround(std::min(stated_rows_, 1e9))) +
                " rows and holds " + std::to_string(markers_.rows()) + "; the rows were taken");
    }

    std::string_view text_;
    const std::string& where_;
    size_t number_ = 0;
    double scale_ = 0.001, stated_rows_ = 0;
    MarkerRecording markers_;
};

}  // namespace

Result<MarkerRecording> parseTrc(std::string_view text, const std::string& where, const JobContext& job) {
    return TrcReader(withoutByteOrderMark(text), where).read(job);
}

}  // namespace noctule
