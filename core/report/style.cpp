// SPDX-License-Identifier: Apache-2.0
#include "core/report/style.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace noctule {
namespace {

constexpr int kConfidenceSteps = 20;

using Rgb = std::array<int, 3>;
using Scale = std::array<Rgb, 5>;  // at 0, 0.25, 0.5, 0.75, 1

constexpr Scale kLightScale = {
    {{0xBC, 0xC3, 0xCD}, {0xCD, 0xA5, 0x63}, {0xAE, 0x77, 0x18}, {0x58, 0x69, 0x1A}, {0x06, 0x49, 0x36}}};
constexpr Scale kDarkScale = {
    {{0x43, 0x4C, 0x59}, {0x76, 0x64, 0x4A}, {0xB8, 0x83, 0x2F}, {0xC3, 0xBC, 0x62}, {0x7B, 0xE8, 0xB8}}};

/// Tokens by the studio's names; the paper's red for the second of two runs is the x axis' colour.
constexpr const char* kLightTokens =
    "--bg:#E4E8ED;--panel:#F6F7F9;--raised:#FFF;--line:#D0D6DF;--edge:#737E8D;--t1:#161B22;--t2:#414B58;"
    "--t3:#566070;--acc:#1E56C9;--onacc:#FFF;--sel:#D9E5FF;--ok:#0A6B4A;--warn:#8A5200;--err:#B3261E;--okbg:#"
    "DDF1E8;"
    "--warnbg:#FBEBD0;--errbg:#FBE1DE;--ref:#2B333F;--x:#B5432B;--y:#3E7A22;--z:#2C5FC4;--track:#E8EBF0;"
    "--purple:#7A3FA8;--teal:#0B7285;";
constexpr const char* kDarkTokens =
    "--bg:#0E1116;--panel:#151920;--raised:#1C222B;--line:#2A323E;--edge:#6F7B8D;--t1:#E9EDF2;--t2:#B0B9C6;"
    "--t3:#929DAD;--acc:#8FB4FF;--onacc:#0B1424;--sel:#22324F;--ok:#62D6A4;--warn:#F0B04A;--err:#FF8A80;--"
    "okbg:#17302A;"
    "--warnbg:#33291A;--errbg:#3A2022;--ref:#DDE3EC;--x:#F2836B;--y:#8CCB6E;--z:#7FA8FF;--track:#252C37;"
    "--purple:#C79BF0;--teal:#6CC7D8;";

constexpr const char* kPage = R"css(
*{box-sizing:border-box}
body{margin:0;overflow-wrap:break-word;background:var(--bg);color:var(--t1);font:13px/1.5 Roboto,"Segoe UI",system-ui,sans-serif;font-variant-numeric:tabular-nums}
main,header>div{max-width:1080px;margin:0 auto;padding:0 24px}
header{background:var(--panel);border-bottom:1px solid var(--line)}
header>div{display:flex;align-items:center;gap:12px;height:52px}
header .mark{width:26px;height:18px;fill:var(--acc)}
header strong{font-size:15px;font-weight:500}header .what{color:var(--t3);margin-left:auto}
nav{margin:16px 0 0;display:flex;flex-wrap:wrap;gap:4px 16px}
a{color:var(--acc);text-decoration:none}a:hover{text-decoration:underline}a:focus-visible{outline:2px solid var(--acc);outline-offset:2px;border-radius:2px}
h1{font-size:26px;font-weight:500;line-height:1.25;margin:0}
h2{font-size:20px;font-weight:500;margin:0 0 4px}
h3{font-size:15px;font-weight:500;margin:24px 0 4px}
details{border-top:1px solid var(--line);margin:16px 0 0}summary{cursor:pointer;padding:8px 0 0;font-size:15px;font-weight:500;color:var(--acc)}summary:focus-visible{outline:2px solid var(--acc);outline-offset:2px}
section>details:only-child{border:0;margin:0}section>details:only-child>summary{padding:0}
h1,h2,p,li,summary,header span{overflow-wrap:anywhere}
section{background:var(--panel);border:1px solid var(--line);border-radius:8px;padding:24px;margin:16px 0}
.lead,.note{color:var(--t2);max-width:640px;margin:0 0 16px}
.note{font-size:12px;color:var(--t3);margin:8px 0 0}
.nothing{color:var(--t3);margin:0}
.verdict{display:grid;grid-template-columns:auto 1fr;gap:4px 16px;align-items:center}
.verdict .badge{width:48px;height:48px;border-radius:24px;display:grid;place-items:center}
.verdict .badge .icon{width:24px;height:24px}
.verdict p{grid-column:2;color:var(--t2);margin:0;max-width:760px}
.ok{color:var(--ok)}.warn{color:var(--warn)}.err{color:var(--err)}.info{color:var(--t3)}
.badge.ok{background:var(--okbg)}.badge.warn{background:var(--warnbg)}.badge.err{background:var(--errbg)}.badge.info{background:var(--track)}
.icon{width:16px;height:16px;fill:none;stroke:currentColor;stroke-width:1.5;stroke-linecap:round;stroke-linejoin:round}
.cards{display:grid;grid-template-columns:repeat(4,1fr);gap:12px;margin:24px 0 0}
.card{background:var(--raised);border:1px solid var(--line);border-radius:8px;padding:12px 16px}
.card b{display:block;font-size:26px;font-weight:500;line-height:1.3}.card span{color:var(--t2);font-size:12px}
.problems{list-style:none;margin:16px 0 0;padding:0;display:grid;gap:8px}
.problems li{background:var(--raised);border:1px solid var(--line);border-left:3px solid var(--warn);border-radius:4px;padding:8px 12px;display:flex;gap:8px;align-items:flex-start}
.problems .icon{color:var(--warn);flex:none;margin-top:2px}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%}
caption{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
th,td{padding:4px 8px;text-align:right;border-bottom:1px solid var(--line);height:28px;font-weight:400;white-space:nowrap}
th{max-width:360px;overflow:hidden;text-overflow:ellipsis}
thead th{font-size:11px;color:var(--t3);vertical-align:bottom;white-space:normal}
thead .group{text-align:center;border-bottom-color:var(--edge)}
tbody th{color:var(--t1)}th:first-child,td:first-child,.word{text-align:left}
tr.shown>*{background:var(--sel)}tr.shown>th{font-weight:500}
tr.paper>*{color:var(--t3);font-size:12px;height:24px;border-bottom-color:var(--edge)}
tr.total>*{font-weight:500;border-top:1px solid var(--edge)}
td .bar{min-width:60px}.look{color:var(--warn)}
small{font-size:11px;color:var(--t3)}
dl{margin:0;display:grid;grid-template-columns:1fr 1fr;gap:0 32px}
dl>div{display:flex;justify-content:space-between;gap:16px;border-bottom:1px solid var(--line);padding:4px 0}
dt{color:var(--t2)}dd{margin:0;text-align:right;overflow-wrap:anywhere}
.statements{margin:0 0 16px;padding-left:18px;max-width:760px}.statements li{margin:4px 0}
.key{display:flex;flex-wrap:wrap;gap:4px 16px;color:var(--t2);font-size:12px;margin:12px 0 8px}
.key span{display:inline-flex;align-items:center;gap:6px}.key svg{width:12px;height:12px}
footer{color:var(--t3);font-size:12px;padding:8px 0 48px}
@media(max-width:760px){.cards,dl{grid-template-columns:1fr 1fr}dl{grid-template-columns:1fr}section{padding:16px}}
)css";

