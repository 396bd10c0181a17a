// SPDX-License-Identifier: Apache-2.0
// Tables with two sensors for one quantity, as Shimmer's low-noise and wide-range accelerometers.
#include <algorithm>
#include <map>

#include "core/import/table_columns.h"

namespace noctule {
namespace {

struct OfOneQuantity {
    std::vector<std::string> used, left_out;
};

std::string namesWithCommas(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

std::vector<std::string> columnsLeftOut(const std::vector<std::string>& names,
                                        const std::vector<size_t>& used) {
    std::map<std::pair<std::string, TableQuantity>, OfOneQuantity> quantities;
    for (size_t i = 0; i < names.size(); ++i) {
        const TableColumn column = columnNamed(names[i]);
        if (column.quantity == TableQuantity::kNothing || column.quantity == TableQuantity::kTime)
            continue;
        OfOneQuantity& of = quantities[{column.sensor, column.quantity}];
        (std::ranges::find(used, i) == used.end() ? of.left_out : of.used).push_back(names[i]);
    }
    std::vector<std::string> sentences;
    for (const auto& [which, of] : quantities)
        if (!of.used.empty() && of.left_out.size() >= axisCount(which.second))
            sentences.push_back("Read from " + namesWithCommas(of.used) +
                                "; left out is the same quantity in " + namesWithCommas(of.left_out) +
                                ", which a map can name instead");
    return sentences;
}

}  // namespace noctule
