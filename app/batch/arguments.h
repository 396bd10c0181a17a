// SPDX-License-Identifier: Apache-2.0
// A command line that has been checked against a verb's options: every value that comes out is one that the
// table allows.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/batch/option.h"
#include "core/job/result.h"

namespace noctule::batch {

class Arguments {
public:
    /// `--name value`, `--name=value`, `--names a b`, flags, operands; after `--` only operands. kUsage names
    /// the mistake.
    static Result<Arguments> parse(const std::vector<std::string>& words, const std::vector<Option>& options);

    bool given(const std::string& name) const;  ///< on the command line; of a flag its value
    /// As given, else the fallback, else empty.
    std::string text(const std::string& name) const;
    std::vector<std::string> texts(const std::string& name) const;  ///< empty: not given
    std::optional<double> number(const std::string& name) const;
    std::optional<int64_t> whole(const std::string& name) const;
    const std::vector<std::string>& operands() const { return operands_; }
    /// Operands, and the files that options name as read; without the options `but`.
    std::vector<std::string> inputFiles(const std::set<std::string>& but = {}) const;

private:
    explicit Arguments(const std::vector<Option>& options) : options_(options) {}
    const Option* find(const std::string& name) const;
    const Option& known(const std::string& name) const;
    Status addOption(const std::vector<std::string>& words, size_t& index);
    Error unknownOption(const std::string& name) const;

    std::vector<Option> options_;
    std::map<std::string, std::string> values_;
    std::map<std::string, std::vector<std::string>> lists_;  ///< of options with several values
    std::vector<std::string> operands_;
};

}  // namespace noctule::batch
