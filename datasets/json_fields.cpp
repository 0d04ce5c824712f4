#include "datasets/json_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "datasets/file.h"

namespace warplut {

using nlohmann::json;

json ParseJson(const std::string& text, const std::string& file) {
  std::vector<std::set<std::string>> fields;  // of the objects that are open
  std::string last;                           // field that was begun
  const auto refuse_number = [&](const std::string& number) {
    throw Error(
        fmt::format("'{}': field '{}' is {}; expected a number of at most {:g}, as all "
                    "numbers of a file",
                    file, last, number, kMaxJsonNumber));
  };
  const auto check = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth >= kMaxJsonDepth &&
        (event == json::parse_event_t::object_start || event == json::parse_event_t::array_start)) {
      throw Error(fmt::format("'{}' has objects or arrays nested more than {} deep; expected fewer",
                              file, kMaxJsonDepth));
    }
    if (event == json::parse_event_t::object_start) {
      fields.emplace_back();
    } else if (event == json::parse_event_t::object_end) {
      fields.pop_back();
    } else if (event == json::parse_event_t::key) {
      const auto name = parsed.get<std::string>();
      if (!fields.back().insert(name).second) {
        throw Error(fmt::format("'{}': field '{}' is there twice in one object; expected once",
                                file, name));
      }
      last = name;
    } else if (event == json::parse_event_t::value && parsed.is_number_float() &&
               !(std::abs(parsed.get<double>()) <= kMaxJsonNumber)) {
      refuse_number(fmt::format("{:g}", parsed.get<double>()));
    }
    return true;
  };
  try {
    return json::parse(text, check);
  } catch (const json::out_of_range&) {  // the one of a parser: a number that no double holds
    refuse_number("too large for a double");
  } catch (const json::exception& e) {
    throw Error(fmt::format("'{}' is not JSON: {}", file, e.what()));
  }
  return {};
}

json ReadJson(const std::filesystem::path& path, std::size_t max_bytes) {
  return ParseJson(ReadFile(path, max_bytes), path.string());
}

std::string JsonText(const json& value, int indent) {
  return value.dump(indent, ' ', false, json::error_handler_t::replace);
}

std::string JsonText(const nlohmann::ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string RecordedName(const std::string& name) {
  constexpr const char* kReplacement = "\xEF\xBF\xBD";
  std::string line;
  for (const char c : json::parse(JsonText(json(name))).get<std::string>()) {
    if (static_cast<unsigned char>(c) < 32 || c == 127) {
      line += kReplacement;
    } else {
      line += c;
    }
  }
  return line;
}

double Decimal(float value) { return std::stod(fmt::format("{}", value)); }

JsonPlace JsonPlace::Field(const std::string& name) const {
  return {file_, field_.empty() ? name : field_ + "." + name};
}

JsonPlace JsonPlace::Element(std::size_t index) const {
  return {file_, fmt::format("{}[{}]", field_, index)};
}

void JsonPlace::Refuse(const json& found, const std::string& expected) const {
  constexpr std::size_t kLongest = 60;
  std::string text = found.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  Fail(fmt::format("is {}; expected {}", text, expected));
}

void JsonPlace::Fail(const std::string& sentence) const {
  if (field_.empty()) throw Error(fmt::format("'{}': the whole {}", file_, sentence));
  throw Error(fmt::format("'{}': field '{}' {}", file_, field_, sentence));
}

double JsonPlace::Number(const json& value) const {
  if (!value.is_number()) Refuse(value, "a number");
  return value.get<double>();
}

int JsonPlace::Integer(const json& value) const {
  constexpr auto kMax = std::numeric_limits<int>::max();
  if (value.is_number_float()) {  // programs that know one kind of number write 480.0
    const double number = value.get<double>();
    if (std::trunc(number) == number && std::abs(number) <= kMax) return static_cast<int>(number);
  }
  if (!value.is_number_integer()) Refuse(value, "a whole number");
  if (value.is_number_unsigned() ? value.get<std::uint64_t>() > kMax
                                 : value.get<std::int64_t>() < -std::int64_t{kMax}) {
    Refuse(value, fmt::format("a whole number of at most {}", kMax));
  }
  return value.get<int>();
}

std::string JsonPlace::Text(const json& value) const {
  if (!value.is_string()) Refuse(value, "a text in quotes");
  return value.get<std::string>();
}

const json& JsonPlace::Array(const json& value, std::size_t length) const {
  if (!value.is_array())
    Refuse(value, length ? fmt::format("{} values in [ ]", length) : "values in [ ]");
  if (length != 0 && value.size() != length) {
    Fail(fmt::format("has {} values; expected {}", value.size(), length));
  }
  return value;
}

JsonFields::JsonFields(const json& object, JsonPlace place)
    : object_(&object), place_(std::move(place)) {
  if (!object.is_object()) place_.Refuse(object, "an object in { }");
}

const json& JsonFields::Take(const char* name) {
  const auto at = object_->find(name);
  if (at == object_->end()) At(name).Fail("is missing");
  taken_.insert(name);
  return *at;
}

void JsonFields::Finish() const {
  for (const auto& [name, value] : object_->items()) {
    if (!taken_.contains(name)) place_.Field(name).Fail("is unknown; expected none of that name");
  }
}

}  // namespace warplut
