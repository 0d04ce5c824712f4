// A command line as data: what completions of shells and manual pages are made from.
#pragma once

#include <string>
#include <vector>

namespace warplut {

struct OptionDescription {
  std::vector<std::string> names;  // "--lut", "-h"; a positional has its name without hyphens
  std::string help;
  std::string default_value;         // as the help shows it; empty: it shows none
  std::vector<std::string> choices;  // of each value; empty: anything
  bool positional = false;
  bool takes_value = false;  // else a flag
  bool several = false;      // takes more than one value
  bool separated = false;    // by commas
  bool number = false;       // its values are numbers
  bool required = false;
};

struct CommandDescription {
  std::string name;
  std::string help;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
};

}  // namespace warplut
