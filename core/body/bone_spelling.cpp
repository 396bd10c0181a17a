// SPDX-License-Identifier: Apache-2.0
#include "core/body/bone_spelling.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

namespace noctule {
namespace {

constexpr std::array kRoleNames = {"Hips",    "Spine", "Chest", "Neck", "Head", "Shoulder", "Arm",
                                   "ForeArm", "Hand",  "UpLeg", "Leg",  "Foot", "ToeBase"};

struct SpellingRow {
    JointRole role;
    double score;
    const char* names;
};

/// One name may stand in several rows: a "shoulder" is a clavicle or the upper arm, a "leg" the thigh or the
/// shin, a "foot" below an ankle is the toes. The chain that explains most bones decides.
constexpr SpellingRow kSpellingRows[] = {
    {JointRole::kHips, 3, "hips pelvis spinebase"},
    {JointRole::kHips, 2.5, "hip lowertorso 腰"},
    {JointRole::kHips, 2, "cog center センター lowerbody 下半身"},
    {JointRole::kHips, 1, "root bip01 bip001 bip"},
    {JointRole::kHips, 0.5, "spine"},
    {JointRole::kNeck, 3, "neck neck01 necklower lowerneck 首"},
    {JointRole::kNeck, 2.8, "neck0 neck1 neckbase"},
    {JointRole::kNeck, 1, "spine004"},
    {JointRole::kHead, 3, "head head1 skull 頭"},
    {JointRole::kHead, 1.2, "spine006"},
    {JointRole::kHead, 1, "spine005"},
    {JointRole::kShoulder, 3, "clavicle clav collar collarbone scapula 肩"},
    {JointRole::kShoulder, 1, "shoulder"},
    {JointRole::kArm, 3, "arm upperarm uparm uarm armupper humerus shldr shldrbend upperarm01 bicep 腕"},
    {JointRole::kArm, 1.5, "shoulder"},
    {JointRole::kForeArm, 3,
     "forearm lowerarm lowarm loarm farm armlower elbow radius ulna forearmbend lowerarm01 ひじ 肘"},
    {JointRole::kHand, 3.1, "wrist 手首"},
    {JointRole::kHand, 3, "hand"},
    {JointRole::kUpLeg, 3, "thigh upleg upperleg uleg legupper femur thighbend upperleg01 足 太もも"},
    {JointRole::kUpLeg, 2.9, "足d"},
    {JointRole::kUpLeg, 2, "hip leg"},
    {JointRole::kLeg, 3, "shin calf knee tibia lowerleg lowleg loleg leglower lowerleg01 ひざ 膝"},
    {JointRole::kLeg, 2.9, "ひざd"},
    {JointRole::kLeg, 2.1, "leg"},
    {JointRole::kFoot, 3.1, "ankle 足首"},
    {JointRole::kFoot, 3, "foot talus"},
    {JointRole::kFoot, 2.9, "足首d"},
    {JointRole::kToeBase, 3, "toebase toe toes toe0 ball toe11 つま先 足先 足先ex"},
    {JointRole::kToeBase, 2.5, "toe1 metatarsals"},
    {JointRole::kToeBase, 2, "foot"},
};

/// Names of vertebrae besides those that are a word of kNumberedVertebrae and a number.
constexpr std::pair<const char*, double> kVertebrae[] = {
    {"ab", 1},         {"abdomen", 1},    {"abdomenlower", 1},  {"l5", 1},         {"lowerback", 1},
    {"torso", 1.5},    {"waist", 1},      {"spine", 2},         {"belly", 2.5},    {"spinemid", 3},
    {"spinenavel", 3}, {"l3", 3},         {"abdomenupper", 3},  {"upperback", 4},  {"t12", 4},
    {"chest", 5},      {"chestlower", 5}, {"thorax", 6},        {"spinechest", 6}, {"t8", 6},
    {"upperchest", 7}, {"chestupper", 7}, {"spineshoulder", 7}, {"upperbody", 2},  {"上半身", 2}};

constexpr std::pair<const char*, double> kNumberedVertebrae[] = {
    {"spine", 2}, {"abdomen", 1}, {"chest", 5}, {"upperbody", 2}, {"上半身", 2}};

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isNumber(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

bool isCapital(char c) {
    return c >= 'A' && c <= 'Z';
}

/// Letters and digits of all scripts; separators are those of ASCII.
bool isOfWord(char c) {
    return static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c));
}

std::string inSmallLetters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return isCapital(c) ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

/// The digits of Japanese fonts as those of ASCII, the ideographic blank as a blank.
std::string withPlainDigits(const std::string& name) {
    std::string plain;
    for (size_t i = 0; i < name.size(); ++i) {
        const std::string_view three = std::string_view(name).substr(i, 3);
        const bool wide =
            three.size() == 3 && three.starts_with("\xEF\xBC") && three[2] >= '\x90' && three[2] <= '\x99';
        if (wide || three == "\xE3\x80\x80") {
            plain += wide ? static_cast<char>('0' + (three[2] - '\x90')) : ' ';
            i += 2;
        } else {
            plain += name[i];
        }
    }
    return plain;
}

/// Without "mixamorig" or "mixamorig12" before it: some programs drop the colon.
std::string withoutMixamo(const std::string& word) {
    constexpr std::string_view kMixamo = "mixamorig";
    if (!inSmallLetters(word).starts_with(kMixamo))
        return word;
    size_t from = kMixamo.size();
    while (from < word.size() && isDigit(word[from]))
        ++from;
    return word.substr(from);
}

/// "mixamorig:LeftUp_Leg.001" -> LeftUp, Leg, 001
std::vector<std::string> wordsOf(const std::string& name) {
    std::vector<std::string> words(1);
    for (const char c : withPlainDigits(name.substr(name.find_last_of(":|") + 1))) {
        if (isOfWord(c))
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    words.front() = withoutMixamo(words.front());
    std::erase(words, std::string());
    return words;
}

/// Where a capital begins a word: "LeftForeArm" -> Left, Fore, Arm; "LHipJoint" -> L, Hip, Joint; "LUArm" ->
/// L, U, Arm. Words in capitals alone stay whole.
std::vector<std::string> partsOf(const std::string& word) {
    if (std::none_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; }))
        return {word};
    std::vector<std::string> parts(1);
    for (size_t i = 0; i < word.size(); ++i) {
        const bool after_small = i > 0 && !isCapital(word[i - 1]);
        const bool before_small = i + 1 < word.size() && word[i + 1] >= 'a' && word[i + 1] <= 'z';
        const bool after_side = i == 1 && (word[0] == 'L' || word[0] == 'R');
        if (i > 0 && isCapital(word[i]) && (after_small || before_small || after_side))
            parts.emplace_back();
        parts.back() += word[i];
    }
    return parts;
}

