// Command lines that parse and still make no sense.
#pragma once

#include <string>

#include "datasets/error.h"

namespace warplut {

// Ends the program with ExitCode::kUsage.
class UsageError : public Error {
 public:
  using Error::Error;
};

// check(), whose Errors mean that the command line is wrong.
template <class Check>
auto AsUsage(const Check& check) {
  try {
    return check();
  } catch (const UsageError&) {
    throw;
  } catch (const Error& wrong) {
    throw UsageError(wrong.what());
  }
}

// Throws UsageError unless `valid`; `why` is the sentence.
inline void RequireUsage(bool valid, const std::string& why) {
  if (!valid) throw UsageError(why);
}

}  // namespace warplut
