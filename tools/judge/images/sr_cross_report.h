// The cross table as text for people and as JSON for programs.
#pragma once

#include <vector>

#include "tools/judge/images/sr_cross.h"
#include "tools/tables/record_table.h"
#include "tools/tables/table_text.h"

namespace warplut {

// Rows are filters, columns factors.
TextTable LossTable(const std::vector<CrossFilter>& filters,
                    const std::vector<CrossColumn>& columns);

// Rows are filters, columns the protocols of one factor.
TextTable SsimTable(const std::vector<CrossFilter>& filters, const CrossColumn& column);

Json ToJson(const std::vector<CrossFilter>& filters, const std::vector<CrossColumn>& columns);

}  // namespace warplut
