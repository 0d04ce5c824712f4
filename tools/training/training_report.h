// What a training found, as text for people and as JSON for programs.
#pragma once

#include <string>

#include "tools/tables/record_table.h"
#include "train/fit/trainer.h"

namespace warplut {

// `out` is the file of the fit; `tone_mapped` counts the images that were linear.
Json ToJson(const TrainResult& result, int tone_mapped, const std::string& out);

// Sentences, and a table of the validation where there is one.
std::string ToText(const TrainResult& result, const std::string& out);

}  // namespace warplut
