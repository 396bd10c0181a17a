// SPDX-License-Identifier: Apache-2.0
// Words and rows of a BVH text with their line numbers. Lines end with LF, CRLF or CR; words with blanks;
// braces and colons are words of their own. Views into the text, nothing is copied.
#pragma once

#include <cstddef>
#include <string_view>

namespace noctule {

class BvhScanner {
public:
    explicit BvhScanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    /// The line, from 1, of what was read last.
    size_t line() const { return line_; }
    size_t bytesLeft() const { return static_cast<size_t>(end_ - at_); }

    /// The next word; empty at the end of the text.
    std::string_view word();
    /// What stands before the end of this line or an opening brace; may be empty.
    std::string_view name();
    /// Whether the next word is `expected` in any case; only then it is consumed.
    bool accept(std::string_view expected);

    /// Skips blank lines; false when nothing else is left.
    bool toNextRow();
    /// The next word of this line, up to a blank or closing brace; empty at its end.
    std::string_view wordOfRow();
    bool atEnd() const { return at_ == end_; }

    /// For the inner loop over the numbers of a row: skips blanks, and whether the line ends here.
    bool atEndOfRow() {
        while (at_ != end_ && isBlank(*at_))
            ++at_;
        return at_ == end_ || isLineEnd(*at_);
    }
    const char* position() const { return at_; }
    const char* end() const { return end_; }
    void moveTo(const char* position) { at_ = position; }

    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

private:
    void skipSpace();

    const char* at_;
    const char* end_;
    size_t line_ = 1;
};

/// Equal but for upper and lower case (ASCII).
bool sameWord(std::string_view a, std::string_view b);

}  // namespace noctule
