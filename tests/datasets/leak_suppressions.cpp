// OpenImageIO 2.4's PNG reader loses the text of its message when libpng jumps out of it at a
// truncated file.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:ImageInput::geterror\n"; }
