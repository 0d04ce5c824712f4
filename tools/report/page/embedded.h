// Files that are part of the program (warplut_embed in CMakeLists.txt): the report needs nothing
// but itself.
#pragma once

#include <string_view>

namespace warplut::embedded {

extern const std::string_view kPageStyle;    // page.css
extern const std::string_view kPageScript;   // page.js
extern const std::string_view kViewStyle;    // tools/view/view.css
extern const std::string_view kViewScript;   // tools/view/view.js
extern const std::string_view kWarpFit;      // luts/fits/warplut_x2.json
extern const std::string_view kPipelineFit;  // luts/fits/warplut_sr_x2.json

}  // namespace warplut::embedded
