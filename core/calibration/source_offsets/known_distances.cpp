// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/known_distances.h"

#include <array>
#include <map>
#include <numbers>

#include "core/calibration/source_offsets/measured_table.h"
#include "core/formats/number_text.h"
#include "core/math/conventions.h"
#include "core/suit/suit.h"

namespace noctule {
namespace {

const char* const kDigitizerHeader = "placement,kind,id,x_m,y_m,z_m";
const char* const kTapeHeader = "placement,source,board,distance_m";

struct TouchedPoint {
    std::string id;
    Vector3d point_m;
};
struct TouchedPlacement {
    std::string label;
    std::array<std::vector<TouchedPoint>, 2> points;  ///< sources, boards
};

Error wrongHeader(const MeasuredTable& table, const std::string& missing, const char* header,
                  const char* other_header, bool is_other) {
    return table.headerError("there is no column " + missing,
                             is_other ? std::string("This looks like the other kind of table, ") +
                                            other_header + "; give it as such"
                                      : std::string("Name the columns ") + header);
}

/// Of columns that are all in metres or all in millimetres: their places and what a unit is in metres.
struct LengthColumns {
    std::vector<size_t> columns;
    double unit_m = 1;
};

Result<LengthColumns> lengthColumns(const MeasuredTable& table, const std::vector<std::string>& names,
                                    const Error& missing) {
    LengthColumns in_m{{}, 1}, in_mm{{}, 1e-3};
    for (const std::string& name : names) {
        if (const auto column = table.column(name + "_m"))
            in_m.columns.push_back(*column);
        if (const auto column = table.column(name + "_mm"))
            in_mm.columns.push_back(*column);
    }
    if (!in_m.columns.empty() && !in_mm.columns.empty())
        return table.headerError("some columns are in metres and some in millimetres", "Keep one unit");
    const LengthColumns& found = in_m.columns.empty() ? in_mm : in_m;
    return found.columns.size() == names.size() ? Result<LengthColumns>(found) : missing;
}

/// Columns of words in the given order; the first that is missing becomes an error.
Result<std::vector<size_t>> wordColumns(const MeasuredTable& table, const std::vector<std::string>& names,
                                        const char* header, const char* other_header, bool is_other) {
    std::vector<size_t> columns;
    for (const std::string& name : names) {
        const auto column = table.column(name);
        if (!column)
            return wrongHeader(table, name, header, other_header, is_other);
        columns.push_back(*column);
    }
    return columns;
}

class DigitizerTable {
public:
    explicit DigitizerTable(MeasuredTable table) : table_(std::move(table)) {}

    Result<KnownDistances> read(const std::string& where) {
        if (const Status found = findColumns(); !found)
            return found.error();
        for (size_t row = 0; row < table_.rowCount(); ++row)
            if (const Status added = addRow(row); !added)
                return added.error();
        KnownDistances known{where, {}};
        for (const TouchedPlacement& placement : placements_) {
            for (const size_t kind : {0, 1})
                if (placement.points[kind].empty())
                    return Error{ErrorKind::kUnreadable,
                                 where + ": placement " + inQuotes(placement.label) + " has no row of a " +
                                     (kind == 0 ? "source" : "board"),
                                 "Add the points or remove the placement"};
            addPairs(placement, known.distances);
        }
        return known;
    }

private:
    Status findColumns() {
        const bool is_tape = table_.column("distance_m") || table_.column("distance_mm");
        const auto words =
            wordColumns(table_, {"placement", "kind", "id"}, kDigitizerHeader, kTapeHeader, is_tape);
        if (!words)
            return words.error();
        const auto lengths =
            lengthColumns(table_, {"x", "y", "z"},
                          wrongHeader(table_, "x_m, y_m or z_m", kDigitizerHeader, kTapeHeader, is_tape));
        if (!lengths)
            return lengths.error();
        words_ = *words;
        lengths_ = *lengths;
        return Done{};
    }

