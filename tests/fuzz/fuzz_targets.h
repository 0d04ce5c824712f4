// The targets of fuzzing: readers of files and of the command line, on any bytes.
//
// libFuzzer runs each as a program (fuzz_main.cpp, preset `fuzz`), and GoogleTest on every file of
// its corpus (corpus_test.cpp), so that a crash that was found stays a test.
#pragma once

#include <string_view>

namespace warplut {

// Reads `bytes` as a file of the target's kind. Whether they were accepted; if not, the reader
// threw an Error with a sentence. An accepted value is written and read back to the same text.
// Anything else (another exception, a crash, another text) is a fault: it ends the program.
using FuzzBody = bool (*)(std::string_view bytes);

bool FuzzManifest(std::string_view bytes);    // sequence.json
bool FuzzFit(std::string_view bytes);         // fit, and the table that it quantises to
bool FuzzParameters(std::string_view bytes);  // PARAMS.json
bool FuzzTableJson(std::string_view bytes);   // baked table
bool FuzzTableExr(std::string_view bytes);    // table in the released layout
bool FuzzPackedPng(std::string_view bytes);   // depth and motion, packed into RGBA8
bool FuzzMotion(std::string_view bytes);      // .flo; else OpenEXR or PNG, as the bytes begin
bool FuzzImage(std::string_view bytes);       // colour: OpenEXR or PNG, as the bytes begin
// The command line, one argument a line, parsed alone: no command runs. Accepted if a command would
// run. It needs the whole program and so is no part of kFuzzTargets.
bool FuzzCommandLine(std::string_view bytes);

struct FuzzTarget {
  const char* name;  // of its corpus and its program, fuzz_NAME
  FuzzBody body;
};

inline constexpr FuzzTarget kFuzzTargets[] = {
    {"manifest", FuzzManifest},     {"fit", FuzzFit},
    {"parameters", FuzzParameters}, {"table_json", FuzzTableJson},
    {"table_exr", FuzzTableExr},    {"packed_png", FuzzPackedPng},
    {"motion", FuzzMotion},         {"image", FuzzImage},
};

}  // namespace warplut
