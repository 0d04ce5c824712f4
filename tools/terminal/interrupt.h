// Stopping well: SIGINT and SIGTERM set a flag that long work polls; a second one kills as usual.
#pragma once

#include <string>

namespace warplut {

// Installs the handlers. A write beyond the file size limit then fails like one to a full disk.
void InstallInterruptHandlers();

// Whether a signal asked the program to stop. Safe from any thread.
bool Interrupted();

// Throws an Error, "WORK was interrupted; CONSEQUENCE.", if so.
void ThrowIfInterrupted(const std::string& work, const std::string& consequence);

}  // namespace warplut