const std::map<std::string, std::vector<RoleReading>>& readingsOfName() {
    static const auto table = [] {
        std::map<std::string, std::vector<RoleReading>> made;
        for (const SpellingRow& row : kSpellingRows) {
            std::istringstream names(row.names);
            for (std::string name; names >> name;)
                made[name].push_back({row.role, row.score});
        }
        return made;
    }();
    return table;
}

bool hasSides(JointRole role) {
    return role >= JointRole::kShoulder;
}

std::vector<RoleReading> readingsOf(const std::string& base, bool sided) {
    const auto found = readingsOfName().find(base);
    std::vector<RoleReading> readings =
        found == readingsOfName().end() ? std::vector<RoleReading>() : found->second;
    std::erase_if(readings, [&](const RoleReading& reading) { return hasSides(reading.role) != sided; });
    return readings;
}

std::optional<double> vertebraOf(const std::string& base) {
    for (const auto& [name, place] : kVertebrae)
        if (base == name)
            return place;
    for (const auto& [name, place] : kNumberedVertebrae) {
        const std::string number = base.substr(std::min(base.size(), std::string_view(name).size()));
        if (base.starts_with(name) && isNumber(number) && number.size() <= 3)
            return place + 0.01 * std::stod(number);
    }
    return std::nullopt;
}

/// A side as a word of its own, before or after the rest without a separator, or as the letter before it.
class SpelledName {
public:
    explicit SpelledName(const std::vector<std::string>& words) {
        for (const std::string& word : words)
            for (const std::string& part : partsOf(word))
                add(inSmallLetters(part));
        if (made_.side == BodySide::kMiddle)
            findSideInBase();
        look();
        if (made_.side == BodySide::kMiddle && !made_.isKnown())
            tryLetter();
    }
    const BoneSpelling& made() const { return made_; }

private:
    struct SideMark {
        const char* mark;
        BodySide side;
    };

    void add(const std::string& part) {
        static const std::map<std::string, BodySide> sides = {{"l", BodySide::kLeft},
                                                              {"left", BodySide::kLeft},
                                                              {"r", BodySide::kRight},
                                                              {"right", BodySide::kRight}};
        const auto side = sides.find(part);
        if (made_.side == BodySide::kMiddle && side != sides.end())
            made_.side = side->second;
        else
            made_.base += part;
    }

