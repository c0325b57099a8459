// Part of the editor where it is built with sanitizers: what was loaded stays, so that memory which drivers of OpenGL have left
// behind is still reachable through them when leaks are looked for, and frames in them have names.

extern "C" int dlclose(void*) { return 0; }
