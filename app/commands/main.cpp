#include "app/commands/program.h"

int main(int argc, char** argv) {
  return prairie::run_program(argc, argv);
}
