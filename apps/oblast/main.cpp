// The program `oblast`.
#include "oblast/program.h"

int main(int argc, char** argv) { return oblast::app::run_program(argc, argv); }
