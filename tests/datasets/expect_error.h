// An Error whose sentence has all of the given pieces.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "datasets/error.h"

namespace warplut {

template <class Action>
void ExpectError(const Action& action, std::initializer_list<std::string> pieces) {
  try {
    action();
    ADD_FAILURE() << "no Error";
  } catch (const Error& e) {
    const std::string sentence = e.what();
    for (const std::string& piece : pieces) EXPECT_THAT(sentence, testing::HasSubstr(piece));
    EXPECT_THAT(sentence, testing::Not(testing::HasSubstr("\n")));
  }
}

}  // namespace warplut
