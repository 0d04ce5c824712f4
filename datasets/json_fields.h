// JSON that people wrote by hand, read without guessing: each field once, none missing, none
// unknown.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "datasets/error.h"

namespace warplut {

// The bounds of every JSON file that is read.
//   kMaxJsonDepth    objects and arrays inside each other: what walks a parsed value recurses
//   kMaxJsonBytes    of a file; manifests, which may name cameras for every frame, and checkpoints
//                    may have more
//   kMaxJsonNumber   the largest magnitude of a number: as a float it is finite, as a double its
//                    square too
inline constexpr int kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxJsonBytes = std::size_t{16} << 20;
inline constexpr std::size_t kMaxManifestBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMaxCheckpointBytes = std::size_t{1} << 30;
inline constexpr double kMaxJsonNumber = std::numeric_limits<float>::max();

// Parses `text`; an Error names `file` where it is not JSON, is nested deeper than kMaxJsonDepth,
// has a number beyond kMaxJsonNumber, or an object has a field twice.
nlohmann::json ParseJson(const std::string& text, const std::string& file);

// ParseJson of a file of at most `max_bytes`. An Error names it.
nlohmann::json ReadJson(const std::filesystem::path& path, std::size_t max_bytes = kMaxJsonBytes);

// The text of a JSON value, always UTF-8: bytes of a text that are not (names of files can hold
// any) become U+FFFD. `indent`: spaces of a level; -1: all on one line.
std::string JsonText(const nlohmann::json& json, int indent = -1);
std::string JsonText(const nlohmann::ordered_json& json, int indent = -1);

// A name as it can be recorded: valid UTF-8 on one line. Other bytes, and control characters,
// become U+FFFD.
std::string RecordedName(const std::string& name);

// The decimal number that a float's shortest text stands for: a file then shows 0.7.
double Decimal(float value);

// Where in a file a value is: "'FILE': field 'a.b'".
class JsonPlace {
 public:
  JsonPlace(std::string file, std::string field)
      : file_(std::move(file)), field_(std::move(field)) {}

  JsonPlace Field(const std::string& name) const;
  JsonPlace Element(std::size_t index) const;

  // Throws the Error "FILE: field 'a.b' is FOUND; expected EXPECTED", FOUND shortened.
  [[noreturn]] void Refuse(const nlohmann::json& found, const std::string& expected) const;
  // Throws the Error "FILE: field 'a.b' SENTENCE".
  [[noreturn]] void Fail(const std::string& sentence) const;

  double Number(const nlohmann::json& value) const;  // finite
  int Integer(const nlohmann::json& value) const;
  std::string Text(const nlohmann::json& value) const;
  // An array of `length` values, or of any number if 0.
  const nlohmann::json& Array(const nlohmann::json& value, std::size_t length = 0) const;

 private:
  std::string file_;
  std::string field_;
};

// One object. Fields are taken by name; Finish refuses those that were not.
class JsonFields {
 public:
  JsonFields(const nlohmann::json& object, JsonPlace place);

  bool Has(const char* name) const { return object_->contains(name); }
  // An Error says so where it is missing.
  const nlohmann::json& Take(const char* name);
  JsonPlace At(const char* name) const { return place_.Field(name); }

  double Number(const char* name) { return At(name).Number(Take(name)); }
  int Integer(const char* name) { return At(name).Integer(Take(name)); }
  std::string Text(const char* name) { return At(name).Text(Take(name)); }
  JsonFields Object(const char* name) { return JsonFields(Take(name), At(name)); }

  // The value of the pair whose name the field holds.
  template <class Names>
  auto OneOf(const char* name, const Names& names) {
    const std::string text = Text(name);
    std::string expected;
    for (const auto& [value, value_name] : names) {
      if (text == value_name) return value;
      expected += (expected.empty() ? "" : " or ") + std::string(value_name);
    }
    At(name).Refuse(text, expected);
  }

  void Finish() const;

 private:
  const nlohmann::json* object_;
  JsonPlace place_;
  std::set<std::string> taken_;
};

}  // namespace warplut