    Status addRow(size_t row) {
        std::array<std::string, 3> words;
        for (size_t i = 0; i < words.size(); ++i) {
            const auto word = table_.word(row, words_[i]);
            if (!word)
                return word.error();
            words[i] = *word;
        }
        const auto& [label, kind, id] = words;
        if (kind != "source" && kind != "board")
            return table_.rowError(row, "kind is " + inQuotes(kind), "Write source or board");
        TouchedPoint point{id, {}};
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = table_.number(row, lengths_.columns[static_cast<size_t>(axis)]);
            if (!value)
                return value.error();
            point.point_m[axis] = *value * lengths_.unit_m;
        }
        const auto [first, is_new] = lines_.emplace(words, table_.lineOf(row));
        if (!is_new)
            return table_.rowError(row,
                                   kind + " " + inQuotes(id) + " of placement " + inQuotes(label) +
                                       " stands in line " + std::to_string(first->second) + " already",
                                   "Keep one of the rows, or correct the name in the other");
        auto& points = placementNamed(label).points[kind == "source" ? 0 : 1];
        if (points.size() == Suit::kMaxPerSuit)
            return table_.rowError(row,
                                   "placement " + inQuotes(label) + " has more than " +
                                       std::to_string(Suit::kMaxPerSuit) + " points of kind " + kind,
                                   "No suit is that large: remove the rows that do not belong to it");
        points.push_back(std::move(point));
        return Done{};
    }

    TouchedPlacement& placementNamed(const std::string& label) {
        const auto [found, is_new] = index_.emplace(label, placements_.size());
        if (is_new)
            placements_.push_back({label, {}});
        return placements_[found->second];
    }

    static void addPairs(const TouchedPlacement& placement, std::vector<KnownDistance>& distances) {
        for (const TouchedPoint& source : placement.points[0])
            for (const TouchedPoint& board : placement.points[1])
                distances.push_back({placement.label, source.id, board.id,
                                     (source.point_m - board.point_m).norm(),
                                     kDigitizerSigma_m * std::numbers::sqrt2});
    }

    MeasuredTable table_;
    std::vector<size_t> words_;
    LengthColumns lengths_;
    std::vector<TouchedPlacement> placements_;
    std::map<std::string, size_t> index_;                 ///< of each label in placements_
    std::map<std::array<std::string, 3>, size_t> lines_;  ///< of each point
};

Result<KnownDistance> tapeRow(const MeasuredTable& table, size_t row, const std::vector<size_t>& words,
                              const LengthColumns& length) {
    KnownDistance known;
    std::string* const cells[] = {&known.placement, &known.source, &known.board};
    for (size_t i = 0; i < std::size(cells); ++i) {
        const auto word = table.word(row, words[i]);
        if (!word)
            return word.error();
        *cells[i] = *word;
    }
    const auto value = table.number(row, length.columns[0]);
    if (!value)
        return value.error();
    known.distance_m = *value * length.unit_m;
    known.sigma_m = kTapeSigma_m;
    if (!(known.distance_m > 0))
        return table.rowError(row, "the distance is not above 0",
                              "Give the distance from the source to the microphone's opening");
    return known;
}

}  // namespace

Result<KnownDistances> readDigitizerCsv(const std::string& text, const std::string& where) {
    auto table = MeasuredTable::parse(text, where);
    if (!table)
        return table.error();
    return DigitizerTable(std::move(*table)).read(where);
}

Result<KnownDistances> readTapeMeasureCsv(const std::string& text, const std::string& where) {
    const auto table = MeasuredTable::parse(text, where);
    if (!table)
        return table.error();
    const bool is_digitizer = table->column("kind") || table->column("x_m") || table->column("x_mm");
    const auto words =
        wordColumns(*table, {"placement", "source", "board"}, kTapeHeader, kDigitizerHeader, is_digitizer);
    if (!words)
        return words.error();
    const auto length = lengthColumns(
        *table, {"distance"}, wrongHeader(*table, "distance_m", kTapeHeader, kDigitizerHeader, is_digitizer));
    if (!length)
        return length.error();
    KnownDistances known{where, {}};
    std::map<std::array<std::string, 3>, size_t> lines;
    for (size_t row = 0; row < table->rowCount(); ++row) {
        auto distance = tapeRow(*table, row, *words, *length);
        if (!distance)
            return distance.error();
        const auto [first, is_new] = lines.emplace(
            std::array{distance->placement, distance->source, distance->board}, table->lineOf(row));
        if (!is_new)
            return table->rowError(row,
                                   "this pair of placement " + inQuotes(distance->placement) +
                                       " stands in line " + std::to_string(first->second) + " already",
                                   "Keep one of the rows, or correct the name in the other");
        known.distances.push_back(std::move(*distance));
    }
    return known;
}

}  // namespace noctule