    void findSideInBase() {
        constexpr SideMark kMarks[] = {{"left", BodySide::kLeft},
                                       {"right", BodySide::kRight},
                                       {"左", BodySide::kLeft},
                                       {"右", BodySide::kRight}};
        for (const auto& [mark, side] : kMarks) {
            const size_t length = std::string_view(mark).size();
            if (made_.base.size() <= length)
                continue;
            if (made_.base.starts_with(mark))
                made_.base.erase(0, length);
            else if (made_.base.ends_with(mark))
                made_.base.erase(made_.base.size() - length);
            else
                continue;
            made_.side = side;
            return;
        }
    }

    void look() {
        made_.readings = readingsOf(made_.base, made_.side != BodySide::kMiddle);
        if (made_.side == BodySide::kMiddle)
            made_.vertebra = vertebraOf(made_.base);
    }

    /// Poser's small letters and ASF: "lshldr", "rfemur".
    void tryLetter() {
        const char first = made_.base.empty() ? ' ' : made_.base.front();
        if (first != 'l' && first != 'r')
            return;
        const std::string rest = made_.base.substr(1);
        auto readings = readingsOf(rest, true);
        if (readings.empty())
            return;
        made_.base = rest;
        made_.side = first == 'l' ? BodySide::kLeft : BodySide::kRight;
        made_.readings = std::move(readings);
    }

    BoneSpelling made_;
};

/// With a number behind it that a program added to a copy or to every bone: "Hips_01", "LeftArm.001".
BoneSpelling copyOf(std::vector<std::string> words) {
    constexpr double kLessSure = 0.8;
    if (words.size() < 2 || !isNumber(words.back()))
        return {};
    words.pop_back();
    BoneSpelling copy = SpelledName(words).made();
    for (RoleReading& reading : copy.readings)
        reading.score *= kLessSure;
    return copy;
}

/// Words that make a helper of what follows them.
bool isHelperWord(const std::string& word) {
    static const std::set<std::string> words = {"ik",     "fk",    "mch",    "ctrl", "control", "twist",
                                                "target", "pole",  "sec",    "adj",  "phys",    "skirt",
                                                "hair",   "cloth", "tweak",  "vis",  "wgt",     "dummy",
                                                "helper", "roll",  "offset", "end",  "coat",    "sleeve"};
    return words.contains(word);
}

bool isSideWord(const std::string& word) {
    return word == "l" || word == "r" || word == "left" || word == "right";
}

bool isKnownPrefixWord(const std::string& word) {
    static const std::set<std::string> words = {"def", "org", "bip01", "bip001",
                                                "bip", "j",   "c",     "valvebiped"};
    return words.contains(word);
}

/// As the words stand, and without up to three before them.
BoneSpelling withoutPrefix(std::vector<std::string> words) {
    constexpr size_t kMostPrefixWords = 3;
    std::string prefix;
    for (size_t dropped = 0; !words.empty() && dropped <= kMostPrefixWords; ++dropped) {
        for (BoneSpelling spelling : {SpelledName(words).made(), copyOf(words)})
            if (spelling.isKnown()) {
                spelling.prefix = prefix;
                return spelling;
            }
        const std::string word = inSmallLetters(words.front());
        if (isHelperWord(word) || isSideWord(word) || words.size() < 2)
            break;  // with a side before it "L_Sleeve_Hand" is no hand
        prefix += (prefix.empty() ? "" : " ") + word;
        words.erase(words.begin());
    }
    return {};
}

/// Behind the name it says whose bone it is, not that the bone only helps: clothes with an armature of their
/// own.
bool isGarmentWord(const std::string& word) {
    return word == "cloth" || word == "coat";
}

/// Without a word behind it that a whole body carries: "Hips_jnt", "LeftArm_cloth".
BoneSpelling withoutLastWord(std::vector<std::string> words) {
    const std::string last = words.empty() ? std::string() : inSmallLetters(words.back());
    if (words.size() < 2 || isNumber(last) || isSideWord(last) ||
        (isHelperWord(last) && !isGarmentWord(last)))
        return {};
    words.pop_back();
    BoneSpelling spelling = withoutPrefix(words);
    spelling.prefix += "..." + last;
    return spelling;
}

}  // namespace

std::string canonicalJoint(JointRole role, BodySide side) {
    const std::string name = kRoleNames[static_cast<size_t>(role)];
    return (side == BodySide::kLeft ? "Left" : side == BodySide::kRight ? "Right" : "") + name;
}

bool isKnownPrefix(const std::string& prefix) {
    std::istringstream words(prefix);
    for (std::string word; words >> word;)
        if (!isKnownPrefixWord(word))
            return false;
    return true;
}

BoneSpelling spellingOf(const std::string& name) {
    if (name.starts_with("__"))  // MakeHuman's helper joints repeat the name of the real one
        return {};
    const std::vector<std::string> words = wordsOf(name);
    BoneSpelling spelling = withoutPrefix(words);
    return spelling.isKnown() ? spelling : withoutLastWord(words);
}

}  // namespace noctule
