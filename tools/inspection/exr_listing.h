// The contents of an image file, as streams that a manifest could name.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace warplut {

// Whether `path` is a file that `dataset inspect` lists and does not take for a manifest.
bool IsImageToList(const std::filesystem::path& path);

// Parts, channels and types of the file, and a stream for each group of channels that looks like
// one: "color" for R, G, B, "depth" for Z, "motion" for X, Y or for a vector. Errors as ReadParts.
nlohmann::ordered_json ExrListing(const std::filesystem::path& path);
std::string ExrListingText(const nlohmann::ordered_json& listing);

}  // namespace warplut
