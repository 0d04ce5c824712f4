# Writes the file TEXT as the string NAME of the C++ header OUT.
file(READ ${TEXT} text)
file(WRITE ${OUT} "const char ${NAME}[] = R\"glsl(${text})glsl\";\n")
