// Reads expressions, one a line; says for each whether it is zero.
#include <ginac/ginac.h>

#include <iostream>
#include <string>

int main() {
  GiNaC::symtab names;
  for (const char* name : {"u", "v", "a", "b", "c", "d"}) names[name] = GiNaC::symbol{name};
  GiNaC::parser read{names};
  std::string answers;
  for (std::string line; std::getline(std::cin, line);)
    answers += read(line).expand().is_zero() ? '1' : '0';
  std::cout << answers << "\n";
}
