#include "tools/view/view_request.h"

#include <fmt/format.h>

#include "datasets/error.h"

namespace warplut {
namespace {

// An Error says why the request makes no sense.
void Check(const ViewRequest& request) {
  const bool of_sequence = !request.sequence.empty();
  if (of_sequence != request.folders.empty()) {
    throw Error("it is not clear what to view; expected --sequence FILE or two folders");
  }
  if (!of_sequence && request.folders.size() != 2) {
    throw Error(fmt::format("{} folder is given; expected two", request.folders.size()));
  }
  if (of_sequence && !request.reference.empty()) {
    throw Error("--reference is for folders; the references of a sequence are its own");
  }
  if (of_sequence) {
    if (request.methods.size() != 2 || request.methods[0] == request.methods[1]) {
      throw Error("--modes does not name two methods; expected two that differ, as sr,bilinear");
    }
    for (const std::string& name : request.methods) MethodOf(name);
    CheckDevice(request.device);
    CheckArguments(request.pipeline);
  }
  if (request.shown < 1 || request.shown > kMostShown) {
    throw Error(fmt::format("--shown is {}; expected 1 to {}", request.shown, kMostShown));
  }
  if (!(request.amplify >= 1 && request.amplify <= kMostAmplify)) {
    throw Error(fmt::format("--amplify is {}; expected 1 to {}", request.amplify, kMostAmplify));
  }
  if (!(request.rate >= 1 && request.rate <= kMostRate)) {
    throw Error(fmt::format("--rate is {}; expected 1 to {}", request.rate, kMostRate));
  }
}

}  // namespace

bool ViewRequest::IsValid(std::string* why) const {
  try {
    Check(*this);
  } catch (const Error& wrong) {
    if (why != nullptr) *why = wrong.what();
    return false;
  }
  return true;
}

}  // namespace warplut
