// A report on disk.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "tools/report/page/page.h"
#include "tools/report/report_section.h"

namespace warplut {

// Writes, each file atomically and the page last:
//   index.html       the page (page.h)
//   report.json      everything that the tables, plots and sentences say
//   tables/ID.md     the tables, for tools/measure/update_tables.sh
//   plots/ID.svg     the plots, wide
//   pictures/*.png   the pictures
// A plot that cannot be drawn becomes a failure of its section. `on_file` is called before each
// plot and picture, and may throw, which leaves an old page as it was. An Error names the file that
// could not be written.
void WriteReport(const std::filesystem::path& folder, const PageHead& head,
                 std::vector<ReportSection> sections, const std::function<void()>& on_file);

}  // namespace warplut