constexpr const char* kDrawings = R"css(
.plot{display:block;width:100%;min-width:640px;height:auto;margin:8px 0;font-size:11px}
.plot path{fill:none;stroke-width:1;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.plot text{fill:var(--t3)}.plot .head{fill:var(--t1);font-size:13px;font-weight:500}.plot .legend{fill:var(--t2)}
.plot .end{text-anchor:end}.plot .mid{text-anchor:middle}
.plot .grid{stroke:var(--line)}.plot .zero{stroke:var(--edge)}
.plot .estimate,.plot .run0{stroke:var(--acc)}.plot .reference{stroke:var(--ref);stroke-dasharray:4 3}
.plot .error,.plot .run1,.plot .x{stroke:var(--x)}.plot .y,.plot .run2{stroke:var(--y)}.plot .z{stroke:var(--z)}
.plot .run3{stroke:var(--purple)}.plot .run4{stroke:var(--warn)}.plot .run5{stroke:var(--teal)}.plot .run6{stroke:var(--t3)}
.plot .band{fill:var(--acc);fill-opacity:.2;stroke:none}
.plot .dot{stroke:var(--acc);stroke-width:2.5;stroke-linecap:round}
.plot .dot.rejected{stroke:var(--err);stroke-width:4}.plot .dot.unused{stroke:var(--edge)}.plot .dot.faint{stroke:var(--edge);stroke-width:1.5;stroke-opacity:.45}
.plot .group{stroke:var(--edge)}.plot .none{fill:none;stroke:var(--edge);stroke-dasharray:3 2}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(380px,100%),1fr));gap:0 24px}.pair .plot{min-width:0}
.used{fill:var(--acc)}.rejected{fill:var(--err)}.unused{fill:var(--edge)}.occluded{fill:var(--line)}.missing{fill:var(--warn)}
.good{fill:var(--ok)}.inertia{fill:var(--warn)}.alone{fill:var(--err)}.track{fill:var(--track)}
.bar{width:100%;height:8px;display:block;border-radius:4px;overflow:hidden}
@media print{body{background:#FFF}nav{display:none}section{break-inside:auto;border:0;padding:8px 0}.plot,tr,.card{break-inside:avoid}h2,h3{break-after:avoid}}
)css";

/// Linear in sRGB between the five given colours.
std::string scaleColour(const Scale& scale, double confidence) {
    const double position = 4 * std::clamp(confidence, 0.0, 1.0);
    const size_t below = std::min<size_t>(3, static_cast<size_t>(position));
    const double fraction = position - static_cast<double>(below);
    std::string colour = "#";
    for (size_t i = 0; i < 3; ++i) {
        const double value = (1 - fraction) * scale[below][i] + fraction * scale[below + 1][i];
        const auto byte = static_cast<size_t>(std::lround(value));
        colour += "0123456789ABCDEF"[byte / 16];
        colour += "0123456789ABCDEF"[byte % 16];
    }
    return colour;
}

std::string scaleRules(const Scale& scale) {
    std::string rules;
    for (int i = 0; i <= kConfidenceSteps; ++i)
        rules += ".c" + std::to_string(i) + "{fill:" + scaleColour(scale, 1.0 * i / kConfidenceSteps) + "}";
    return rules;
}

}  // namespace

std::string confidenceClass(double confidence) {
    const double bounded = std::isfinite(confidence) ? std::clamp(confidence, 0.0, 1.0) : 0;
    return "c" + std::to_string(std::lround(bounded * kConfidenceSteps));
}

std::string styleSheet() {
    return std::string(":root{color-scheme:light dark;") + kLightTokens + "}" + scaleRules(kLightScale) +
           "\n@media screen and (prefers-color-scheme:dark){:root{" + kDarkTokens + "}" +
           scaleRules(kDarkScale) + "}" + kPage + kDrawings;
}

}  // namespace noctule
