#include "tools/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

#include "tools/commands/command.h"

namespace warplut {
namespace {

// The values between the braces of "TEXT:{a,b}", as the help shows a choice.
std::vector<std::string> ChoicesOf(const std::string& type) {
  const auto open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionDescription DescriptionOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  OptionDescription description;
  description.positional = option.get_positional();
  if (description.positional) {
    description.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) description.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) description.names.push_back("--" + name);
  }
  description.help = option.get_description();
  description.default_value = option.get_default_str();
  description.takes_value = option.get_items_expected_max() > 0;
  description.several = option.get_items_expected_max() > 1;
  description.separated = option.get_delimiter() != '\0';
  description.required = option.get_required();
  if (!description.takes_value) return description;
  description.choices = ChoicesOf(type);
  for (const char* number : {"INT", "UINT", "FLOAT"}) {
    if (type.starts_with(number)) description.number = true;
  }
  return description;
}

CommandDescription DescriptionOf(const CLI::App& app) {
  CommandDescription description{
      .name = app.get_name(), .help = app.get_description(), .options = {}, .commands = {}};
  for (const CLI::Option* option : app.get_options()) {
    description.options.push_back(DescriptionOf(*option));
  }
  for (const CLI::App* below : app.get_subcommands({})) {
    description.commands.push_back(DescriptionOf(*below));
  }
  return description;
}

}  // namespace

CommandOption& CommandOption::Required() {
  option_->required();
  return *this;
}

CommandOption& CommandOption::ShowDefault() {
  option_->capture_default_str();
  return *this;
}

CommandOption& CommandOption::Separated() {
  option_->delimiter(',');
  return *this;
}

CommandOption& CommandOption::OneOf(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  return *this;
}

CommandOption& CommandOption::Within(int least, int greatest) {
  option_->check(CLI::Range(least, greatest));
  return *this;
}

CommandOption& CommandOption::NotNegative() {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

CommandOption& CommandOption::Excludes(const CommandOption& other) {
  option_->excludes(other.option_);
  return *this;
}

CommandOption& CommandOption::Needs(const CommandOption& other) {
  option_->needs(other.option_);
  return *this;
}

Command Command::AddCommand(const std::string& name, const std::string& help) {
  app_->require_subcommand(0, 1);
  return Command(app_->add_subcommand(name, help));
}

template <class T>
CommandOption Command::Add(const std::string& name, T& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

template CommandOption Command::Add(const std::string&, std::string&, const std::string&);
template CommandOption Command::Add(const std::string&, std::filesystem::path&, const std::string&);
template CommandOption Command::Add(const std::string&, int&, const std::string&);
template CommandOption Command::Add(const std::string&, std::uint64_t&, const std::string&);
template CommandOption Command::Add(const std::string&, float&, const std::string&);
template CommandOption Command::Add(const std::string&, double&, const std::string&);
template CommandOption Command::Add(const std::string&, std::optional<double>&, const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<std::string>&,
                                    const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<int>&, const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<float>&, const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<double>&, const std::string&);

CommandOption Command::AddFlag(const std::string& name, bool& value, const std::string& help) {
  return CommandOption(app_->add_flag(name, value, help));
}

void Command::OnParsed(std::function<void()> then) { app_->callback(std::move(then)); }

bool Command::Given(const std::string& name) const { return app_->count(name) > 0; }

CommandDescription Command::Describe() const { return DescriptionOf(*app_); }

CommandLine::CommandLine(const std::string& name, const std::string& help,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)) {
  app_->set_version_flag("--version", name + " " + version);
}

CommandLine::~CommandLine() = default;

bool CommandLine::Parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    app_->exit(asked);
    return false;
  } catch (const CLI::ParseError& wrong) {
    // An option that there is not explains most of what else is wrong: its value is taken for
    // something else.
    for (const std::string& rest : app_->remaining(true)) {
      if (rest.size() > 1 && rest.front() == '-') throw UsageError(rest + " is not an option here");
    }
    throw UsageError(wrong.what());
  }
  return true;
}

}  // namespace warplut
