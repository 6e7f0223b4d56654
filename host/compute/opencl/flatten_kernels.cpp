// Build tool: resolves the kernels' #include "..." into one source string, each file once, #line kept so that
// a build log names the file and line, and writes it as C++.
//
// usage: flatten_kernels ROOT.cl OUTPUT.cpp
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

namespace {

std::set<std::filesystem::path> seen;

void flatten(const std::filesystem::path& file, std::ostream& out) {
  seen.insert(file);
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  const auto line_mark = [&](int line) {
    out << "#line " << line << " \"kernels/" << file.filename().string() << "\"\n";
  };
  line_mark(1);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    constexpr std::string_view include = "#include \"";
    if (text == "#pragma once") {
      out << '\n';
    } else if (text.starts_with(include)) {
      const auto path = file.parent_path() / text.substr(include.size(), text.rfind('"') - include.size());
      if (!seen.contains(path)) {
        flatten(path, out);
        line_mark(line + 1);
      } else {
        out << '\n';
      }
    } else {
      out << text << '\n';
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: flatten_kernels ROOT.cl OUTPUT.cpp\n";
    return 2;
  }
  try {
    std::ofstream out(argv[2]);
    out << "#include \"host/compute/opencl/kernel_source.hpp\"\n\nnamespace brdftab {\n\nconst char "
           "kernel_source[] = R\"KERNELS(";
    flatten(argv[1], out);
    out << ")KERNELS\";\n\n}  // namespace brdftab\n";
    if (!out.flush()) throw std::runtime_error(std::string("cannot write ") + argv[2]);
  } catch (const std::exception& error) {
    std::cerr << "flatten_kernels: " << error.what() << '\n';
    return 1;
  }
}
